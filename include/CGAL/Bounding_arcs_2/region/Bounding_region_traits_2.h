// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The model of BoundingRegionTraits_2 (doc/concepts.md) for one construction over one circular kernel.

#ifndef CGAL_BOUNDING_ARCS_2_REGION_BOUNDING_REGION_TRAITS_2_H
#define CGAL_BOUNDING_ARCS_2_REGION_BOUNDING_REGION_TRAITS_2_H

#include <CGAL/Bounding_arcs_2/frame/Chord_frame_2.h>
#include <CGAL/Bounding_arcs_2/number/Root_number.h>
#include <CGAL/Bounding_arcs_2/number/convert.h>
#include <CGAL/Bounding_arcs_2/number/number_types.h>
#include <CGAL/Bounding_arcs_2/region/Contact_circle_2.h>
#include <CGAL/Bounding_arcs_2/region/Kernel_boundary.h>
#include <CGAL/Bounding_arcs_2/region/Region_outline_2.h>
#include <CGAL/Bounding_arcs_2/region/thickness_bound.h>

#include <CGAL/Bbox_2.h>

#include <type_traits>
#include <utility>

namespace CGAL::Bounding_arcs {

// Axis-aligned boxes of regions, without centers: end points, and the height of an arc where it turns past an axis.

namespace internal {
/// \guarantee holds the exact arc or segment
template <class NT> [[nodiscard]] CGAL::Bbox_2 bbox_of_piece(const Boundary_piece_2<NT>& piece) {
  using Interval = CGAL::Interval_nt<true>;
  const Xy<Interval> p = convert<Interval>(piece.from), q = convert<Interval>(piece.to);
  const CGAL::Bbox_2 ends = CGAL::Bbox_2(p.x.inf(), p.y.inf(), p.x.sup(), p.y.sup()) +
                            CGAL::Bbox_2(q.x.inf(), q.y.inf(), q.x.sup(), q.y.sup());
  if (piece.is_segment()) return ends;
  // height = (c^2/4) kappa / (1 + sqrt(1 - kappa^2 c^2/4)) <= (c^2/4) kappa / 1 for an arc of at most half a circle
  const Xy<Interval> n = convert<Interval>(piece.support.normal);
  const Interval kappa = CGAL::abs(convert<Interval>(piece.support.curvature)) / CGAL::sqrt(dot(n, n));
  const double height = (dot(q - p, q - p) / Interval(4) * kappa).sup();
  // Does the tangent turn past an axis? With v = end - point the normal there is n - curvature v.
  const Xy<NT> a = piece.support.normal_at(piece.from), b = piece.support.normal_at(piece.to);
  const double wide_x = sign_of(a.y) == sign_of(b.y) && sign_of(a.y) != 0 ? 0 : height;
  const double wide_y = sign_of(a.x) == sign_of(b.x) && sign_of(a.x) != 0 ? 0 : height;
  const Interval x0 = Interval(ends.xmin()) - Interval(wide_x), x1 = Interval(ends.xmax()) + Interval(wide_x);
  const Interval y0 = Interval(ends.ymin()) - Interval(wide_y), y1 = Interval(ends.ymax()) + Interval(wide_y);
  return CGAL::Bbox_2(x0.inf(), y0.inf(), x1.sup(), y1.sup());
}

/// A box that holds both boundaries, of a Region_boundary_2 or a Region_outline_2.
/// \guarantee certified where the boundary's coordinates and signs are exact; not the smallest box
template <class Boundary> [[nodiscard]] CGAL::Bbox_2 bbox_of_region(const Boundary& region) {
  CGAL::Bbox_2 box;
  for (const auto& piece : region.inner) box += bbox_of_piece(piece);
  for (const auto& piece : region.outer) box += bbox_of_piece(piece);
  return box;
}
}  // namespace internal

/// Whether a construction's thickness is a function of the frame instead of the shape.
template <class Construction, class NT, class = void> inline constexpr bool thickness_needs_place_v = false;
template <class Construction, class NT>
inline constexpr bool thickness_needs_place_v<
    Construction, NT,
    std::void_t<decltype(std::declval<const Construction&>().thickness(std::declval<const Chord_frame_2<NT>&>()))>> =
    true;

namespace internal {
/// The thickness of the region over a frame: of its shape alone, but for constructions whose formulas depend on the
/// place.
template <class Construction, class NT>
[[nodiscard]] NT thickness_in_place(const Construction& construction, const Chord_frame_2<NT>& frame) {
  if constexpr (thickness_needs_place_v<Construction, NT>) return construction.thickness(frame);
  else return construction.thickness(frame.shape);
}
}  // namespace internal

/// Traits of one construction over one circular kernel: what Bca_traits_2, Bilens_traits_2 and Spiral_fat_arc_traits_2
/// are.
/// \tparam CircularKernel a CGAL::Circular_kernel_2 over any linear kernel; for a fundamental number type include
///   <CGAL/Root_of_traits.h> before it (the umbrella header does)
/// \tparam Construction Bca, Spiral_fat_arc, Bilens, or one of them wrapped in a fallback policy
template <class CircularKernel, class Construction_> class Bounding_region_traits_2 {
 public:
  using Kernel = CircularKernel;
  using Construction = Construction_;
  using FT = typename Kernel::FT;
  using Chord_frame = Chord_frame_2<FT>;
  static constexpr bool HAS_SQUARE_ROOT = has_square_root_v<FT>;
  /// True where decisions are exact although constructions are not (Exact_predicates_inexact_constructions_kernel).
  static constexpr bool HAS_EXACT_DECISIONS = has_exact_decisions_v<Kernel>;
  /// FT, or CORE::Expr where FT has no square root: then include <CGAL/CORE_Expr.h> to compute it.
  using Thickness = std::conditional_t<HAS_SQUARE_ROOT, FT, CORE::Expr>;
  using Boundary = Kernel_boundary_2<Kernel>;

  explicit Bounding_region_traits_2(const Construction& construction = {}) : construction_(construction) {}
  [[nodiscard]] const Construction& construction() const { return construction_; }

  /// A region: the frame it was made from.
  struct Bounding_region_2 {
    Chord_frame frame;
  };

  /// frame -> region
  struct Construct_bounding_region_2 {
    [[nodiscard]] Bounding_region_2 operator()(const Chord_frame& frame) const { return {frame}; }
  };

  /// region -> thickness: an upper bound of the one-sided distance between the two boundaries.
  /// \guarantee exact where Thickness is; over floating types see thickness_bound
  struct Compute_thickness_2 {
    Construction construction;
    [[nodiscard]] Thickness operator()(const Bounding_region_2& region) const {
      if constexpr (HAS_SQUARE_ROOT) return internal::thickness_in_place(construction, region.frame);
      else return internal::thickness_in_place(construction, region.frame.template over<Root_number>()).expression();
    }
  };

  /// region, eps -> SMALLER, EQUAL or LARGER: the thickness against eps.
  /// \guarantee exact over exact kernels, by an interval where that decides
  struct Compare_thickness_2 {
    Construction construction;
    [[nodiscard]] CGAL::Comparison_result operator()(const Bounding_region_2& region, double eps) const {
      if constexpr (!std::is_floating_point_v<FT>) {
        const auto range = internal::thickness_interval(construction, region.frame.shape);
        if (range.sup() < eps) return CGAL::SMALLER;
        if (range.inf() > eps) return CGAL::LARGER;
      }
      using Root = std::conditional_t<HAS_SQUARE_ROOT, FT, Root_number>;
      const Root thickness = internal::thickness_in_place(construction, region.frame.template over<Root>()),
                 bound = Root(eps);
      return thickness < bound ? CGAL::SMALLER : (bound < thickness ? CGAL::LARGER : CGAL::EQUAL);
    }
  };

  /// A source of shapes, eps -> whether the thickness is within eps, and a double that bounds it from above.
  /// A source has `template <class NT> Chord_shape_2<NT> shape(const Shape_parts&) const` (concept ChordShapeSource).
  struct Bound_thickness_2 {
    Construction construction;
    template <class ShapeSource> [[nodiscard]] Thickness_bound operator()(const ShapeSource& source, double eps) const {
      return bound_thickness<FT, HAS_EXACT_DECISIONS>(construction, source, eps);
    }
  };

  /// region -> boundary in the library's own pieces, a Region_boundary_2 or a Region_outline_2; over FT without square
  /// roots only where the construction has none.
  struct Construct_region_boundary_2 {
    Construction construction;
    [[nodiscard]] auto operator()(const Bounding_region_2& region) const {
      static_assert(HAS_SQUARE_ROOT || !Construction::BOUNDARY_NEEDS_SQUARE_ROOT,
                    "this region's joints are not rational: use Construct_boundary_2, or a kernel over a field with "
                    "square roots such as CORE::Expr");
      return construction.boundary(region.frame);
    }
  };

  /// region -> boundary as Circular_arc_2 and Line_arc_2, each with the direction in which the boundary runs.
  struct Construct_boundary_2 {
    Construction construction;
    [[nodiscard]] Boundary operator()(const Bounding_region_2& region) const {
      if constexpr (HAS_SQUARE_ROOT || !Construction::BOUNDARY_NEEDS_SQUARE_ROOT) {
        const auto b = construction.boundary(region.frame);
        return {internal::kernel_chain<Kernel>(b.inner), internal::kernel_chain<Kernel>(b.outer)};
      } else {
        return construction.template algebraic_boundary<Kernel>(region.frame);
      }
    }
  };

  /// region, point -> ON_BOUNDED_SIDE, ON_BOUNDARY or ON_UNBOUNDED_SIDE.
  struct Bounded_side_2 {
    Construction construction;
    [[nodiscard]] CGAL::Bounded_side operator()(const Bounding_region_2& region,
                                                const typename Kernel::Point_2& p) const {
      return bounded_side(Construct_region_boundary_2{construction}(region), Xy<FT>{p.x(), p.y()});
    }
  };

  /// region -> a box that holds it.
  struct Construct_bbox_2 {
    Construction construction;
    [[nodiscard]] CGAL::Bbox_2 operator()(const Bounding_region_2& region) const {
      return internal::bbox_of_region(Construct_region_boundary_2{construction}(region));
    }
  };

  [[nodiscard]] Construct_bounding_region_2 construct_bounding_region_2_object() const { return {}; }
  [[nodiscard]] Compute_thickness_2 compute_thickness_2_object() const { return {construction_}; }
  [[nodiscard]] Compare_thickness_2 compare_thickness_2_object() const { return {construction_}; }
  [[nodiscard]] Bound_thickness_2 bound_thickness_2_object() const { return {construction_}; }
  [[nodiscard]] Construct_region_boundary_2 construct_region_boundary_2_object() const { return {construction_}; }
  [[nodiscard]] Construct_boundary_2 construct_boundary_2_object() const { return {construction_}; }
  [[nodiscard]] Bounded_side_2 bounded_side_2_object() const { return {construction_}; }
  [[nodiscard]] Construct_bbox_2 construct_bbox_2_object() const { return {construction_}; }

 private:
  Construction construction_;
};

}  // namespace CGAL::Bounding_arcs

#endif
