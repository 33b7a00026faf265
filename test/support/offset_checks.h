// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What offsets are checked by: areas, winding numbers, the hierarchy's distance, points on a grid, and samples of
// what bounds the set that closed curves enclose.

#ifndef BOUNDING_ARCS_TEST_OFFSET_CHECKS_H
#define BOUNDING_ARCS_TEST_OFFSET_CHECKS_H

#include "bulge_arcs.h"
#include "query_drawings.h"

#include <CGAL/Bounding_arcs_2/offset/Offset_source_2.h>
#include <CGAL/Bounding_arcs_2/offset/offset_bracket.h>
#include <CGAL/Bounding_arcs_2/query/closest_point.h>
#include <CGAL/Bounding_arcs_2/query/distance.h>
#include <CGAL/Bounding_arcs_2/query/point_location.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace bounding_arcs_test {

using ba::Offset;
/// Options of an offset, and how near it is to be.
struct Offset_options : ba::Offset::Options {
  double eps = 1e-6;
};
inline ba::Offset_source_2 offset_source(const Drawing& drawing, const Offset_options& options = {}) {
  return {ba::Bounding_arc_tree_2(drawing), options.eps, options};
}
inline Offset offset_curves(const Drawing& drawing, double d, const Offset_options& options = {}) {
  return offset_source(drawing, options).at(d);
}

inline Drawing polygon(const std::vector<Point>& corners, bool is_closed = true) {
  std::vector<Bezier> chain;
  for (std::size_t i = 0; i + 1 < corners.size() + (is_closed ? 1 : 0); ++i)
    chain.push_back(segment(corners[i], corners[(i + 1) % corners.size()]));
  return drawing_of(chain);
}
inline Drawing rectangle(double w, double h) { return polygon({{0, 0}, {w, 0}, {w, h}, {0, h}}); }
inline Drawing backwards(const Drawing& drawing) {
  Drawing result;
  for (const auto& curve : drawing.curves()) {
    std::vector<Bezier> chain;
    for (auto piece = curve.beziers.rbegin(); piece != curve.beziers.rend(); ++piece) {
      auto p = piece->control_points();
      auto w = piece->weights();
      chain.emplace_back(std::vector<Point>(p.rbegin(), p.rend()), std::vector<double>(w.rbegin(), w.rend()));
    }
    result.add(std::move(chain), curve.name);
  }
  return result;
}
inline Drawing both(const Drawing& a, const Drawing& b) {
  Drawing result = a;
  for (const auto& curve : b.curves()) result.add(curve.beziers, curve.name);
  return result;
}

inline double area_of(const Offset& offset) {
  double area = 0;
  for (const auto& chain : offset.chains) area += chain.area;
  return area;
}
inline int winding(const Offset& offset, const Point& x) {
  int sum = 0;
  for (const auto& chain : offset.chains)
    for (const auto& p : chain.pieces) sum += winding_of(p.arc, x);
  return sum;
}
inline Offset_options within(double eps) {
  Offset_options options;
  options.eps = eps;
  return options;
}

// What holds for all: complete, chains that close, directed and nested as told.
inline void expect_sound(const Offset& offset) {
  EXPECT_EQ(offset.status, ba::Offset::Status::COMPLETE);
  for (const auto& chain : offset.chains) {
    ASSERT_FALSE(chain.pieces.empty());
    for (std::size_t i = 0; i + 1 < chain.pieces.size(); ++i)
      EXPECT_EQ(chain.pieces[i].arc.to, chain.pieces[i + 1].arc.from);
    if (!chain.is_closed) continue;
    EXPECT_EQ(chain.pieces.back().arc.to, chain.pieces.front().arc.from);
    EXPECT_EQ(chain.is_ccw, chain.area > 0);
    EXPECT_EQ(chain.is_ccw, !chain.parent || !offset.chains[*chain.parent].is_ccw);  // regions and holes take turns
  }
}
// What closed curves enclose, by their winding numbers at points, and samples of what bounds it: points of the curves
// with what is enclosed on one side alone, a step of 1e-7 away.
class Filled_set {
 public:
  explicit Filled_set(const Drawing& drawing, ba::Fill_rule rule)
      : index_(drawing, ba::Decisions::DOUBLE), location_(index_), rule_(rule) {
    constexpr int SAMPLES = 64;
    constexpr double ASIDE = 1e-7;
    for (const auto& curve : drawing.curves())
      for (const Bezier& piece : curve.beziers) {
        Point last = piece.point(0);
        for (int i = 0; i < SAMPLES && curve.is_closed; ++i) {
          const Point from = piece.point((i + 0.25) / SAMPLES), to = piece.point((i + 0.75) / SAMPLES),
                      p = piece.point((i + 0.5) / SAMPLES), way = to - from;
          spacing_ = (std::max)({spacing_, ba::euclidean_norm(p - last), ba::euclidean_norm(p - to)});
          last = p;
          const Point aside = (ASIDE / ba::euclidean_norm(way)) * perp(way);
          if (holds(p + aside) != holds(p - aside)) boundary_.push_back(p);
          else has_walls_ = true;
        }
      }
  }
  [[nodiscard]] bool holds(const Point& q) const { return ba::is_filled(rule_, location_.winding_number(q).number); }
  // Of q from the boundary: not nearer than the curves are, and no sample nearer than the boundary is.
  [[nodiscard]] ba::Bracket distance(const Point& q) const {
    const auto of_curves = ba::closest_point(index_, q)->distance;
    if (!has_walls_) return of_curves;
    double least = HUGE_VAL;
    for (const Point& p : boundary_) least = (std::min)(least, ba::euclidean_norm(p - q));
    return {(std::max)(of_curves.lower, least - spacing_), least};
  }

 private:
  ba::Bounding_arc_tree_2 index_;
  ba::Point_location_2 location_;
  ba::Fill_rule rule_;
  std::vector<Point> boundary_;
  bool has_walls_ = false;
  double spacing_ = 0;
};

// All points of round pieces are within eps of the distance.  Inwards they are as far as that from the outline, and
// that from the curves, so that walls are no reason to be nearer.
inline void expect_at_distance(const Drawing& drawing, const Offset& offset, double eps,
                               ba::Fill_rule rule = ba::Fill_rule::NONZERO) {
  const ba::Bounding_arc_tree_2 index(drawing, ba::Decisions::DOUBLE);
  const auto error = ba::offset_error(index, offset, eps / 16);
  if (!error) return;
  const double most = eps * (1 + 1.0 / 16);
  const auto& curves = drawing.curves();
  const auto is_closed = [](const auto& c) { return c.is_closed; };
  if (offset.distance > 0 || !std::any_of(curves.begin(), curves.end(), is_closed)) {
    EXPECT_GE(error->nearest.lower, -most);
    EXPECT_LE(error->farthest.upper, most);
    return;
  }
  Offset_options options = within(eps);
  options.rule = rule;
  const Offset outline = offset_source(drawing, options).outline();
  expect_sound(outline);
  const ba::Bounding_arc_tree_2 of_outline(outline.drawing(), ba::Decisions::DOUBLE);
  const auto from_outline = ba::offset_error(of_outline, offset, eps / 16);
  ASSERT_TRUE(from_outline);
  EXPECT_GE(from_outline->nearest.lower, -most);
  EXPECT_LE(from_outline->farthest.upper, most);
  EXPECT_LE(ba::directed_hausdorff_distance(of_outline, index, eps / 16)->distance.upper, most);
}

// Counts on a grid: points farther than eps from the boundary are inside exactly where distance and winding say so.
// Inwards that is the distance to what separates points that are enclosed from others.
inline void expect_same_points(const Drawing& drawing, const Offset& offset, double eps, bool only_closed,
                               ba::Fill_rule rule = ba::Fill_rule::NONZERO) {
  const ba::Bounding_arc_tree_2 index(drawing, ba::Decisions::DOUBLE);
  std::optional<Filled_set> filled;
  if (only_closed) filled.emplace(drawing, rule);
  const double d = std::fabs(offset.distance);
  const bool is_inwards = only_closed && offset.distance < 0;
  constexpr int GRID = 40;
  for (int i = 0; i <= GRID; ++i)
    for (int j = 0; j <= GRID; ++j) {
      const Point q{-2 + 4.0 * i / GRID + 0.0123, -2 + 4.0 * j / GRID + 0.0321};
      const bool is_inside = only_closed && filled->holds(q);
      if (is_inwards && !is_inside) {
        ASSERT_EQ(winding(offset, q), 0) << q.x << ' ' << q.y << " d " << offset.distance;
        continue;
      }
      const ba::Bracket distance = is_inwards ? filled->distance(q) : ba::closest_point(index, q)->distance;
      if (distance.lower <= d + 2 * eps && distance.upper >= d - 2 * eps) continue;
      const bool is_near = distance.upper < d, wanted = is_inwards ? !is_near : is_near || is_inside;
      ASSERT_EQ(winding(offset, q), wanted ? 1 : 0) << q.x << ' ' << q.y << " d " << offset.distance;
    }
}

}  // namespace bounding_arcs_test

#endif
