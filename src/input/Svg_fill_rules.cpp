// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tells shapes for which their rule does not matter.

#include "Svg_fill_rules.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bounding_arcs_tool {

namespace {

using Point = Xy<double>;

constexpr double FULL_TURN = 6.28318530717958647692;

// How far a number of turns may be from 1, while rounding leaves 1e-9 of a subpath of millions of points: turns are
// whole numbers, so that ten times more or less changes nothing.
constexpr double TURN_SLACK = 1e-3;

// The sides of the closed control polygon, but for those without length.
std::vector<Point> sides(const Svg_subpath& subpath) {
  std::vector<Point> result;
  for (const Bezier_curve_2<double>& piece : subpath.beziers) {
    const std::vector<Point>& points = piece.control_points();
    for (std::size_t i = 1; i < points.size(); ++i)
      if (points[i] != points[i - 1]) result.push_back(points[i] - points[i - 1]);
  }
  if (subpath.start() != subpath.end()) result.push_back(subpath.start() - subpath.end());
  return result;
}

// Whether a subpath, when it is closed, turns another number of times than once: without crossings it turns once
// (Hopf). That holds of the control polygon as of the curve, unless the polygon has loops that the curve has not.
bool crosses_itself(const Svg_subpath& subpath) {
  const std::vector<Point> all = sides(subpath);
  if (all.empty()) return false;
  double turned = 0;
  const auto direction = [](const Point& side) { return std::atan2(side.y, side.x); };
  double before = direction(all.back());
  for (const Point& side : all) {
    const double next = direction(side);
    turned += std::remainder(next - before, FULL_TURN);
    before = next;
  }
  return std::abs(std::abs(turned / FULL_TURN) - 1) > TURN_SLACK;
}

}  // namespace

void Svg_fill_rules::add(Fill_rule rule, std::string_view element, const std::vector<Svg_subpath>& subpaths,
                         bool are_open_filled) {
  const auto closed = std::find_if(subpaths.begin(), subpaths.end(), [&](const Svg_subpath& subpath) {
    return subpath.start() == subpath.end() || (are_open_filled && subpath.can_be_closed());
  });
  if (closed == subpaths.end()) return;
  Count& count = rule == Fill_rule::NONZERO ? nonzero_ : even_odd_;
  if (subpaths.size() > 1 || crosses_itself(*closed)) ++count.telling[std::string(element)];
}

Fill_rule Svg_fill_rules::most(Svg_notes& notes) const {
  const std::size_t nonzero = nonzero_.all_telling(), even_odd = even_odd_.all_telling();
  const bool is_even_odd = even_odd > nonzero;
  const char* const reason =
      is_even_odd ? "has fill-rule nonzero, read as evenodd" : "has fill-rule evenodd, read as nonzero";
  for (const auto& [element, count] : (is_even_odd ? nonzero_ : even_odd_).telling)
    for (std::size_t i = 0; i < count; ++i) notes.add(element, reason, Svg_notes::READ);
  return is_even_odd ? Fill_rule::EVEN_ODD : Fill_rule::NONZERO;
}

std::size_t Svg_fill_rules::Count::all_telling() const {
  std::size_t count = 0;
  for (const auto& [element, some] : telling) count += some;
  return count;
}

}  // namespace bounding_arcs_tool
