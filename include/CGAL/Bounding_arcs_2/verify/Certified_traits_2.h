// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The option of certified regions: a boundary of rounded numbers, and by how much it must be moved outward to hold the
// exact curve.

#ifndef CGAL_BOUNDING_ARCS_2_VERIFY_CERTIFIED_TRAITS_2_H
#define CGAL_BOUNDING_ARCS_2_VERIFY_CERTIFIED_TRAITS_2_H

#include <CGAL/Bounding_arcs_2/number/number_types.h>
#include <CGAL/Bounding_arcs_2/region/Arc_region_2.h>
#include <CGAL/Bounding_arcs_2/region/Bca.h>
#include <CGAL/Bounding_arcs_2/region/thickness_bound.h>
#include <CGAL/Bounding_arcs_2/verify/outside_bound.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>

namespace CGAL::Bounding_arcs {

/// What stands for a unit in the last place near the origin, where double-doubles underflow.
inline constexpr double LEAST_ULP = 0x1p-900;

/// The widening, in units in the last place of the curve's largest coordinate, above which a region is of no use.
inline constexpr double MOST_ULPS = 64;
/// What later proofs may lose by searching in another way than the one that found a widening; the searches stop within
/// a twentieth.
inline constexpr double ROOM_OF_WIDENING = 1.25;

/// The set of points at most `widening` away from the region within `boundary`.
template <class FT> struct Certified_region_2 {
  Region_boundary_2<FT> boundary;
  double widening = 0;       ///< in units of the plane; the largest double where no useful one is known
  bool is_certified = true;  ///< the widening is at most MOST_ULPS units in the last place of the coordinates
  bool is_other = false;     ///< the region is not the method's but a BCA, which may be thicker
  double thickness =
      std::numeric_limits<double>::infinity();  ///< an upper bound of the exact region's where it is known
};

/// A certified upper bound of the exact thickness of the construction's region of [t0, t1], at most eps where that is.
/// \tparam Spiral Bezier_spiral_2
/// \complexity as sharp_thickness, which it is as a rule
template <class Construction, class Spiral>
[[nodiscard]] double certified_thickness(const Construction& construction, const Spiral& spiral, double t0, double t1,
                                         double eps) {
  const std::optional<double> sharp = sharp_thickness(construction, spiral, t0, t1);
  if (sharp && *sharp <= eps) return *sharp;
  using Exact = typename Spiral::Exact_number_type;
  const auto shape = spiral.template shape<Exact>(t0, t1, shape_parts<Construction>());
  return (std::min)(sharp.value_or(std::numeric_limits<double>::infinity()),
                    internal::bound_exactly(construction, shape, eps).upper);
}

/// Calls visit(t0, t1, region) for the region of [t0, t1] or, in curve order, for those of its halves, and of theirs,
/// until regions are at most eps thick.
/// \param room how many regions there may be beside the first; taken from
/// \param make make(t0, t1) -> a region with members `thickness` and `is_certified`; others than certified ones are not
///   halved
/// \guarantee a certified region that is visited and thicker than eps has no room: room is 0, or no double is between
///   t0 and t1
template <class Make, class Visit>
void for_each_thin_piece(double t0, double t1, double eps, std::size_t& room, const Make& make, const Visit& visit) {
  const auto region = make(t0, t1);
  const double middle = t0 + (t1 - t0) / 2;
  if (!region.is_certified || region.thickness <= eps || room == 0 || !(t0 < middle && middle < t1))
    return visit(t0, t1, region);
  --room;
  for_each_thin_piece(t0, middle, eps, room, make, visit);
  for_each_thin_piece(middle, t1, eps, room, make, visit);
}

/// A model of BoundingRegionTraits_2 with regions that hold the exact curve, whatever rounding does to their numbers.
/// \code
/// using Linear = CGAL::Simple_cartesian<double>;
/// using Kernel = CGAL::Circular_kernel_2<Linear, CGAL::Algebraic_kernel_for_circles_2_2<double>>;
/// const auto construct = Certified_traits_2<Bca_traits_2<Kernel>>().construct_certified_region_2_object();
/// const Bezier_spiral_2<double> spiral = spiral_segments(curve).front();
/// const Certified_region_2<double> region = construct(spiral, spiral.first(), spiral.last());
/// \endcode
/// \tparam Traits Bca_traits_2, Spiral_fat_arc_traits_2 or Bilens_traits_2 over a kernel with floating numbers
template <class Traits> class Certified_traits_2 : public Traits {
 public:
  using Traits::Traits;
  using FT = typename Traits::FT;
  static_assert(std::is_floating_point_v<FT>, "regions of exact numbers need no widening: use the traits themselves");

  /// spiral segment, t0, t1 -> region of the piece [t0, t1], with the boundary that Construct_region_boundary_2 makes.
  class Construct_certified_region_2 {
   public:
    explicit Construct_certified_region_2(const Traits& traits) : traits_(traits) {}

    /// \tparam Spiral Bezier_spiral_2
    /// \guarantee certified where is_certified: the region holds every point of the piece of the exact curve of the
    ///   control points, slivers past a rounded vertex or cusp included. The widening is at most 1.25 times the bound
    ///   of outside_bound, a few ulp of the largest coordinate as a rule. Where the method's own boundary would need
    ///   more than MOST_ULPS the region is the BCA's, and where that does, too, it is not certified. A BCA may be
    ///   thicker than eps: the call below gives thin regions.
    /// \complexity some ten microseconds for a cubic
    template <class Spiral>
    [[nodiscard]] Certified_region_2<FT> operator()(const Spiral& spiral, double t0, double t1) const {
      const double most = MOST_ULPS * (std::max)(ulp_of(spiral.coordinate_size()), LEAST_ULP);
      const auto parts = shape_parts<typename Traits::Construction>();
      const auto frame = spiral.template frame<FT>(t0, t1, parts);
      Certified_region_2<FT> region =
          widened(spiral, t0, t1,
                  traits_.construct_region_boundary_2_object()(traits_.construct_bounding_region_2_object()(frame)));
      if (region.widening <= most) return region;
      region = widened(spiral, t0, t1, Bca::boundary(frame));
      region.is_other = true;
      region.is_certified = region.widening <= most;
      region.widening = (std::min)(region.widening, (std::numeric_limits<double>::max)());
      return region;
    }

    /// Calls visit(t0, t1, region) for regions that are at most eps thick, with their `thickness`: that of the piece
    /// or, where it is too thick as the BCA may be, those of parts of the piece in curve order.
    /// \guarantee each as above. What is visited is thicker than eps only where it is not certified, where no double is
    ///   between t0 and t1, or behind a million parts
    template <class Spiral, class Visit>
    void operator()(const Spiral& spiral, double t0, double t1, double eps, const Visit& visit) const {
      std::size_t room = 1'000'000;
      const auto make = [&](double from, double to) {
        Certified_region_2<FT> region = (*this)(spiral, from, to);
        region.thickness = region.is_other ? certified_thickness(Bca(), spiral, from, to, eps)
                                           : certified_thickness(traits_.construction(), spiral, from, to, eps);
        return region;
      };
      for_each_thin_piece(t0, t1, eps, room, make, visit);
    }

   private:
    template <class Spiral>
    [[nodiscard]] static Certified_region_2<FT> widened(const Spiral& spiral, double t0, double t1,
                                                        const Region_boundary_2<FT>& boundary) {
      return {boundary, ROOM_OF_WIDENING * outside_bound(spiral, t0, t1, boundary, unit_roundoff(boundary))};
    }

    // Half a unit in the last place of the largest coordinate of the ends: no need to be closer than that.
    [[nodiscard]] static double unit_roundoff(const Region_boundary_2<FT>& b) {
      const Xy<FT>&p = b.inner[0].from, &q = b.inner[b.inner.size() - 1].to;
      const FT size = (std::max)({std::fabs(p.x), std::fabs(p.y), std::fabs(q.x), std::fabs(q.y)});
      return static_cast<double>(size * std::numeric_limits<FT>::epsilon() / 2);
    }

    Traits traits_;
  };

  [[nodiscard]] Construct_certified_region_2 construct_certified_region_2_object() const {
    return Construct_certified_region_2(*this);
  }
};

/// The set of points at most `widening` away from a region in hand.
struct Certified_arcs_2 {
  Arc_region_2 region;
  double thickness = 0;      ///< a certified upper bound of the exact region's
  double widening = 0;       ///< in units of the plane; infinite where none is known
  bool is_certified = true;  ///< the widening is at most MOST_ULPS units in the last place of the coordinates
  bool is_other = false;     ///< the region is not the one that was asked for but a BCA
};

/// Certifies the region of the piece [t0, t1], and steps back to its BCA where the widening is above MOST_ULPS ulp.
/// That BCA may be thicker than eps, see for_each_thin_piece.
/// \param thickness of the construction's region, an upper bound
/// \param arcs arcs(construction) -> the region of the piece that a construction makes, in hand
/// \guarantee the region, widened, holds every point of the piece of the exact curve of the control points, slivers
///   past a rounded vertex or cusp included. The widening is at most 1.25 times the bound of outside_bound.
/// \complexity some ten microseconds for a cubic
template <class Construction, class Spiral, class Arcs>
[[nodiscard]] Certified_arcs_2 certified_arcs(const Construction& construction, const Spiral& spiral, double t0,
                                              double t1, double eps, double thickness, const Arcs& arcs) {
  const double ulp = (std::max)(ulp_of(spiral.coordinate_size()), LEAST_ULP), most = MOST_ULPS * ulp;
  const auto certified = [&](const Arc_region_2& r, double thick) {
    const double widening = ROOM_OF_WIDENING * outside_bound(spiral, t0, t1, boundary_of(r), ulp / 2);
    return Certified_arcs_2{r, thick, widening, widening <= most};
  };
  const Certified_arcs_2 own = certified(arcs(construction), thickness);
  if (own.is_certified && own.thickness <= eps) return own;
  Certified_arcs_2 other = certified(arcs(Bca()), certified_thickness(Bca(), spiral, t0, t1, eps));
  other.is_other = true;
  if (other.is_certified && other.thickness <= eps) return other;
  if (own.is_certified != other.is_certified) return own.is_certified ? own : other;
  if (own.is_certified) return other.thickness < own.thickness ? other : own;
  return other.widening < own.widening && other.thickness <= eps ? other : own;
}

}  // namespace CGAL::Bounding_arcs

#endif
