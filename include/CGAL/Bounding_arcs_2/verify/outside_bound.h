// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far an exact curve piece leaves the region within a boundary of floating numbers, proven from above.

#ifndef CGAL_BOUNDING_ARCS_2_VERIFY_OUTSIDE_BOUND_H
#define CGAL_BOUNDING_ARCS_2_VERIFY_OUTSIDE_BOUND_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/frame/Taylor_table.h>
#include <CGAL/Bounding_arcs_2/number/Double_double.h>
#include <CGAL/Bounding_arcs_2/number/Exact_number.h>
#include <CGAL/Bounding_arcs_2/region/Contact_circle_2.h>

#include <CGAL/Exact_rational.h>

#include <functional>
#include <type_traits>

namespace CGAL::Bounding_arcs {
namespace verify {

/// What the numbers of a boundary count from: the origin of the plane, or the start of the piece, so that it is rounded
/// by its own size and not by that of the coordinates.
enum class Boundary_origin { PLANE, PIECE };

}  // namespace verify

namespace internal {

/// A number over NT, an exact type or, of a floating number, Double_double: without error.
template <class NT, class Source> [[nodiscard]] NT number_from(const Source& x) {
  if constexpr (!std::is_same_v<NT, Double_double>) {
    return Exact_number<Source>::make(x);
  } else {
    const double high = static_cast<double>(x);
    return Double_double(high, static_cast<double>(x - high), 0);
  }
}
template <class NT, class Source> [[nodiscard]] Xy<NT> number_from(const Xy<Source>& p) {
  return {number_from<NT>(p.x), number_from<NT>(p.y)};
}

/// A piece of a spiral segment as proofs see it: its tables and the first control point, in doubles with error bounds
/// and, where these are asked for, in exact numbers. It refers to the segment.
struct Proven_piece {
  double t0, t1;
  const Taylor_table<Double_double>& rough_table;
  std::function<const Taylor_table<Exact_rational>&()> exact_table;
  Xy<Double_double> rough_first;
  std::function<Xy<Exact_rational>()> exact_first;

  template <class Spiral>
  Proven_piece(const Spiral& spiral, double begin, double end)
      : t0(begin), t1(end), rough_table(spiral.template table<Double_double>()),
        exact_table([&spiral]() -> const auto& { return spiral.exact_table(); }),
        exact_first([&spiral] { return number_from<Exact_rational>(spiral.curve().control_points().front()); }) {
    const auto& p = spiral.curve().control_points().front();
    if constexpr (std::is_floating_point_v<std::decay_t<decltype(p.x)>>) rough_first = number_from<Double_double>(p);
    else rough_first = convert<Double_double>(exact_first());
  }

  template <class NT> [[nodiscard]] const Taylor_table<NT>& table() const {
    if constexpr (std::is_same_v<NT, Double_double>) return rough_table;
    else return exact_table();
  }
  template <class NT> [[nodiscard]] Xy<NT> first() const {
    if constexpr (std::is_same_v<NT, Double_double>) return rough_first;
    else return exact_first();
  }
};

/// See outside_bound. Compiled for float, double and long double.
template <class FT>
[[nodiscard]] double proven_bound(const Proven_piece& piece, const Region_boundary_2<FT>& boundary, double goal,
                                  verify::Boundary_origin origin);
/// See is_within.
template <class FT>
[[nodiscard]] bool is_proven_within(const Proven_piece& piece, const Region_boundary_2<FT>& boundary, double widening);

}  // namespace internal

/// A proven upper bound of the largest distance of a point of the curve piece [t0, t1] from the region that a boundary
/// encloses.  The curve is the exact one of its control points, the boundary's numbers are taken for what they are. The
/// region holds the arcs themselves, their end points, and what lies between the normals at the ends, at each place on
/// the inner side of the outer chain and on the outer side of the inner chain; a joint's normal is that of the first of
/// its two circles.
/// \param boundary over float, double or long double
/// \param goal a distance below which the bound need not be any better
/// \param origin what the boundary's numbers count from
/// \return the bound in units of the plane; 0 where the piece is in the region; infinity where a number of the
///   boundary is not finite or no bound is found
/// \guarantee certified; about a tenth above the least such bound, but for boundaries whose arcs are far from one
///   another at joints and ends
/// \complexity some ten microseconds for a cubic where double-doubles decide, some milliseconds in rational arithmetic
template <class Spiral, class FT>
[[nodiscard]] double outside_bound(const Spiral& spiral, double t0, double t1, const Region_boundary_2<FT>& boundary,
                                   double goal = 0, verify::Boundary_origin origin = verify::Boundary_origin::PLANE) {
  static_assert(std::is_floating_point_v<FT>,
                "boundaries of floating numbers only: exact ones are proven by verify_region");
  return internal::proven_bound({spiral, t0, t1}, boundary, goal, origin);
}

/// Whether every point of the piece is proven to be at most `widening` away from the region: that the Minkowski sum of
/// the region and a disc of that radius holds the piece.
/// \guarantee true is a proof; false means disproved or undecided, in rational arithmetic
template <class Spiral, class FT>
[[nodiscard]] bool is_within(const Spiral& spiral, double t0, double t1, const Region_boundary_2<FT>& boundary,
                             double widening) {
  return internal::is_proven_within({spiral, t0, t1}, boundary, widening);
}

}  // namespace CGAL::Bounding_arcs

#endif
