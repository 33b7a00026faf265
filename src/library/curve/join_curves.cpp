// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Joints.h"

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/curve/Unit.h>
#include <CGAL/Bounding_arcs_2/curve/join_curves.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace CGAL::Bounding_arcs {
namespace {

using internal::joints::Curve, internal::joints::Joints, internal::joints::NO_END, internal::joints::Piece,
    internal::joints::Point, internal::joints::Reach;
using internal::joints::end_behind, internal::joints::is_empty_loop, internal::joints::is_within,
    internal::joints::other_end, internal::joints::pieces_of;

// The parts of a chain or loop through a curve, which is not reversed and is the first one of a loop.
struct Parts {
  std::vector<Joined_curves::Part> list;
  bool is_loop = false;
};
Parts parts_through(const Joints& joints, std::size_t curve) {
  Parts parts;
  std::vector<Joined_curves::Part> before;
  std::size_t end = 2 * curve + 1;
  parts.list.push_back({curve, false});
  for (; joints.partner(end) != NO_END; end = other_end(joints.partner(end))) {
    const std::size_t next = joints.partner(end);
    if (next == 2 * curve) {
      parts.is_loop = true;
      return parts;
    }
    parts.list.push_back({next / 2, next % 2 == 1});
  }
  for (end = 2 * curve; joints.partner(end) != NO_END; end = other_end(joints.partner(end)))
    before.push_back({joints.partner(end) / 2, joints.partner(end) % 2 == 0});
  parts.list.insert(parts.list.begin(), before.rbegin(), before.rend());
  return parts;
}

double widest_gap(const Joints& joints, const Parts& parts) {
  double widest = 0;
  for (const Joined_curves::Part& part : parts.list)
    if (joints.partner(end_behind(part)) != NO_END) widest = (std::max)(widest, joints.gap(end_behind(part)));
  return widest;
}

Piece with_end(const Piece& piece, bool is_last, const Point& place) {
  std::vector<Point> points = piece.control_points();
  (is_last ? points.back() : points.front()) = place;
  return Piece(std::move(points), piece.weights());
}

// Makes ends the same.
void meet(Piece& before, Piece& behind, bool is_first_earlier) {
  const Point end = before.control_points().back(), start = behind.control_points().front();
  if (end == start) return;
  const bool is_end_moved =
      before.degree() < behind.degree() || (before.degree() == behind.degree() && !is_first_earlier);
  if (is_end_moved) before = with_end(before, true, start);
  else behind = with_end(behind, false, end);
}

bool is_point(const Piece& piece) {
  const auto& points = piece.control_points();
  return std::all_of(points.begin(), points.end(), [&](const Point& p) { return p == points.front(); });
}

std::vector<Piece> joined_pieces(const std::vector<Curve>& curves, const Parts& parts) {
  std::vector<Piece> pieces;
  std::vector<std::size_t> first;  // of each part, its number among the pieces
  for (const Joined_curves::Part& part : parts.list) {
    first.push_back(pieces.size());
    const std::vector<Piece> more = pieces_of(curves[part.curve], part.is_reversed);
    pieces.insert(pieces.end(), more.begin(), more.end());
  }
  const std::size_t count = parts.list.size();
  for (std::size_t i = parts.is_loop ? 0 : 1; i < count; ++i) {
    const std::size_t last = i == 0 ? count - 1 : i - 1;
    Piece& before = i == 0 ? pieces.back() : pieces[first[i] - 1];
    // one piece alone has both of its ends in it
    if (&before == &pieces[first[i]]) before = with_end(before, true, before.control_points().front());
    else meet(before, pieces[first[i]], parts.list[last].curve <= parts.list[i].curve);
  }
  // Lines that became points; a loop that is not within its moves has others.
  const auto end = std::remove_if(pieces.begin(), pieces.end(), is_point);
  if (end != pieces.begin()) pieces.erase(end, pieces.end());
  return pieces;
}

void add_as_it_is(Drawing_2<double>& drawing, const Curve& curve) {
  if (curve.b_spline != nullptr) drawing.add(*curve.b_spline, curve.name);
  else drawing.add(curve.beziers, curve.name, curve.parameters);
}

}  // namespace

double Joined_curves::rounding_of_ends(double largest_coordinate) { return std::ldexp(largest_coordinate, -40); }

Joined_curves join_curves(const Drawing_2<double>& drawing, double eps, const std::vector<std::size_t>& layers,
                          const std::vector<double>& errors) {
  const std::vector<Curve>& curves = drawing.curves();
  if (!(eps >= 0) || !std::isfinite(eps))
    throw std::invalid_argument(expected("eps", "a number from 0", text_of(eps, "another one")));
  if (!layers.empty() && layers.size() != curves.size())
    throw std::invalid_argument(expected("layers", text_of(curves.size()) + ", one a curve, or none", layers.size()));
  if (!errors.empty() && errors.size() != curves.size())
    throw std::invalid_argument(expected("errors", text_of(curves.size()) + ", one a curve, or none", errors.size()));
  std::vector<Reach> reaches{{0}, {(std::min)(Joined_curves::rounding_of_ends(drawing.coordinate_size()), eps)}, {eps}};
  for (const double error : errors) {
    if (!(error >= 0) || !std::isfinite(error))
      throw std::invalid_argument(expected("errors", "numbers from 0", text_of(error, "another one")));
    if (error > 0 && reaches.back().of_curves == nullptr) reaches.push_back({eps, &errors});
  }
  Joints joints(drawing, layers);
  for (const bool is_of_one_layer : {true, false}) {
    if (is_of_one_layer && layers.empty()) continue;
    const bool has_order = is_of_one_layer || layers.empty();  // that of several layers tells nothing
    // Ends of arcs that touch lines are off by rounding: what is the same there are ends of other outlines' lines.
    if (has_order) joints.join_loops_within(reaches[1]);
    for (const Reach& reach : reaches) {
      do {
        joints.join_within(reach, is_of_one_layer);
        joints.close_within(reach);
      } while (joints.join_straight_within(reach, is_of_one_layer));
    }
  }
  Joined_curves result;
  std::vector<bool> is_done(curves.size());
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (is_done[i]) continue;
    Parts parts = parts_through(joints, i);
    const double widest = widest_gap(joints, parts);
    if (parts.is_loop && is_empty_loop(curves, parts.list, widest)) {
      for (const Joined_curves::Part& part : parts.list)
        if (joints.gap(end_behind(part)) == widest) joints.part(end_behind(part));
      parts = parts_through(joints, i);
    }
    const double moved = widest_gap(joints, parts);
    const std::size_t count = parts.is_loop ? parts.list.size() : parts.list.size() - 1;
    if (count == 0) add_as_it_is(result.drawing, curves[i]);
    else result.drawing.add(joined_pieces(curves, parts), curves[i].name);
    if (count > 0) result.joined.push_back(result.parts.size());
    for (const Joined_curves::Part& part : parts.list) is_done[part.curve] = true;
    result.joints += count;
    result.moved = (std::max)(result.moved, moved);
    result.parts.push_back(std::move(parts.list));
  }
  result.crowded = joints.crowded(reaches.back());
  return result;
}

}  // namespace CGAL::Bounding_arcs
