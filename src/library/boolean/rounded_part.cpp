// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of rounded_part.h.

#include "rounded_part.h"

#include <CGAL/Bounding_arcs_2/curve/Unit.h>
#include <CGAL/Bounding_arcs_2/number/stable_norm.h>
#include <CGAL/Bounding_arcs_2/number/strict_math.h>

#include <algorithm>
#include <utility>

namespace CGAL::Bounding_arcs::internal {

Bezier_curve_2<double> curve_of_part(const Bezier_curve_2<double>& piece, const Bracket& from, const Bracket& to,
                                     bool is_reversed, const Xy<double>& start, const Xy<double>& end) {
  const double low = (is_reversed ? to : from).middle(), high = (is_reversed ? from : to).middle();
  if (!(low < high)) return Bezier_curve_2<double>({start, end});
  Bezier_curve_2<double> part = low == 0 && high == 1 ? piece : piece.subcurve(low, high);
  if (is_reversed) part = part.reversed();
  auto points = part.control_points();
  points.front() = start;
  points.back() = end;
  return Bezier_curve_2<double>(std::move(points), part.weights());
}

double farthest(const Bezier_curve_2<double>& curve, const Xy<double>& from) {
  double distance = 0;
  for (const Xy<double>& p : curve.control_points()) distance = (std::max)(distance, stable_norm(p - from));
  return distance * UP;
}

// For a piece of degree n with coordinates up to M: it cuts twice, each time in n steps. A step takes the mean of two
// points, s p + t q with s rounded, and errs by 3 u M: together 6 n u M. Weights of a rational piece err by 3 u of
// themselves in a step, by 3 k u up to the step k of 2 n. Their ratio s w / (s w + t w') then errs by 2 (3 k - 1) u /
// 4, which moves the mean by (3 k - 1) u M, as points are 2 M apart at most; two quotients, a product and two sums
// round by 4 u M. The sum of (3 k + 3) u M over all 2 n steps is (6 n^2 + 9 n) u M. Weights with errors of 6 n u move
// points by 12 n u M more. Vectors are longer than coordinates by sqrt 2 at most, for which 1.5 stands, and for terms
// of u^2 with it.
double cutting_error(const Bezier_curve_2<double>& piece) {
  constexpr double UNDERFLOW_LOSS = 0x1p-1060;  // what some thousand products lose at most
  const double n = piece.degree(), steps = piece.is_rational() ? 6 * n * n + 21 * n : 6 * n;
  return steps * (1.5 * HALF_ULP) * coordinate_size(piece) + UNDERFLOW_LOSS;
}

namespace {

/// How far any point of a piece with a parameter in [low, high] may be from a point beside it, by the control points of
/// a part that holds these.
[[nodiscard]] double farthest_of_range(const Bezier_curve_2<double>& piece, double low, double high,
                                       const Xy<double>& from) {
  constexpr double BESIDE = 4 * HALF_ULP;  // cuts and their ratios round by u; ten times more is ten roundings more
  const double first = (std::max)(0.0, low - BESIDE), last = (std::min)(1.0, high + BESIDE);
  return farthest(piece.subcurve(first, last), from) + cutting_error(piece);
}

}  // namespace

// At either end all of the part between the true end and the cut is compared with the end that is given; all else moves
// no more than the cut's end and by rounding. A straight part is a segment between its ends.
double error_of_part(const Bezier_curve_2<double>& piece, const Outline_2::Part& part, const Exact_ends& exact) {
  const auto at_end = [&](const Bracket& t, bool is_exact, const Xy<double>& p) {
    return is_exact ? 0 : farthest_of_range(piece, t.lower, t.upper, p);
  };
  const double of_ends = (std::max)(at_end(part.from, exact.start, part.start), at_end(part.to, exact.end, part.end));
  const bool is_whole = is_end_of_piece(part.from) && is_end_of_piece(part.to);
  if (is_whole || piece.degree() == 1) return of_ends * UP;
  const Bracket &low = part.is_reversed ? part.to : part.from, &high = part.is_reversed ? part.from : part.to;
  if (!(low.middle() < high.middle()))  // a segment in its place
    return (std::max)(farthest_of_range(piece, low.lower, high.upper, part.start),
                      farthest_of_range(piece, low.lower, high.upper, part.end)) *
           UP;
  return (of_ends + 2 * cutting_error(piece)) * UP;
}

double rounding_of_part(const Bezier_curve_2<double>& piece, const Outline_2::Part& part, const Exact_ends& exact) {
  const bool is_whole = is_end_of_piece(part.from) && is_end_of_piece(part.to);
  const bool is_given = exact.start && exact.end && (is_whole || piece.degree() == 1);
  return is_given ? 0 : 2 * cutting_error(piece) * UP;
}

}  // namespace CGAL::Bounding_arcs::internal
