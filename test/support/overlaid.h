// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What holds of all overlays: closed boundaries, Euler's formula, parts of curves, exact winding numbers beside edges.

#ifndef BOUNDING_ARCS_TEST_OVERLAID_H
#define BOUNDING_ARCS_TEST_OVERLAID_H

#include "closed_drawings.h"
#include "kernel_trees.h"
#include "query_drawings.h"

#include <CGAL/Bounding_arcs_2.h>
#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>
#include <CGAL/Bounding_arcs_2/query/point_location.h>
#include "../../src/library/curve/exact_bezier.h"

#include <CGAL/Exact_rational.h>

#include <boost/pending/disjoint_sets.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace bounding_arcs_test {

using ba::Overlay_2;
using Number = CGAL::Exact_rational;
using Exact_point = ba::Xy<Number>;

constexpr ba::Overlay_2::Options AT_JOINTS{true};

/// Trees of drawings, with what they cut the plane into.
class Overlaid {
 public:
  explicit Overlaid(std::vector<Drawing> drawings, const ba::Overlay_2::Options& options = {})
      : drawings_(std::move(drawings)) {
    trees_.reserve(drawings_.size());
    for (const Drawing& d : drawings_) trees_.emplace_back(d);
    for (const Filtered_tree& t : trees_) pointers_.push_back(&t);
    cells_ = ba::overlay(pointers_, options);
  }

  [[nodiscard]] const Overlay_2& cells() const { return cells_; }
  [[nodiscard]] const std::vector<Drawing>& drawings() const { return drawings_; }
  [[nodiscard]] ba::Measure_bounds area(std::uint32_t face, double eps) const {
    return cells_.face_area(pointers_, face, eps);
  }
  [[nodiscard]] std::vector<double> areas(double eps = 1e-12) const {
    std::vector<double> result;
    for (std::uint32_t f = 1; f < cells_.faces.size(); ++f) result.push_back(area(f, eps).upper);
    std::sort(result.begin(), result.end());
    return result;
  }

 private:
  std::vector<Drawing> drawings_;
  std::vector<Filtered_tree> trees_;
  std::vector<const ba::Bounding_arc_tree_2*> pointers_;
  Overlay_2 cells_;
};

inline void expect_counts(const Overlay_2& cells, std::size_t vertices, std::size_t edges, std::size_t faces) {
  EXPECT_EQ(cells.status, ba::Outline_2::Status::COMPLETE);
  EXPECT_EQ(cells.vertices.size(), vertices);
  EXPECT_EQ(cells.edges.size(), edges);
  EXPECT_EQ(cells.faces.size(), faces);
}

inline std::vector<std::vector<int>> windings_of(const Overlay_2& cells) {
  std::vector<std::vector<int>> result;
  for (std::uint32_t f = 0; f < cells.faces.size(); ++f) result.push_back(cells.windings(f));
  std::sort(result.begin(), result.end());
  return result;
}

/// The vertex where a side begins; nothing of a closed curve without any.
inline std::optional<std::uint32_t> start_of(const Overlay_2& cells, const Overlay_2::Side& s) {
  return s.is_reversed ? cells.edges[s.edge].to : cells.edges[s.edge].from;
}
inline std::optional<std::uint32_t> end_of(const Overlay_2& cells, const Overlay_2::Side& s) {
  return start_of(cells, {s.edge, !s.is_reversed});
}

// Boundaries are closed, have their face on the left, and all sides of edges are in them once.
inline void expect_boundaries(const Overlay_2& cells) {
  std::set<std::pair<std::uint32_t, bool>> sides;
  for (std::uint32_t f = 0; f < cells.faces.size(); ++f) {
    const ba::Overlay_2::Face& face = cells.faces[f];
    EXPECT_EQ(face.is_bounded, f > 0);
    EXPECT_EQ(face.way_out.has_value(), f > 0);
    EXPECT_TRUE(f == 0 || !face.boundaries.empty());
    const auto left_of = [&](const Overlay_2::Side& s) {
      return s.is_reversed ? cells.edges[s.edge].right : cells.edges[s.edge].left;
    };
    if (face.way_out) {
      EXPECT_EQ(left_of(*face.way_out), f);
      EXPECT_LT(left_of({face.way_out->edge, !face.way_out->is_reversed}), f);
    }
    for (const auto& boundary : face.boundaries)
      for (std::size_t i = 0; i < boundary.size(); ++i) {
        EXPECT_EQ(left_of(boundary[i]), f);
        EXPECT_EQ(end_of(cells, boundary[i]), start_of(cells, boundary[(i + 1) % boundary.size()]));
        EXPECT_TRUE(sides.emplace(boundary[i].edge, boundary[i].is_reversed).second);
      }
  }
  EXPECT_EQ(sides.size(), 2 * cells.edges.size());
}

// Euler's formula; a closed curve without vertices counts as one vertex more.
inline void expect_euler(const Overlay_2& cells) {
  std::size_t vertices = cells.vertices.size();
  boost::disjoint_sets_with_storage<> parts(vertices + cells.edges.size());
  for (std::size_t v = 0; v < vertices; ++v) parts.make_set(v);
  for (const ba::Overlay_2::Edge& e : cells.edges) {
    if (e.from) parts.union_set(*e.from, *e.to);
    else parts.make_set(vertices++);
  }
  std::size_t components = 0;
  for (std::size_t v = 0; v < vertices; ++v) components += parts.find_set(v) == v ? 1 : 0;
  EXPECT_EQ(cells.faces.size() + vertices, 1 + components + cells.edges.size());
}

using Piece_number = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;  // operand, curve, Bezier piece

// The parts of each piece that is no point go from 0 to 1, each from where another one ends.
inline void expect_all_parts(const Overlaid& overlaid) {
  struct Ends {
    std::multiset<std::pair<double, double>> from, to;
  };
  std::map<Piece_number, Ends> parts;
  for (const ba::Overlay_2::Edge& e : overlaid.cells().edges) {
    EXPECT_FALSE(e.sources.empty() || e.sources.front().is_reversed);
    for (const ba::Overlay_2::Source& s : e.sources)
      for (const ba::Overlay_2::Part& p : s.parts) {
        const ba::Bracket &low = s.is_reversed ? p.to : p.from, &high = s.is_reversed ? p.from : p.to;
        EXPECT_LE(low.lower, high.upper);
        Ends& ends = parts[{s.operand, s.curve, p.bezier}];
        ends.from.emplace(low.lower, low.upper);
        ends.to.emplace(high.lower, high.upper);
      }
  }
  for (std::uint32_t o = 0; o < overlaid.drawings().size(); ++o)
    for (std::uint32_t c = 0; c < overlaid.drawings()[o].curves().size(); ++c)
      for (std::uint32_t b = 0; b < overlaid.drawings()[o].curves()[c].beziers.size(); ++b) {
        const auto& points = overlaid.drawings()[o].curves()[c].beziers[b].control_points();
        if (std::all_of(points.begin(), points.end(), [&](const Point& p) { return p == points[0]; })) continue;
        Ends& ends = parts[{o, c, b}];
        EXPECT_EQ(ends.from.erase({0, 0}), 1u);
        EXPECT_EQ(ends.to.erase({1, 1}), 1u);
        EXPECT_EQ(ends.from, ends.to);
      }
}

// Exact points of curves at single parameters of vertices are in the brackets of these, which are some ulp wide.
inline void expect_brackets(const Overlaid& overlaid) {
  const Overlay_2& cells = overlaid.cells();
  for (const ba::Overlay_2::Vertex& v : cells.vertices) {
    EXPECT_TRUE(v.x.lower <= v.point.x && v.point.x <= v.x.upper && v.y.lower <= v.point.y && v.point.y <= v.y.upper);
  }
  for (const ba::Overlay_2::Edge& e : cells.edges) {
    if (!e.from) continue;
    for (const ba::Overlay_2::Source& s : e.sources)
      for (const bool is_start : {true, false}) {
        const ba::Overlay_2::Part& part = is_start ? s.parts.front() : s.parts.back();
        const ba::Bracket& t = is_start ? part.from : part.to;
        if (!t.is_single()) continue;
        const auto& piece = overlaid.drawings()[s.operand].curves()[s.curve].beziers[part.bezier];
        const Exact_point p = ba::exact_bezier(piece).point(Number(t.lower));
        const ba::Overlay_2::Vertex& v = cells.vertices[is_start ? *e.from : *e.to];
        EXPECT_TRUE(Number(v.x.lower) <= p.x && p.x <= Number(v.x.upper));
        EXPECT_TRUE(Number(v.y.lower) <= p.y && p.y <= Number(v.y.upper));
      }
  }
}

/// Closed curves of drawings, which run round points.
class Closed_curves {
 public:
  explicit Closed_curves(const std::vector<Drawing>& drawings) {
    for (const Drawing& d : drawings) {
      Drawing closed;
      for (const auto& curve : d.curves())
        if (curve.is_closed) closed.add(curve.beziers);
      hierarchies_.emplace_back(closed);
    }
  }
  [[nodiscard]] std::vector<int> windings(const Exact_point& q) const {
    std::vector<int> result;
    for (const ba::Bounding_arc_tree_2& h : hierarchies_)
      result.push_back(h.drawing().curves().empty() ? 0 : ba::winding_number(h, ba::Asked_point(q)).number);
    return result;
  }
  [[nodiscard]] std::vector<ba::Measure_bounds> areas(double eps) const {
    std::vector<ba::Measure_bounds> result;
    for (const ba::Bounding_arc_tree_2& h : hierarchies_) result.push_back(ba::area(h, eps));
    return result;
  }

 private:
  std::vector<ba::Bounding_arc_tree_2> hierarchies_;
};

// Points at a parameter of an edge, 2^-160 to its left and to its right, with exact winding numbers.
// \return how many edges were long enough, of all or of some of them
inline int expect_windings(const Overlaid& overlaid, std::mt19937& random) {
  const Overlay_2& cells = overlaid.cells();
  const Closed_curves closed(overlaid.drawings());
  std::vector<std::vector<int>> windings;
  cells.for_each_face([&](std::uint32_t face, const std::vector<int>& numbers) {
    EXPECT_EQ(windings.size(), face);
    EXPECT_EQ(numbers, cells.windings(face));
    windings.push_back(numbers);
  });
  EXPECT_EQ(windings.size(), cells.faces.size());
  EXPECT_EQ(windings.front(), std::vector<int>(cells.number_of_operands, 0));
  int count = 0;
  constexpr std::size_t MOST = 8;  // exact numbers of that many digits take their time
  for (std::size_t k = 0; k < (std::min)(cells.edges.size(), MOST); ++k) {
    const ba::Overlay_2::Edge& e = cells.edges[cells.edges.size() <= MOST ? k : random() % cells.edges.size()];
    const ba::Overlay_2::Source& source = e.sources[random() % e.sources.size()];
    const ba::Overlay_2::Part& part = source.parts[random() % source.parts.size()];
    const ba::Bracket &low = source.is_reversed ? part.to : part.from, &high = source.is_reversed ? part.from : part.to;
    constexpr double LONG = 0x1p-40, STEP = 0x1p-60, BESIDE = 0x1p-160;
    if (!(high.lower - low.upper > LONG)) continue;
    const Number t(low.upper + (high.lower - low.upper) * std::uniform_real_distribution<double>(0.3, 0.7)(random));
    const auto piece =
        ba::exact_bezier(overlaid.drawings()[source.operand].curves()[source.curve].beziers[part.bezier]);
    const Exact_point p = piece.point(t), way = piece.point(t + Number(STEP)) - piece.point(t - Number(STEP));
    const double length = CGAL::to_double(CGAL::abs(way.x) + CGAL::abs(way.y));
    if (!(length > STEP * LONG)) continue;  // next to a cusp
    const Exact_point beside = Number(BESIDE / length) * Exact_point{-way.y, way.x};
    EXPECT_EQ(closed.windings(p + beside), windings[source.is_reversed ? e.right : e.left]);
    EXPECT_EQ(closed.windings(p - beside), windings[source.is_reversed ? e.left : e.right]);
    ++count;
  }
  return count;
}

// Areas of faces, times how often an operand runs round them, are the areas that it runs round.
inline void expect_areas(const Overlaid& overlaid, double eps) {
  const Overlay_2& cells = overlaid.cells();
  std::vector<ba::Measure_bounds> sums(cells.number_of_operands, {0, 0});
  for (std::uint32_t f = 1; f < cells.faces.size(); ++f) {
    const ba::Measure_bounds area = overlaid.area(f, eps);
    EXPECT_TRUE(0 <= area.lower && area.lower <= area.upper && area.upper > 0);
    EXPECT_TRUE(area.upper - area.lower <= eps && area.status == ba::Query_status::COMPLETE);
    const std::vector<int> windings = cells.windings(f);
    for (std::size_t k = 0; k < windings.size(); ++k) {
      sums[k].lower += windings[k] * (windings[k] > 0 ? area.lower : area.upper);
      sums[k].upper += windings[k] * (windings[k] > 0 ? area.upper : area.lower);
    }
  }
  const std::vector<ba::Measure_bounds> areas = Closed_curves(overlaid.drawings()).areas(eps);
  constexpr double ROUNDING = 1e-12;  // of the sums above
  for (std::size_t k = 0; k < areas.size(); ++k) {
    EXPECT_LE(sums[k].lower - ROUNDING, areas[k].upper) << "operand " << k;
    EXPECT_GE(sums[k].upper + ROUNDING, areas[k].lower) << "operand " << k;
  }
}

inline int expect_sound(const Overlaid& overlaid, std::mt19937& random) {
  EXPECT_EQ(overlaid.cells().status, ba::Outline_2::Status::COMPLETE);
  expect_boundaries(overlaid.cells());
  expect_euler(overlaid.cells());
  expect_all_parts(overlaid);
  expect_brackets(overlaid);
  expect_areas(overlaid, 1e-6);
  return expect_windings(overlaid, random);
}

}  // namespace bounding_arcs_test

#endif
