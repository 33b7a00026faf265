// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What curves cut the plane into: known drawings, and what holds of all overlays, with exact winding numbers beside
// edges.

#include "cases.h"
#include "closed_drawings.h"
#include "kernel_trees.h"
#include "query_drawings.h"

#include <CGAL/Bounding_arcs_2.h>
#include <CGAL/Bounding_arcs_2/curve/converted_drawing.h>
#include <CGAL/Bounding_arcs_2/curve/exact_bezier.h>
#include <CGAL/Bounding_arcs_2/query/Drawing_location.h>

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

namespace test_overlay {

using namespace bounding_arcs_test;
using ba::Overlay_2;
using ba::Overlay_side;
using Number = CGAL::Exact_rational;
using Exact_point = ba::Xy<Number>;

constexpr ba::Overlay_options AT_JOINTS{true};

/// Trees of drawings, with what they cut the plane into.
class Overlaid {
 public:
  explicit Overlaid(std::vector<Drawing> drawings, const ba::Overlay_options& options = {})
      : drawings_(std::move(drawings)) {
    trees_.reserve(drawings_.size());
    for (const Drawing& d : drawings_) trees_.emplace_back(d);
    for (const Filtered_tree& t : trees_) pointers_.push_back(&t);
    cells_ = ba::overlay(pointers_, options);
  }

  [[nodiscard]] const Overlay_2& cells() const { return cells_; }
  [[nodiscard]] const std::vector<Drawing>& drawings() const { return drawings_; }
  [[nodiscard]] ba::Measure_bounds area(std::uint32_t face, double eps) const {
    return ba::face_area(cells_, face, pointers_, eps);
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
  std::vector<const Filtered_tree*> pointers_;
  Overlay_2 cells_;
};

void expect_counts(const Overlay_2& cells, std::size_t vertices, std::size_t edges, std::size_t faces) {
  EXPECT_EQ(cells.status, ba::Outline_status::COMPLETE);
  EXPECT_EQ(cells.vertices.size(), vertices);
  EXPECT_EQ(cells.edges.size(), edges);
  EXPECT_EQ(cells.faces.size(), faces);
}

std::vector<std::vector<int>> windings_of(const Overlay_2& cells) {
  std::vector<std::vector<int>> result;
  for (std::uint32_t f = 0; f < cells.faces.size(); ++f) result.push_back(cells.windings(f));
  std::sort(result.begin(), result.end());
  return result;
}

/// The vertex where a side begins; nothing of a closed curve without any.
std::optional<std::uint32_t> start_of(const Overlay_2& cells, const Overlay_side& s) {
  return s.is_reversed ? cells.edges[s.edge].to : cells.edges[s.edge].from;
}
std::optional<std::uint32_t> end_of(const Overlay_2& cells, const Overlay_side& s) {
  return start_of(cells, {s.edge, !s.is_reversed});
}

// Boundaries are closed, have their face on the left, and all sides of edges are in them once.
void expect_boundaries(const Overlay_2& cells) {
  std::set<std::pair<std::uint32_t, bool>> sides;
  for (std::uint32_t f = 0; f < cells.faces.size(); ++f) {
    const ba::Overlay_face& face = cells.faces[f];
    EXPECT_EQ(face.is_bounded, f > 0);
    EXPECT_EQ(face.way_out.has_value(), f > 0);
    EXPECT_TRUE(f == 0 || !face.boundaries.empty());
    const auto left_of = [&](const Overlay_side& s) {
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
void expect_euler(const Overlay_2& cells) {
  std::size_t vertices = cells.vertices.size();
  boost::disjoint_sets_with_storage<> parts(vertices + cells.edges.size());
  for (std::size_t v = 0; v < vertices; ++v) parts.make_set(v);
  for (const ba::Overlay_edge& e : cells.edges) {
    if (e.from) parts.union_set(*e.from, *e.to);
    else parts.make_set(vertices++);
  }
  std::size_t components = 0;
  for (std::size_t v = 0; v < vertices; ++v) components += parts.find_set(v) == v ? 1 : 0;
  EXPECT_EQ(cells.faces.size() + vertices, 1 + components + cells.edges.size());
}

using Piece_number = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;  // operand, curve, Bezier piece

// The parts of each piece that is no point go from 0 to 1, each from where another one ends.
void expect_all_parts(const Overlaid& overlaid) {
  struct Ends {
    std::multiset<std::pair<double, double>> from, to;
  };
  std::map<Piece_number, Ends> parts;
  for (const ba::Overlay_edge& e : overlaid.cells().edges) {
    EXPECT_FALSE(e.sources.empty() || e.sources.front().is_reversed);
    for (const ba::Overlay_source& s : e.sources)
      for (const ba::Overlay_part& p : s.parts) {
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
void expect_brackets(const Overlaid& overlaid) {
  const Overlay_2& cells = overlaid.cells();
  for (const ba::Overlay_vertex& v : cells.vertices) {
    EXPECT_TRUE(v.x.lower <= v.point.x && v.point.x <= v.x.upper && v.y.lower <= v.point.y && v.point.y <= v.y.upper);
  }
  for (const ba::Overlay_edge& e : cells.edges) {
    if (!e.from) continue;
    for (const ba::Overlay_source& s : e.sources)
      for (const bool is_start : {true, false}) {
        const ba::Overlay_part& part = is_start ? s.parts.front() : s.parts.back();
        const ba::Bracket& t = is_start ? part.from : part.to;
        if (!t.is_single()) continue;
        const auto& piece = overlaid.drawings()[s.operand].curves()[s.curve].beziers[part.bezier];
        const Exact_point p = ba::exact_bezier(piece).point(Number(t.lower));
        const ba::Overlay_vertex& v = cells.vertices[is_start ? *e.from : *e.to];
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
    for (const ba::Drawing_hierarchy& h : hierarchies_)
      result.push_back(h.drawing().curves().empty() ? 0 : ba::winding_number(h, ba::Asked_point(q)).number);
    return result;
  }
  [[nodiscard]] std::vector<ba::Measure_bounds> areas(double eps) const {
    std::vector<ba::Measure_bounds> result;
    for (const ba::Drawing_hierarchy& h : hierarchies_) result.push_back(ba::internal::area(h, eps));
    return result;
  }

 private:
  std::vector<ba::Drawing_hierarchy> hierarchies_;
};

// Points at a parameter of an edge, 2^-160 to its left and to its right, with exact winding numbers.
// \return how many edges were long enough, of all or of some of them
int expect_windings(const Overlaid& overlaid, std::mt19937& random) {
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
    const ba::Overlay_edge& e = cells.edges[cells.edges.size() <= MOST ? k : random() % cells.edges.size()];
    const ba::Overlay_source& source = e.sources[random() % e.sources.size()];
    const ba::Overlay_part& part = source.parts[random() % source.parts.size()];
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
void expect_areas(const Overlaid& overlaid, double eps) {
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

int expect_sound(const Overlaid& overlaid, std::mt19937& random) {
  EXPECT_EQ(overlaid.cells().status, ba::Outline_status::COMPLETE);
  expect_boundaries(overlaid.cells());
  expect_euler(overlaid.cells());
  expect_all_parts(overlaid);
  expect_brackets(overlaid);
  expect_areas(overlaid, 1e-6);
  return expect_windings(overlaid, random);
}

std::vector<Bezier> square(double low, double high) {
  return polygon({{low, low}, {high, low}, {high, high}, {low, high}});
}
std::vector<Bezier> reversed(std::vector<Bezier> chain) {
  std::reverse(chain.begin(), chain.end());
  for (Bezier& b : chain) b = b.reversed();
  return chain;
}

TEST(Overlay, HasTwoCirclesThatCross) {
  const Overlaid found({drawing_of(circle_of_quarters()), drawing_of(circle_of_quarters({1, 1, 0}))});
  expect_counts(found.cells(), 2, 4, 4);
  for (const auto& v : found.cells().vertices) {
    EXPECT_NEAR(v.point.x, 0.5, 1e-15);
    EXPECT_NEAR(std::fabs(v.point.y), std::sqrt(0.75), 1e-15);
    EXPECT_LT(v.y.width(), 4e-14);
  }
  EXPECT_EQ(windings_of(found.cells()), (std::vector<std::vector<int>>{{0, 0}, {0, 1}, {1, 0}, {1, 1}}));
  const double disc = 3.14159265358979324, lens = 2 * disc / 3 - std::sqrt(3.0) / 2;
  const std::vector<double> areas = found.areas();
  EXPECT_NEAR(areas[0], lens, 1e-11);
  EXPECT_NEAR(areas[1], disc - lens, 1e-11);
  EXPECT_NEAR(areas[2], disc - lens, 1e-11);
  // each circle has 4 joints, too
  expect_counts(Overlaid(found.drawings(), AT_JOINTS).cells(), 10, 12, 4);
}

TEST(Overlay, HasClosedCurvesWithoutVertices) {
  const Drawing circle = drawing_of(circle_of_quarters());
  const Overlaid found({circle}), cut({drawing_of(Bezier({{0, 0}, {3, 0}, {0, 3}, {0, 0}}))}, AT_JOINTS);
  expect_counts(found.cells(), 0, 1, 2);
  EXPECT_FALSE(found.cells().edges.front().from || found.cells().edges.front().to);
  EXPECT_EQ(found.cells().edges.front().sources.front().parts.size(), 4u);
  EXPECT_TRUE(found.cells().edges.front().sources.front().is_closed);
  expect_counts(cut.cells(), 1, 1, 2);
  EXPECT_EQ(cut.cells().edges.front().from, 0u);
  EXPECT_EQ(cut.cells().edges.front().to, 0u);
}

TEST(Overlay, HasOneEdgeWhereCurvesRunTogether) {
  const std::vector<Bezier> a = square(0, 2);
  Drawing both;
  both.add(a);
  both.add(reversed(a));
  const Overlaid same({drawing_of(a), both});
  expect_counts(same.cells(), 4, 4, 2);
  for (const ba::Overlay_edge& e : same.cells().edges) {
    ASSERT_EQ(e.sources.size(), 3u);
    int against = 0;
    for (const ba::Overlay_source& s : e.sources) {
      against += s.is_reversed ? 1 : 0;
      ASSERT_EQ(s.parts.size(), 1u);
      EXPECT_EQ(s.parts.front().from.lower, s.is_reversed ? 1 : 0);
      EXPECT_EQ(s.parts.front().to.lower, s.is_reversed ? 0 : 1);
    }
    EXPECT_EQ(against, 1);
  }
  EXPECT_EQ(windings_of(same.cells()), (std::vector<std::vector<int>>{{0, 0}, {1, 0}}));
  // a part of a side: three quarters of a longer line
  const Overlaid along({drawing_of(a), drawing_of(segment({-1, 0}, {3, 0}))});
  expect_counts(along.cells(), 4, 4, 2);
  const auto shared = std::find_if(along.cells().edges.begin(), along.cells().edges.end(),
                                   [](const ba::Overlay_edge& e) { return e.sources.size() == 2; });
  ASSERT_NE(shared, along.cells().edges.end());
  EXPECT_EQ(shared->sources[1].parts.front().from.lower, 0.25);
  EXPECT_EQ(shared->sources[1].parts.front().to.upper, 0.75);
  EXPECT_FALSE(shared->sources[1].is_closed);
}

TEST(Overlay, HasFacesWithinFaces) {
  Drawing first, second;  // a ring, and in its hole a square with a stroke beside it
  first.add(square(0, 9));
  first.add(reversed(square(1, 8)));
  second.add(square(2, 4));
  second.add(segment({5, 5}, {6, 6}));
  const Overlaid found({first, second});
  expect_counts(found.cells(), 2, 4, 4);
  std::mt19937 random(1);
  EXPECT_EQ(expect_sound(found, random), 4);
  std::map<std::vector<int>, std::size_t> boundaries;
  for (std::uint32_t f = 1; f < found.cells().faces.size(); ++f)
    boundaries[found.cells().windings(f)] = found.cells().faces[f].boundaries.size();
  EXPECT_EQ(boundaries, (std::map<std::vector<int>, std::size_t>{{{1, 0}, 2}, {{0, 0}, 3}, {{0, 1}, 1}}));
  EXPECT_EQ(found.cells().faces[0].boundaries.size(), 1u);
  for (const ba::Overlay_face& face : found.cells().faces)
    for (const auto& boundary : face.boundaries)
      if (face.boundaries.size() == 3 && boundary.size() == 2) {  // both sides of the stroke
        EXPECT_EQ(boundary[0].edge, boundary[1].edge);
        EXPECT_NE(&boundary, &face.boundaries.front());
      }
  const std::vector<double> areas = found.areas(1e-9);
  EXPECT_EQ(areas, (std::vector<double>{4, 32, 45}));
}

TEST(Overlay, HasPointsThatAreCurves) {
  Drawing points;
  points.add(square(0, 4));
  points.add(reversed(square(1, 3)));
  for (const Point& p : {Point{2, 2}, Point{2, 2}, Point{0.5, 2}, Point{0, 2}, Point{7, 7}})
    points.add(Bezier({p, p, p}));
  for (const ba::Overlay_options& options : {ba::Overlay_options{}, AT_JOINTS}) {
    const Overlaid found({points}, options);
    // (0, 2) cuts the outer square once
    expect_counts(found.cells(), options.at_joints ? 12 : 4, options.at_joints ? 9 : 2, 3);
    std::mt19937 random(1);
    expect_sound(found, random);
    std::map<double, int> winding;  // of the face of points without edges, by x
    for (const ba::Overlay_vertex& v : found.cells().vertices)
      if (v.face) winding[v.point.x] = found.cells().windings(*v.face).front();
    EXPECT_EQ(winding, (std::map<double, int>{{0.5, 1}, {2, 0}, {7, 0}}));
    for (const ba::Overlay_vertex& v : found.cells().vertices)
      EXPECT_TRUE(!(v.point == Point{2, 2}) || found.cells().faces[*v.face].is_bounded);
  }
}

TEST(Overlay, HasOpenCurvesThatRunRoundNothing) {
  Drawing open;  // a U over the square, its ends outside
  open.add({segment({-1, 3}, {-1, 1}), segment({-1, 1}, {3, 1}), segment({3, 1}, {3, 3})});
  const Overlaid found({open, drawing_of(square(0, 2))});
  expect_counts(found.cells(), 4, 5, 3);
  EXPECT_EQ(windings_of(found.cells()), (std::vector<std::vector<int>>{{0, 0}, {0, 1}, {0, 1}}));
  for (const double area : found.areas()) EXPECT_NEAR(area, 2, 1e-15);
}

TEST(Overlay, TakesManyTreesAndNone) {
  const Filtered_tree a(drawing_of(square(0, 4))), b(drawing_of(square(2, 6))), c(drawing_of(square(3, 5)));
  const Overlay_2 cells = ba::overlay({&a, &b, &c});
  expect_counts(cells, 4, 8, 6);
  EXPECT_EQ(windings_of(cells),
            (std::vector<std::vector<int>>{{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}}));
  for (std::uint32_t f = 1; f < cells.faces.size(); ++f) {
    const int all = cells.windings(f)[0] + cells.windings(f)[1] + cells.windings(f)[2];
    EXPECT_TRUE(all != 3 || std::fabs(ba::face_area(cells, f, {&a, &b, &c}, 1e-9).lower - 1) < 1e-15);
  }
  expect_counts(ba::overlay(std::vector<const Filtered_tree*>{}), 0, 0, 1);
  expect_counts(ba::overlay(Filtered_tree(Drawing())), 0, 0, 1);
  expect_counts(ba::overlay(a, b), 2, 4, 4);
  EXPECT_THROW((void)ba::face_area(cells, 0, {&a, &b, &c}, 1e-9), std::invalid_argument);
  EXPECT_THROW((void)ba::face_area(cells, 1, {&a, &b, &c}, -1), std::invalid_argument);
}

// A curve that runs round itself twice has a face in which it does.
TEST(Overlay, CountsTurnsOfACurve) {
  const Overlaid found({drawing_of(Bezier({{0, 0}, {4, 4}, {-3, 4}, {1, 0}})),
                        drawing_of(polygon({{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 0}, {1, 0}, {1, 1}, {0, 1}}))});
  const auto windings = windings_of(found.cells());
  EXPECT_EQ(windings.back().back(), 2);
  std::mt19937 random(1);
  EXPECT_GT(expect_sound(found, random), 4);
}

// An end two ulp beside the end of another segment, and a hairpin between two lines: edges and faces of some ulp.
TEST(Overlay, HasEdgesShorterThanAnUlp) {
  Drawing ends, hairpin;
  const double end = std::nextafter(1.0, 2.0);
  ends.add(segment({0, 0}, {end, 0}));
  ends.add(segment({1, 0}, {1, 1}));
  expect_counts(Overlaid({ends}).cells(), 4, 3, 1);
  hairpin.add(Bezier({{0, 1}, {1e-15, -1}, {2e-15, 1}}));
  hairpin.add(segment({-1, 0.5}, {1, 0.5}));
  const Overlaid found({hairpin});
  expect_counts(found.cells(), 6, 6, 2);
  EXPECT_GT(found.area(1, 1e-30).upper, 0);
  EXPECT_LT(found.area(1, 1e-9).upper, 1e-15);
  // corners of the unit square nearer to each other than the parameters of either side tell
  Drawing corner;
  corner.add(segment({-1, 0}, {1, 0}));
  corner.add(segment({0, -0x1p-70}, {0x1p-70, 0x1p-71}));
  corner.add(segment({0x1p-70, -0x1p-70}, {0, 0x1p-71}));
  expect_counts(Overlaid({corner}).cells(), 9, 9, 2);
}

/// What random drawings found, one of each kind, and how many vertices, edges and faces there are.
struct Found {
  std::vector<Bezier> curves;
  std::size_t vertices, edges, faces;
};
void expect_found(const Found& found) {
  Drawing drawing;
  for (const Bezier& b : found.curves) drawing.add(b);
  const Overlaid overlaid({drawing});
  expect_counts(overlaid.cells(), found.vertices, found.edges, found.faces);
  std::mt19937 random(1);
  expect_sound(overlaid, random);
}

// A line through a loop next to its start, whose ways there are compared nearer than the line's end is known.
TEST(Overlay, OrdersWaysNextToARootOfAPolynomial) {
  expect_found({{Bezier({{-2.2200000000000002, -2.2204460492503131e-16},
                         {0, 2.2199999999999989},
                         {0, 2.2200000000000002},
                         {-2.2200000000000002, -2.2204460492503131e-16}}),
                 segment({-2.2199999999999993, -2.2204460492503131e-16}, {-0.55499999999999983, 1.6649999999999998})},
                5,
                6,
                3});
}

TEST(Overlay, HasPointsOnCurvesAtParametersThatAreNoDoubles) {
  expect_found(
      {{Bezier({{0, 2}, {0, -3}}, {3, 1}), Bezier({{2, 1}, {-2, 3}, {1, -3}, {2, 1}}), Bezier({{0, 1}, {0, 1}})},
       4,
       5,
       3});
  expect_found(
      {{Bezier({{3, 2}, {1, 1}, {-3, -1}}), Bezier({{0, 3}, {2, -1}}, {2, 2}), Bezier({{1, 1}, {1, 1}})}, 5, 4, 1});
}

// A ray at the height of a vertex where one curve has a cut of its own and another one starts.
TEST(Overlay, SendsRaysThroughVertices) {
  expect_found({{Bezier({{0, 3}, {3, -2}, {0, 3}, {3, 0}}), segment({-1, 0}, {0, 3}),
                 Bezier({{1.5, 0.75}, {-2, 2}, {3, 0}}), Bezier({{3, 0}, {2.5, -0.5}, {1.5, -0.5}}),
                 Bezier({{1.5, -0.5}, {1, 2}, {-3, -2}, {-1, 0}}), Bezier({{-0.5, 1.5}, {-3, -3}, {-2, 2}, {0, 3}})},
                7,
                10,
                5});
}

// Two crossings whose brackets are the same on one curve or on both: which parameters belong together is told exactly.
TEST(Overlay, PairsParametersOfCrossingsNextToEachOther) {
  expect_found({{segment({0, -0.20000000000000001}, {0, 0.10000000000000003}),
                 Bezier({{0.20000000000000001, 0.19999999999999998}, {0, -0.099999999999999992}}, {3, 1}),
                 Bezier({{0, -0.099999999999999992},
                         {0.3000000000000001, 0.10000000000000001},
                         {0.19999999999999996, 0.20000000000000004}}),
                 Bezier({{0.19999999999999996, 0.20000000000000004},
                         {-0.19999999999999998, -0.20000000000000007},
                         {0.20000000000000001, 0.19999999999999998}})},
                7,
                9,
                4});
  const double left = -1.4799999999999998, right = -0.7400000000000001, low = -2.2200000000000006;
  const Point start{-1.4799999999999995, 2.2199999999999993}, below{start.x, 2.2199999999999989};
  expect_found({{Bezier({start, {left, -1.4800000000000002}, {right, low}, start}),
                 Bezier({below, {left, -1.4799999999999995}, {right, low}, below})},
                4,
                8,
                6});
}

// A control point some ulp beside the end: the curve turns there, nearer to the end than cuts are told.
TEST(Overlay, HasCrossingsBehindTurnsNextToAnEnd) {
  const Point corner{-7.3999999999999995, 11.1};
  expect_found(
      {{Bezier({{3.6999999999999997, -11.1}, {-3.7000000000000006, -11.1}, {-11.1, 3.7000000000000002}, corner}),
        Bezier({corner,
                {-7.4000000000000004, 11.100000000000005},
                {-11.100000000000003, 2.2204460492503131e-16},
                {-7.3999999999999986, -7.4000000000000004}}),
        Bezier({{-6.0125000000000011, -2.7750000000000008},
                {-7.4000000000000004, 4.4408920985006262e-16},
                {-7.3999999999999995, 11.100000000000001}})},
       10,
       13,
       5});
}

// A rational piece that folds along a line encloses nothing, however it is cut.
TEST(Overlay, HasAreasBesideFoldedRationalLines) {
  Drawing drawing;
  for (const Bezier& b :
       {Bezier({{-0.5, 1}, {2, 0}}), Bezier({{2, 0}, {3, -3}, {0.375, -0.75}}),
        Bezier({{0.375, -0.75}, {-0.5, -1}, {-1, -1}, {1, 0}}), Bezier({{1, 0}, {2, 0}, {1, 2}, {-1, 1}}),
        Bezier({{3, -3}, {3, -3}, {-3, 3}, {3, -3}}, {3, 1, 2, 3})})
    drawing.add(b);
  const Overlaid found({drawing});
  ASSERT_EQ(found.cells().faces.size(), 2u);
  const ba::Measure_bounds area = found.area(1, 1e-12);
  EXPECT_EQ(area.status, ba::Query_status::COMPLETE);
  EXPECT_NEAR(area.lower, 2.7037487764390669, 1e-12);
}

TEST(Overlay, HoldsPointsThatAreNoDoubles) {
  ba::Drawing_2<Number> drawing;
  const auto add = [&](const Exact_point& p, const Exact_point& q) {
    drawing.add(ba::Bezier_curve_2<Number>(std::vector<Exact_point>{p, q}));
  };
  const Number third = Number(1) / Number(3);
  add({Number(0), third}, {Number(1), third});
  add({third, Number(0)}, {third, Number(1)});
  const Exact_tree tree(drawing);
  const Overlay_2 cells = ba::overlay(tree);
  expect_counts(cells, 5, 4, 1);
  int count = 0;
  for (const ba::Overlay_vertex& v : cells.vertices) {
    if (!(std::fabs(v.point.x - v.point.y) < 1e-9)) continue;
    ++count;
    for (const ba::Bracket& b : {v.x, v.y}) {
      EXPECT_TRUE(Number(b.lower) < third && third < Number(b.upper));
      EXPECT_LT(b.width(), 1e-14);
    }
  }
  EXPECT_EQ(count, 1);
}

TEST(Overlay, IsUndecidedWhereDoublesAlone) {
  const Double_tree a(drawing_of(circle_of_quarters())), b(drawing_of(circle_of_quarters({1, 2, 0})));
  const Overlay_2 cells = ba::overlay(a, b);
  EXPECT_EQ(cells.status, ba::Outline_status::UNDECIDED);
  EXPECT_TRUE(cells.faces.empty() && cells.edges.empty() && cells.vertices.empty());
  ASSERT_TRUE(cells.undecided);
  EXPECT_NEAR(cells.undecided->at.x, 1, 1e-6);
  EXPECT_NE(cells.undecided->a.operand, cells.undecided->b.operand);
}

/// x times a unit, some ulp away; those next to 0 are those of 1.
double nudged(std::mt19937& random, double x, double unit, int most) {
  const int ulps = std::uniform_int_distribution<int>(-most, most)(random);
  double y = x * unit;
  if (y == 0) return ulps * 0x1p-52;
  for (int i = 0; i < std::abs(ulps); ++i) y = std::nextafter(y, ulps < 0 ? -HUGE_VAL : HUGE_VAL);
  return y;
}
Drawing nudged(std::mt19937& random, const Drawing& drawing, double unit, int most) {
  Drawing result;
  for (const auto& curve : drawing.curves()) {
    std::vector<Bezier> chain;
    std::vector<Point> first;
    for (std::size_t i = 0; i < curve.beziers.size(); ++i) {
      std::vector<Point> points;
      for (const Point& p : curve.beziers[i].control_points()) {
        const double x = nudged(random, p.x, unit, most);
        points.push_back({x, nudged(random, p.y, unit, most)});
      }
      if (i > 0) points.front() = chain.back().control_points().back();
      if (i == 0) first = points;
      if (curve.is_closed && i + 1 == curve.beziers.size()) points.back() = first.front();
      chain.emplace_back(std::move(points), curve.beziers[i].weights());
    }
    result.add(std::move(chain));
  }
  return result;
}

/// Up to three operands on a small lattice: closed curves, open ones and points, and what shares parts with others.
std::vector<Drawing> random_operands(std::mt19937& random) {
  std::vector<Drawing> operands;
  for (std::size_t k = 0, count = 1 + random() % 3; k < count; ++k) {
    const bool is_related = k > 0 && random() % 2 == 0;
    operands.push_back(is_related ? related_drawing(operands.back(), random, 3, random() % 3 == 0)
                                  : random_lattice_drawing(random, 3));
  }
  Drawing& last = operands.back();
  std::vector<Bezier> open = random_lattice_chain(random, 3);
  if (random() % 3 == 0 && open.size() > 1) {
    open.pop_back();
    last.add(open);
  }
  if (random() % 4 == 0) {
    const double x = static_cast<double>(random() % 7) - 3, y = static_cast<double>(random() % 7) - 3;
    last.add(Bezier({{x, y}, {x, y}}));
  }
  return operands;
}

TEST(Overlay, IsSoundOnSmallLattices) {
  int count = 0;
  for (int i = 0; i < cases(40) && !::testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE(i);
    std::mt19937 random(static_cast<unsigned>(i));
    const ba::Overlay_options options{random() % 2 == 0};
    count += expect_sound(Overlaid(random_operands(random), options), random);
  }
  EXPECT_GT(count, 4 * cases(40));
}

TEST(Overlay, IsSoundWhereCurvesAreSomeUlpApart) {
  int count = 0;
  for (int i = 0; i < cases(30) && !::testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE(i);
    std::mt19937 random(static_cast<unsigned>(i));
    const ba::Overlay_options options{random() % 2 == 0};
    constexpr double UNITS[] = {1, 0.1, 1 / 3.0, 0.74, 3.7};
    const double unit = UNITS[random() % 5];
    std::vector<Drawing> operands;
    for (const Drawing& d : random_operands(random)) {
      operands.push_back(nudged(random, d, unit, 2));
      if (random() % 2 == 0) operands.push_back(nudged(random, d, unit, 2));
    }
    count += expect_sound(Overlaid(operands, options), random);
  }
  EXPECT_GT(count, 4 * cases(30));
}

}  // namespace test_overlay
