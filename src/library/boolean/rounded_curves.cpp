// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of rounded_curves.h.

#include "rounded_curves.h"

#include <CGAL/Bounding_arcs_2/curve/Unit.h>
#include <CGAL/Bounding_arcs_2/number/stable_norm.h>
#include <CGAL/Bounding_arcs_2/number/strict_math.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace CGAL::Bounding_arcs::internal {

Bezier_curve_2<double> curve_of_part(const Bezier_curve_2<double>& piece, const Outline_2::Part& part) {
  const double low = (part.is_reversed ? part.to : part.from).middle(),
               high = (part.is_reversed ? part.from : part.to).middle();
  if (!(low < high)) return Bezier_curve_2<double>({part.start, part.end});
  Bezier_curve_2<double> curve = low == 0 && high == 1 ? piece : piece.subcurve(low, high);
  if (part.is_reversed) curve = curve.reversed();
  auto points = curve.control_points();
  points.front() = part.start;
  points.back() = part.end;
  return Bezier_curve_2<double>(std::move(points), curve.weights());
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
  return steps * (1.5 * HALF_ULP) * piece.coordinate_size() + UNDERFLOW_LOSS;
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
Part_errors errors_of_part(const Bezier_curve_2<double>& piece, const Outline_2::Part& part, const Exact_ends& exact) {
  const auto at_end = [&](const Bracket& t, bool is_exact, const Xy<double>& p) {
    return is_exact ? 0 : farthest_of_range(piece, t.lower, t.upper, p);
  };
  const double of_ends = (std::max)(at_end(part.from, exact.start, part.start), at_end(part.to, exact.end, part.end)),
               of_cuts = 2 * cutting_error(piece);
  const bool is_uncut = piece.degree() == 1 || (is_end_of_piece(part.from) && is_end_of_piece(part.to));
  if (is_uncut) return {of_ends * UP, exact.start && exact.end ? 0 : of_cuts * UP};
  const Bracket &low = part.is_reversed ? part.to : part.from, &high = part.is_reversed ? part.from : part.to;
  if (low.middle() < high.middle()) return {(of_ends + of_cuts) * UP, of_cuts * UP};
  const double of_segment = (std::max)(farthest_of_range(piece, low.lower, high.upper, part.start),
                                       farthest_of_range(piece, low.lower, high.upper, part.end));
  return {of_segment * UP, of_cuts * UP};
}

namespace {

/// The distance point by point, in parameters that run alike.
///
/// Weights times f^i for the control points i are those of the same curve in another parameter. Let weights of b be
/// those of a times c f^i (1 + d_i) with |d_i| <= d. A control point's share of a point of b is then that of a times a
/// factor from (1 - d) / (1 + d) to (1 + d) / (1 - d). Shares differ by 2 d / (1 - d) in sum, and move a point by that
/// times the size of b.
[[nodiscard]] double distance_of_control_points(const Bezier_curve_2<double>& a, const Bezier_curve_2<double>& b) {
  constexpr double NONE = std::numeric_limits<double>::infinity();
  if (a.degree() != b.degree()) return NONE;
  const int n = a.degree();
  double distance = 0;
  for (std::size_t i = 0; i < a.control_points().size(); ++i)
    distance = (std::max)(distance, stable_norm(a.control_points()[i] - b.control_points()[i]));
  if (a.weights() == b.weights()) return distance * UP;
  const auto ratio = [&](int i) { return b.weight(i) / a.weight(i); };
  const double first = ratio(0), factor = std::pow(ratio(n) / first, 1.0 / n);
  double uneven = (16 + 4 * n) * HALF_ULP;  // of quotients and powers
  for (int i = 1; i <= n; ++i)
    uneven = (std::max)(uneven, std::fabs(1 - ratio(i) / (first * std::pow(factor, i))) + (16 + 4 * n) * HALF_ULP);
  if (!(uneven < 0.25)) return NONE;
  return (distance + 2 * uneven / (1 - uneven) * farthest(b, b.control_points().front())) * UP;
}

/// Both curves go along a segment: a point of one has a foot on it, and the other crosses the line there.
[[nodiscard]] double distance_by_segment(const Bezier_curve_2<double>& a, const Bezier_curve_2<double>& b) {
  const Xy<double>&from = a.control_points().front(), &to = a.control_points().back();
  const double of_ends =
      (std::max)(stable_norm(from - b.control_points().front()), stable_norm(to - b.control_points().back()));
  return (distance_from_segment(a, from, to) + distance_from_segment(b, from, to) + of_ends) * UP;
}

}  // namespace

double distance_from_segment(const Bezier_curve_2<double>& curve, const Xy<double>& from, const Xy<double>& to) {
  const Xy<double> way = to - from;
  const double length = stable_norm(way);
  double distance = 0;
  for (const Xy<double>& p : curve.control_points()) {
    const Xy<double> at = p - from;
    double along = 0, beside = stable_norm(at);
    if (length > 0) {
      const double s = dot(at, way) / length;
      along = (std::max)({0.0, -s, s - length});
      beside = std::fabs(cross(at, way)) / length;
    }
    distance = (std::max)(distance, along + beside);
  }
  // three roundings of vectors, and products of unit vectors with them
  return (distance + (length > 0 ? 8 * HALF_ULP * (farthest(curve, from) + length) : 0)) * UP;
}

double distance_bound(const Bezier_curve_2<double>& a, const Bezier_curve_2<double>& b) {
  return (std::min)(distance_of_control_points(a, b), distance_by_segment(a, b));
}

double distance_bound(const std::vector<Bezier_curve_2<double>>& a, const std::vector<Bezier_curve_2<double>>& b,
                      double most) {
  constexpr double NONE = std::numeric_limits<double>::infinity();
  std::size_t i = 0, k = 0;
  Bezier_curve_2<double> p = a.front(), q = b.front();  // what is left of a[i] and b[k]
  double distance = 0, of_cuts = 0;
  while (distance <= most) {
    const bool is_p_last = i + 1 == a.size(), is_q_last = k + 1 == b.size();
    const Xy<double>&p_end = p.control_points().back(), &q_end = q.control_points().back();
    if (is_p_last == is_q_last && (is_p_last || stable_norm(p_end - q_end) <= most)) {
      distance = (std::max)(distance, distance_bound(p, q));
      if (is_p_last) break;
      p = a[++i];
      q = b[++k];
      continue;
    }
    // cuts one where the other ends
    const auto is_cut = [&](Bezier_curve_2<double>& whole, const Bezier_curve_2<double>& other) {
      const Xy<double>& end = other.control_points().back();
      const double t = parameter_near(whole, end);
      if (t == 0 || t == 1 || !(stable_norm(whole.point(t) - end) <= most)) return false;
      of_cuts = (std::max)(of_cuts, cutting_error(whole));
      auto [head, tail] = whole.split(t);
      distance = (std::max)(distance, distance_bound(head, other));
      whole = std::move(tail);
      return true;
    };
    if (!is_q_last && is_cut(p, q)) q = b[++k];
    else if (!is_p_last && is_cut(q, p)) p = a[++i];
    else return NONE;
  }
  return (distance + of_cuts) * UP;
}

double parameter_near(const Bezier_curve_2<double>& curve, const Xy<double>& p) {
  constexpr int STEPS = 8;  // where curves nearly are one, the first step is near
  const Xy<double> way = curve.control_points().back() - curve.control_points().front();
  const double n = curve.degree(), whole = dot(way, way);
  double t = whole > 0 ? std::clamp(dot(p - curve.control_points().front(), way) / whole, 0.0, 1.0) : 0.5;
  for (int i = 0; i < STEPS; ++i) {
    // the derivative is n times the last edge of the part before t, over t; or the first one of that behind it
    const bool has_head = t > 0.5;
    const auto [head, tail] = curve.split(t);
    const Bezier_curve_2<double>& part = has_head ? head : tail.reversed();
    const auto& points = part.control_points();
    const int d = part.degree();
    const double w = part.weight(d - 1) / part.weight(d);
    const Xy<double> rate = (n * w / (has_head ? t : t - 1)) * (points.back() - points[points.size() - 2]);
    const double square = dot(rate, rate);
    if (!(square > 0)) break;
    const double next = std::clamp(t + dot(p - points.back(), rate) / square, 0.0, 1.0);
    const bool is_there = std::fabs(next - t) <= HALF_ULP * t;
    t = next;
    if (is_there) break;
  }
  return t;
}

}  // namespace CGAL::Bounding_arcs::internal
