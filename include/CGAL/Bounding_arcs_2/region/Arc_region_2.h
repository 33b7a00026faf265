// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A region in hand: its arcs in doubles, as they are kept, handed out and written.  A side is points and bulges, p0, b,
// [joint, b,] p1; a bulge is the tangent of a quarter of the angle that an arc turns through, positive for a left turn,
// 0 for a segment, so that nothing is large where an arc is flat.

#ifndef CGAL_BOUNDING_ARCS_2_REGION_ARC_REGION_2_H
#define CGAL_BOUNDING_ARCS_2_REGION_ARC_REGION_2_H

#include <CGAL/Bounding_arcs_2/frame/Chord_frame_2.h>
#include <CGAL/Bounding_arcs_2/number/Mpfr_interval.h>
#include <CGAL/Bounding_arcs_2/region/Bca.h>
#include <CGAL/Bounding_arcs_2/region/Contact_circle_2.h>
#include <CGAL/Bounding_arcs_2/region/thickness_bound.h>

#include <cmath>
#include <cstddef>
#include <iosfwd>
#include <limits>

namespace CGAL::Bounding_arcs {

/// A region's two sides in doubles, from the piece's start to its end; inner is the side of the centers of curvature.
/// \code
/// Region_reader reader(regions);  // a tree with an eps, over doubles
/// reader.for_each_leaf([](const auto&, const Arc_region_2& region) {
///   std::cout << region.from.x << ' ' << region.inner.bulges[0] << ' ' << region.outer.bulges[0] << '\n';
/// });
/// \endcode
struct Arc_region_2 {
  /// One side of a region between the region's ends: one arc with `bulges[0]`, or two that meet in `joint`.
  struct Side {
    std::size_t size = 1;   ///< 1 or 2 arcs
    double bulges[2] = {};  ///< in [-1, 1]
    Xy<double> joint = {};  ///< of two arcs
  };

  Xy<double> from, to;
  Side inner, outer;
  Region_form form = Region_form::BCA;  ///< the outer side of a spiral fat arc has a corner, other sides are smooth
  double widening = std::numeric_limits<double>::infinity();  ///< the exact curve is within it of the region; infinite:
                                                              ///< not known

  /// Whether bulges and joints are numbers.
  [[nodiscard]] bool is_finite() const {
    const auto is_finite_side = [](const Side& s) {
      return std::isfinite(s.bulges[0]) && (s.size == 1 || std::isfinite(s.bulges[1] + s.joint.x + s.joint.y));
    };
    return is_finite_side(inner) && is_finite_side(outer);
  }
};

/// Writes a region as `from.x from.y inner outer to.x to.y widening`, on the line, with 17 digits. A side is
/// `bulge` or, of two arcs, `bulge joint.x joint.y bulge`, in brackets: `0 0 [0.25] [0.5 1 -1 0.125] 2 0 1e-15`.
std::ostream& operator<<(std::ostream& out, const Arc_region_2& region);

/// The arc that two points and a bulge define: over a chord D it leaves its start along D turned by -2 atan b,
/// (1 - b^2) D - 2 b perp(D) over (1 + b^2), with curvature 4 b / ((1 + b^2) |D|).
template <class NT>
[[nodiscard]] Boundary_piece_2<NT> piece_on_chord(const Xy<NT>& from, const Xy<NT>& to, const NT& b) {
  const Xy<NT> chord = to - from, tangent = NT(NT(1) - b * b) * chord - NT(NT(2) * b) * perp(chord);
  return {from, to, {from, perp(tangent), NT(NT(4) * b)}};
}

/// The boundary that a region's points and bulges define.
[[nodiscard]] inline Region_boundary_2<double> boundary_of(const Arc_region_2& region) {
  const auto chain = [&](const Arc_region_2::Side& side) {
    if (side.size == 1) return Boundary_chain_2<double>(piece_on_chord(region.from, region.to, side.bulges[0]));
    return Boundary_chain_2<double>(piece_on_chord(region.from, side.joint, side.bulges[0]),
                                    piece_on_chord(side.joint, region.to, side.bulges[1]));
  };
  return {chain(region.inner), chain(region.outer), region.form};
}

/// A boundary in doubles.
/// \param local the boundary seen from the piece's start, in units of `unit`
/// \param from, to the piece's ends as its neighbours have them
/// \param rounded a number of the boundary -> the double that stands for it
template <class NT, class Round>
[[nodiscard]] Arc_region_2 arc_region(const Region_boundary_2<NT>& local, double unit, const Xy<double>& from,
                                      const Xy<double>& to, const Round& rounded) {
  const auto side = [&](const Boundary_chain_2<NT>& chain, bool is_smooth) {
    Arc_region_2::Side s;
    s.size = chain.size();
    for (std::size_t i = 0; i < s.size; ++i) s.bulges[i] = rounded(bulge(chain, i, is_smooth));
    if (s.size == 2) s.joint = from + unit * Xy<double>{rounded(chain[0].to.x), rounded(chain[0].to.y)};
    return s;
  };
  const bool has_corner = local.form == Region_form::SPIRAL_FAT_ARC;
  Arc_region_2 region{from, to, side(local.inner, true), side(local.outer, !has_corner)};
  region.form = local.form;
  return region;
}

/// The region of a piece with its exact boundary, rounded: square roots are MPFR intervals narrow enough for doubles,
/// which do without an expression's search for the sign of numbers that are 0.
/// \param bits of the first intervals; there are more until they tell the region's form, up to 8192
/// \throws CGAL::Uncertain_conversion_exception where these do not
/// \tparam Spiral one with exact shapes that have enclosures
template <class Construction, class Spiral>
[[nodiscard]] Arc_region_2 rounded_region(const Construction& construction, const Spiral& spiral, double t0, double t1,
                                          const Xy<double>& from, const Xy<double>& to, mpfr_prec_t bits = 512) {
  using Exact = typename Spiral::Exact_number_type;
  auto shape = spiral.template shape<Exact>(t0, t1, shape_parts<Construction>());
  const double unit = CGAL::to_double(shape.unit);
  shape.unit = 1;
  constexpr mpfr_prec_t LAST = 8192;
  for (;; bits *= 2) {
    const auto interval = [&](const Exact& x) { return Mpfr_interval(x, bits); };
    try {
      const auto local = construction.boundary(shape.template over<Mpfr_interval>(interval).at_origin());
      return arc_region(local, unit, from, to, [](const Mpfr_interval& x) { return x.middle(); });
    } catch (const CGAL::Uncertain_conversion_exception&) {
      if (bits >= LAST) throw;
    }
  }
}

/// The region of a piece by itself: the construction's boundary seen from the piece's start and in units of its shape,
/// so that nothing leaves the range of doubles; but for products of differences, where ends are 2^500 times as long as
/// others: there it is rounded_region. Where there are no exact shapes, or 8192 bits are too few, it is a BCA, which
/// may be thicker.
/// \param from, to the piece's ends as its neighbours have them
/// \guarantee bulges some u times the larger of themselves and their share of a side's length
template <class Construction, class Spiral>
[[nodiscard]] Arc_region_2 arc_region(const Construction& construction, const Spiral& spiral, double t0, double t1,
                                      const Xy<double>& from, const Xy<double>& to) {
  Chord_shape_2<double> shape = [&] {
    constexpr auto parts = shape_parts<Construction>;
    if constexpr (has_accurate_shape_v<Spiral>) return spiral.accurate_shape(t0, t1, parts());
    else return spiral.template shape<double>(t0, t1, parts());
  }();
  const double unit = shape.unit;
  shape.unit = 1;
  const auto region_of = [&](const auto& c) {
    return arc_region(c.boundary(shape.at_origin()), unit, from, to, [](double x) { return x; });
  };
  Arc_region_2 region = region_of(construction);
  if (region.is_finite()) return region;
  if constexpr (has_enclosures_v<typename Spiral::Exact_number_type>) {
    constexpr mpfr_prec_t BITS = 4096;  // products of four lengths in a row, each 2^500 times the next
    try {
      region = rounded_region(construction, spiral, t0, t1, from, to, BITS);
      if (region.is_finite()) return region;
    } catch (const CGAL::Uncertain_conversion_exception&) {  // too few bits
    }
  }
  return region_of(Bca());
}

}  // namespace CGAL::Bounding_arcs

#endif
