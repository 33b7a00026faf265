// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parts as curves and outlines as drawings, of boolean/boolean_operations.h and boolean/clip.h.
//
//   parts -> curves in doubles -> how far these are from the parts -> what is too small to be one -> drawing

#include <CGAL/Bounding_arcs_2/boolean/boolean_operations.h>
#include <CGAL/Bounding_arcs_2/boolean/clip.h>
#include <CGAL/Bounding_arcs_2/curve/Unit.h>
#include <CGAL/Bounding_arcs_2/number/stable_norm.h>
#include <CGAL/Bounding_arcs_2/number/strict_math.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

namespace {

constexpr double UP = 1 + 0x1p-40;  // for the roundings of bounds

/// Cuts a part out of a piece, in doubles. One that is shorter than these tell is straight.
/// \param from, to hold the parameters of its ends
/// \param is_reversed whether it runs against the piece
/// \param start, end its ends, which it gets bit for bit
[[nodiscard]] Bezier_curve_2<double> curve_of_part(const Bezier_curve_2<double>& piece, const Bracket& from,
                                                   const Bracket& to, bool is_reversed, const Xy<double>& start,
                                                   const Xy<double>& end) {
  const double low = (is_reversed ? to : from).middle(), high = (is_reversed ? from : to).middle();
  if (!(low < high)) return Bezier_curve_2<double>({start, end});
  Bezier_curve_2<double> part = low == 0 && high == 1 ? piece : piece.subcurve(low, high);
  if (is_reversed) part = part.reversed();
  auto points = part.control_points();
  points.front() = start;
  points.back() = end;
  return Bezier_curve_2<double>(std::move(points), part.weights());
}

/// How far the control points and the curve of subcurve(), which are computed in doubles, are from the true ones of
/// nearly the same parameters, for a piece of degree n with coordinates up to M.
///
/// It cuts twice, each time in n steps. A step takes the mean of two points, s p + t q with s rounded, and errs by
/// 3 u M: together 6 n u M. Weights of a rational piece err by 3 u of themselves in a step, by 3 k u up to the step k
/// of 2 n. Their ratio s w / (s w + t w') then errs by 2 (3 k - 1) u / 4, which moves the mean by (3 k - 1) u M, as
/// points are 2 M apart at most; two quotients, a product and two sums round by 4 u M. The sum of (3 k + 3) u M over
/// all 2 n steps is (6 n^2 + 9 n) u M. Weights with errors of 6 n u move points by 12 n u M more. Vectors are longer
/// than coordinates by sqrt 2 at most, for which 1.5 stands, and for terms of u^2 with it.
[[nodiscard]] double cutting_error(const Bezier_curve_2<double>& piece) {
  constexpr double UNDERFLOW_LOSS = 0x1p-1060;  // what some thousand products lose at most
  const double n = piece.degree(), steps = piece.is_rational() ? 6 * n * n + 21 * n : 6 * n;
  return steps * (1.5 * HALF_ULP) * coordinate_size(piece) + UNDERFLOW_LOSS;
}

[[nodiscard]] double farthest(const Bezier_curve_2<double>& curve, const Xy<double>& from) {
  double distance = 0;
  for (const Xy<double>& p : curve.control_points()) distance = (std::max)(distance, stable_norm(p - from));
  return distance * UP;
}

/// How far any point of a piece with a parameter in [low, high] may be from a point beside it, by the control points of
/// a part that holds these.
[[nodiscard]] double farthest(const Bezier_curve_2<double>& piece, double low, double high, const Xy<double>& from) {
  constexpr double BESIDE = 4 * HALF_ULP;  // cuts and their ratios round by u; ten times more is ten roundings more
  const double first = (std::max)(0.0, low - BESIDE), last = (std::min)(1.0, high + BESIDE);
  return farthest(piece.subcurve(first, last), from) + cutting_error(piece);
}

/// How far the curve of a part is from the part itself, point by point. At either end all of the part between the true
/// end and the cut is compared with the end that is given; all else moves no more than the cut's end and by rounding.
[[nodiscard]] double error_of_part(const Bezier_curve_2<double>& piece, const Outline_2::Part& part) {
  const bool back = part.is_reversed;
  const Bracket &low = back ? part.to : part.from, &high = back ? part.from : part.to;
  const Xy<double>&start = back ? part.end : part.start, &end = back ? part.start : part.end;
  if (!(low.middle() < high.middle()))  // a segment in its place
    return (std::max)(farthest(piece, low.lower, high.upper, start), farthest(piece, low.lower, high.upper, end)) * UP;
  const auto at_end = [&](const Bracket& t, const Xy<double>& control_point, const Xy<double>& p) {
    const bool is_whole = t.is_single() && (t.lower == 0 || t.lower == 1);
    return is_whole ? stable_norm(control_point - p) * UP : farthest(piece, t.lower, t.upper, p);
  };
  const double of_ends =
      (std::max)(at_end(low, piece.control_points().front(), start), at_end(high, piece.control_points().back(), end));
  return (of_ends + (low.middle() == 0 && high.middle() == 1 ? 0 : 2 * cutting_error(piece))) * UP;
}

[[nodiscard]] Bezier_curve_2<double> curve_of(const Outline_2::Part& part, const Drawing_2<double>& drawing) {
  return curve_of_part(drawing.curves()[part.curve].beziers[part.bezier], part.from, part.to, part.is_reversed,
                       part.start, part.end);
}

[[nodiscard]] bool is_on_one_line(const std::vector<Bezier_curve_2<double>>& chain) {
  using Point = Exact_predicates_inexact_constructions_kernel::Point_2;
  std::vector<Point> points;
  for (const Bezier_curve_2<double>& curve : chain)
    for (const Xy<double>& p : curve.control_points()) points.emplace_back(p.x, p.y);
  const auto other = std::find_if(points.begin(), points.end(), [&](const Point& p) { return p != points.front(); });
  return other == points.end() ||
         std::all_of(other, points.end(), [&](const Point& p) { return CGAL::collinear(points.front(), *other, p); });
}

/// Whether a closed chain bounds nothing, as it was rounded: it is on one line, or all of it is gone back.
[[nodiscard]] bool bounds_nothing(const std::vector<Bezier_curve_2<double>>& chain) {
  std::vector<const Bezier_curve_2<double>*> way;  // without what was gone back so far
  for (const Bezier_curve_2<double>& curve : chain) {
    const Bezier_curve_2<double> back = curve.reversed();
    const bool is_back = !way.empty() && way.back()->control_points() == back.control_points() &&
                         way.back()->weights() == back.weights();
    if (is_back) way.pop_back();
    else way.push_back(&curve);
  }
  return way.empty() || is_on_one_line(chain);
}

void add_chain(std::vector<Bezier_curve_2<double>> chain, Drawing_2<double>& drawing) {
  const std::string number = std::to_string(drawing.curves().size() + 1);
  drawing.add(std::move(chain), "outline " + number);
}

}  // namespace

}  // namespace CGAL::Bounding_arcs::internal

namespace CGAL::Bounding_arcs {

Bezier_curve_2<double> curve_of(const Drawing_2<double>& drawing, const Clipped_2::Part& part) {
  return internal::curve_of_part(drawing.curves()[part.curve].beziers[part.bezier], part.from, part.to, false,
                                 part.start, part.end);
}

Drawing_2<double> outline_drawing(const std::vector<const Bounding_arc_tree_2*>& trees, const Outline_2& outline) {
  Drawing_2<double> result;
  for (const Outline_2::Chain& given : outline.chains) {
    std::vector<Bezier_curve_2<double>> chain;
    for (const Outline_2::Part& part : given.parts)
      chain.push_back(internal::curve_of(part, trees.at(part.operand)->drawing()));
    internal::add_chain(std::move(chain), result);
  }
  return result;
}

Drawn_outline drawn_outline(const std::vector<const Bounding_arc_tree_2*>& trees, const Outline_2& outline,
                            const Drawn_outline::Options& options) {
  using internal::UP;
  Drawn_outline result;
  result.outline.status = outline.status;
  result.outline.undecided = outline.undecided;
  std::vector<double> roundings;  // by tree
  for (const Bounding_arc_tree_2* tree : trees) roundings.push_back(tree->rounding());
  std::vector<std::optional<std::size_t>> numbers;  // of the chains given among those drawn
  std::vector<std::optional<std::size_t>> parents;  // of the chains drawn among those given
  for (const Outline_2::Chain& given : outline.chains) {
    Outline_2::Chain chain{{}, given.is_ccw, std::nullopt};
    std::vector<Bezier_curve_2<double>> curves;
    double largest_error = 0;  // of them
    for (const Outline_2::Part& part : given.parts) {
      const Drawing_2<double>& of = trees.at(part.operand)->drawing();
      Bezier_curve_2<double> curve = internal::curve_of(part, of);
      const double error =
          internal::error_of_part(of.curves()[part.curve].beziers[part.bezier], part) + roundings[part.operand] * UP;
      const double size = internal::farthest(curve, part.start);
      const bool is_tiny = options.drops_tiny_parts && part.start == part.end && size <= error;
      result.moved = (std::max)(result.moved, (is_tiny ? error + size : error) * UP);
      if (is_tiny) continue;
      largest_error = (std::max)(largest_error, error);
      curves.push_back(std::move(curve));
      chain.parts.push_back(part);
    }
    numbers.push_back(std::nullopt);
    if (curves.empty()) continue;
    if (options.drops_tiny_parts && internal::bounds_nothing(curves)) {
      // One side of what it bounds is within an error of the way there, and so is the other one of the same way back.
      result.moved = (std::max)(result.moved, 2 * largest_error * UP);
      continue;
    }
    numbers.back() = result.outline.chains.size();
    parents.push_back(given.parent);
    result.outline.chains.push_back(std::move(chain));
    internal::add_chain(std::move(curves), result.drawing);
  }
  for (std::size_t i = 0; i < parents.size(); ++i) {
    std::optional<std::size_t> parent = parents[i];
    while (parent && !numbers[*parent]) parent = outline.chains[*parent].parent;
    if (parent) result.outline.chains[i].parent = numbers[*parent];
  }
  return result;
}

}  // namespace CGAL::Bounding_arcs
