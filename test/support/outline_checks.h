// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What holds of every outline of a Boolean operation, told by exact winding numbers of the operands.

#ifndef BOUNDING_ARCS_TEST_OUTLINE_CHECKS_H
#define BOUNDING_ARCS_TEST_OUTLINE_CHECKS_H

#include "../../src/library/tree/Segment_hierarchy.h"
#include "query_drawings.h"

#include <CGAL/Bounding_arcs_2/boolean/boolean_operations.h>
#include <CGAL/Bounding_arcs_2/query/measures.h>
#include <CGAL/Bounding_arcs_2/query/point_location.h>
#include "../../src/library/query/Intersection_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace bounding_arcs_test {

using Boolean_operation = ba::Outline_2::Operation;
using ba::Fill_rule;
using ba::Fill_rules;
using ba::Outline_2;

/// Operands of a Boolean operation, each with its point location.
class Operands {
 public:
  explicit Operands(std::vector<Drawing> drawings, ba::Decisions decisions = ba::Decisions::EXACT)
      : drawings_(std::move(drawings)) {
    for (const Drawing& d : drawings_) hierarchies_.emplace_back(d, decisions);
  }
  [[nodiscard]] std::vector<const Drawing*> drawings() const {
    std::vector<const Drawing*> all;
    for (const Drawing& d : drawings_) all.push_back(&d);
    return all;
  }
  [[nodiscard]] std::vector<const ba::Bounding_arc_tree_2*> trees() const {
    std::vector<const ba::Bounding_arc_tree_2*> all;
    for (const ba::Bounding_arc_tree_2& tree : hierarchies_) all.push_back(&tree);
    return all;
  }
  [[nodiscard]] Outline_2 outline(Boolean_operation operation, const Fill_rules& rules) const {
    return ba::boolean_operation(trees(), operation, rules);
  }
  /// Whether a point is inside: 1, 0, or -1 on a curve.
  [[nodiscard]] int is_inside(Boolean_operation operation, const Fill_rules& rules, const Point& q) const {
    int filled = 0, first = 0;
    for (std::size_t k = 0; k < hierarchies_.size(); ++k) {
      const auto side = ba::Point_location_2(hierarchies_[k]).locate(q, rules.of(k, hierarchies_.size()));
      if (side == CGAL::ON_BOUNDARY) return -1;
      if (side != CGAL::ON_BOUNDED_SIDE) continue;
      ++filled;
      if (k == 0) first = 1;
    }
    const int count = static_cast<int>(hierarchies_.size());
    switch (operation) {
      case Boolean_operation::UNION:
        return filled > 0 ? 1 : 0;
      case Boolean_operation::INTERSECTION:
        return filled == count ? 1 : 0;
      case Boolean_operation::DIFFERENCE:
        return first == 1 && filled == 1 ? 1 : 0;
      case Boolean_operation::SYMMETRIC_DIFFERENCE:
        return filled % 2;
    }
    return -1;
  }

 private:
  std::vector<Drawing> drawings_;
  std::vector<ba::Bounding_arc_tree_2> hierarchies_;
};

/// Parts in an order that does not depend on where chains begin.
inline std::vector<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, double, double>> parts_of(
    const Outline_2& outline, bool exchanged) {
  std::vector<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, double, double>> parts;
  for (const auto& chain : outline.chains)
    for (const auto& p : chain.parts)
      parts.emplace_back(exchanged ? 1 - p.operand : p.operand, p.curve, p.bezier, p.from.lower, p.to.lower);
  std::sort(parts.begin(), parts.end());
  return parts;
}

inline double area_of(const Drawing& drawing, double eps) {
  if (drawing.curves().empty()) return 0;
  const auto bounds = ba::area(ba::Bounding_arc_tree_2(drawing), eps);
  return 0.5 * (bounds.lower + bounds.upper);
}

// What changes of the parts of outlines is to be changed here.
inline bool is_reversed(const ba::Outline_2::Part& part) { return part.is_reversed; }

/// A common point of the operands that is inside two parts, exactly. There is none.
inline std::optional<Point> crossing_of_parts(const Outline_2& outline, const std::vector<const Drawing*>& operands) {
  Drawing all;
  std::vector<std::uint32_t> first_curve;
  for (const Drawing* d : operands) {
    first_curve.push_back(static_cast<std::uint32_t>(all.curves().size()));
    for (const auto& c : d->curves()) all.add(c.beziers, c.name);
  }
  const ba::Bounding_arc_tree_2 hierarchy(all);
  const auto is_inside_part = [&](const ba::Curve_range& at) {
    for (const auto& chain : outline.chains)
      for (const auto& p : chain.parts) {
        const auto &low = is_reversed(p) ? p.to : p.from, &high = is_reversed(p) ? p.from : p.to;
        if (first_curve[p.operand] + p.curve == at.curve && p.bezier == at.bezier && low.upper < at.t.lower &&
            at.t.upper < high.lower)
          return true;
      }
    return false;
  };
  for (const auto& p : ba::Intersection_search(hierarchy.in_unit()).all().points)
    if (is_inside_part(p.a) && is_inside_part(p.b)) return hierarchy.unit().out(p.point);
  return std::nullopt;
}
inline void expect_no_crossing(const Outline_2& outline, const std::vector<const Drawing*>& operands,
                               const std::string& name) {
  const auto crossing = crossing_of_parts(outline, operands);
  EXPECT_FALSE(crossing) << name << " at " << crossing->x << ' ' << crossing->y;
}

/// No chain runs round a point twice or the other way, and no two cross at a vertex that they share: around it one
/// would have points that the other has, points that it has not, and would not have all of the other's.
inline void expect_single_chains(const Outline_2& outline, const Drawing& drawing, double size, std::mt19937& random,
                                 const std::string& name) {
  constexpr int AROUND = 12;
  constexpr double TURN = 6.283185307179586;
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<ba::Bounding_arc_tree_2> hierarchies;
  hierarchies.reserve(outline.chains.size());
  for (const auto& curve : drawing.curves()) hierarchies.emplace_back(drawing_of(curve.beziers));
  std::map<std::pair<double, double>, std::vector<std::size_t>> at;  // chains by vertex, as often as they are there
  for (std::size_t i = 0; i < outline.chains.size(); ++i)
    for (const auto& part : outline.chains[i].parts) at[{part.start.x, part.start.y}].push_back(i);
  for (const auto& [vertex, chains] : at) {
    if (chains.size() < 2) continue;  // the numbers of the whole outline tell
    std::map<std::pair<std::size_t, std::size_t>, unsigned> patterns;
    const double r = size * std::exp2(-10 - 10 * unit(random));
    for (int k = 0; k < AROUND; ++k) {
      const double angle = TURN * (k + unit(random)) / AROUND;
      std::map<std::size_t, bool> inside;
      for (const std::size_t i : chains) {
        const auto w = ba::Point_location_2(hierarchies[i])
                           .winding_number({vertex.first + r * std::cos(angle), vertex.second + r * std::sin(angle)});
        if (w.state != ba::Winding_number::State::DECIDED) continue;
        EXPECT_TRUE(w.number == 0 || w.number == (outline.chains[i].is_ccw ? 1 : -1)) << name << " chain " << i;
        inside[i] = w.number != 0;
      }
      for (const auto& [i, is_in_i] : inside)
        for (const auto& [j, is_in_j] : inside)
          if (i < j) patterns[{i, j}] |= 1U << ((is_in_i ? 2U : 0U) + (is_in_j ? 1U : 0U));
    }
    constexpr unsigned ALL = 15;
    for (const auto& [pair, seen] : patterns)
      EXPECT_NE(seen, ALL) << name << " chains " << pair.first << " and " << pair.second << " at " << vertex.first
                           << ' ' << vertex.second;
  }
}

/// \param points how many random ones, besides those around vertices
inline void expect_outline(const Operands& operands, Boolean_operation operation, const Fill_rules& rules,
                           std::mt19937& random, int points, const std::string& name) {
  const Outline_2 outline = operands.outline(operation, rules);
  ASSERT_EQ(outline.status, ba::Outline_2::Status::COMPLETE) << name;
  for (const auto& chain : outline.chains)
    for (std::size_t i = 0, n = chain.parts.size(); i < n; ++i)
      ASSERT_EQ(chain.parts[i].end, chain.parts[(i + 1) % n].start) << name;
  const Drawing drawing = ba::drawn_outline(operands.trees(), outline, {false}).drawing;
  const ba::Bounding_arc_tree_2 hierarchy(drawing);
  const ba::Point_location_2 location(hierarchy);
  CGAL::Bbox_2 box;
  for (const Drawing* d : operands.drawings())
    for (const auto& c : d->curves())
      for (const auto& b : c.beziers)
        for (const Point& p : b.control_points()) box += CGAL::Bbox_2(p.x, p.y, p.x, p.y);
  std::uniform_real_distribution<double> unit(0, 1);
  const auto expect_side = [&](const Point& q) {
    const int inside = operands.is_inside(operation, rules, q);
    const ba::Winding_number w = location.winding_number(q);
    if (inside < 0 || w.state != ba::Winding_number::State::DECIDED) return;
    EXPECT_EQ(w.number, inside) << name << " at " << q.x << " " << q.y;
  };
  for (int i = 0; i < points; ++i)
    expect_side(
        {box.xmin() + unit(random) * (box.xmax() - box.xmin()), box.ymin() + unit(random) * (box.ymax() - box.ymin())});
  const double size = (std::max)(box.xmax() - box.xmin(), box.ymax() - box.ymin());
  for (const auto& chain : outline.chains)
    for (const auto& part : chain.parts) {
      const double angle = 6.283185307179586 * unit(random), r = size * std::exp2(-10 - 20 * unit(random));
      expect_side(part.start + Point{r * std::cos(angle), r * std::sin(angle)});
    }
  expect_single_chains(outline, drawing, size, random, name);
  expect_no_crossing(outline, operands.drawings(), name);
  // each chain by itself, and those around it
  for (std::size_t i = 0; i < outline.chains.size(); ++i) {
    const auto& chain = outline.chains[i];
    const double area = area_of(drawing_of(drawing.curves()[i].beziers), 1e-8 * size * size);
    if (std::fabs(area) > 1e-7 * size * size) {
      EXPECT_EQ(area > 0, chain.is_ccw) << name << " chain " << i;
    }
    EXPECT_EQ(chain.is_ccw, !chain.parent || !outline.chains[*chain.parent].is_ccw) << name << " chain " << i;
  }
}

}  // namespace bounding_arcs_test

#endif
