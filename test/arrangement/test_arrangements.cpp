// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// CGAL's arrangements over the traits: what they are made of, in any order, beside the library's own overlay, and
// CGAL's algorithms that run on them.

#include "Arrangement_shape.h"
#include "arr_functors.h"
#include "cases.h"
#include "closed_drawings.h"
#include "nudged_drawings.h"

#include <CGAL/Arr_default_overlay_traits.h>
#include <CGAL/Arr_overlay_2.h>
#include <CGAL/Arr_trapezoid_ric_point_location.h>
#include <CGAL/Arr_vertical_decomposition_2.h>
#include <CGAL/Arr_walk_along_line_point_location.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Bounding_arcs_2/arrangement/Arr_curve_traits_2.h>
#include <CGAL/Bounding_arcs_2/arrangement/face_area.h>
#include <CGAL/Bounding_arcs_2/overlay/overlay.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>
#include <CGAL/Envelope_diagram_1.h>
#include <CGAL/General_polygon_set_2.h>
#include <CGAL/Gps_traits_2.h>
#include <CGAL/envelope_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <map>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace bounding_arcs_test::arrangements {

namespace ba = CGAL::Bounding_arcs;
using Traits = ba::Arr_curve_traits_2;
using Arrangement = CGAL::Arrangement_2<Traits>;
using Bezier = ba::Bezier_curve_2<double>;
using Curves = std::vector<ba::Arr_curve_2>;

Shape shape_of(const Arrangement& arrangement) {
  Shape shape;
  for (auto v = arrangement.vertices_begin(); v != arrangement.vertices_end(); ++v)
    if (v->degree() != 2) ++shape.vertices_of_degree[v->degree()];
  shape.edges_less_vertices = static_cast<std::ptrdiff_t>(arrangement.number_of_edges()) -
                              static_cast<std::ptrdiff_t>(arrangement.number_of_vertices());
  shape.faces = arrangement.number_of_faces();
  return shape;
}

Shape shape_of_overlay(const Lattice_drawing& drawing) {
  const ba::Overlay_2 overlay = ba::overlay(ba::Bounding_arc_tree_2(drawing));
  Shape shape;
  shape.faces = overlay.faces.size();
  std::vector<std::size_t> degree(overlay.vertices.size(), 0);
  for (const ba::Overlay_2::Edge& e : overlay.edges) {
    if (!e.from) continue;
    for (const std::uint32_t end : {*e.from, *e.to}) ++degree[end];
    ++shape.edges_less_vertices;
  }
  shape.edges_less_vertices -= static_cast<std::ptrdiff_t>(degree.size());
  for (const std::size_t d : degree)
    if (d != 2) ++shape.vertices_of_degree[d];
  return shape;
}

Lattice_drawing random_pair(std::mt19937& random) {
  Lattice_drawing both = random_lattice_drawing(random, 3);
  const Lattice_drawing second =
      random() % 2 == 0 ? related_drawing(both, random, 3, false) : random_lattice_drawing(random, 3);
  for (const auto& curve : second.curves()) both.add(curve.beziers);
  return both;
}
Lattice_drawing without_points(const Lattice_drawing& drawing) {
  Lattice_drawing result;
  for (const auto& curve : drawing.curves()) {
    auto chain = curve.beziers;
    const auto is_point = [](const Lattice_curve& b) {
      const auto& p = b.control_points();
      return std::adjacent_find(p.begin(), p.end(), std::not_equal_to<>()) == p.end();
    };
    chain.erase(std::remove_if(chain.begin(), chain.end(), is_point), chain.end());
    if (!chain.empty()) result.add(std::move(chain));
  }
  return result;
}

TEST(Arrangements, AreThoseOfOverlays) {
  for (int i = 0; i < cases(60); ++i) {
    std::mt19937 random(static_cast<unsigned>(i));
    const Lattice_drawing drawing = without_points(random_pair(random));
    const Curves curves = ba::arr_curves(drawing);
    Arrangement arrangement;
    CGAL::insert(arrangement, curves.begin(), curves.end());
    ASSERT_TRUE(arrangement.is_valid()) << "case " << i;
    ASSERT_EQ(shape_of(arrangement), shape_of_overlay(drawing)) << "case " << i;
  }
}

TEST(Arrangements, OfCurvesThatDifferByRoundingAreThoseOfOverlays) {
  for (int i = 0; i < cases(20); ++i) {
    std::mt19937 random(static_cast<unsigned>(i));
    Drawing_pair pair = i % 2 == 0 ? lattice_pair(random) : scaled_pair(random);
    add_all(pair.a, pair.b);
    const Lattice_drawing drawing = without_points(pair.a);
    Arrangement arrangement;
    const Curves curves = ba::arr_curves(drawing);
    CGAL::insert(arrangement, curves.begin(), curves.end());
    ASSERT_TRUE(arrangement.is_valid()) << "case " << i;
    ASSERT_EQ(shape_of(arrangement), shape_of_overlay(drawing)) << "case " << i;
  }
}

TEST(Arrangements, AreTheSameInAnyOrder) {
  for (int i = 0; i < cases(30); ++i) {
    std::mt19937 random(static_cast<unsigned>(i));
    Curves curves = ba::arr_curves(random_pair(random));
    const Curves more = ba::arr_curves(random_lattice_drawing(random, 3));
    for (const auto& c : more) {  // open ones, too
      auto points = c.bezier().control_points();
      points.back().x += 1;
      if (!(points.back() == points.front())) curves.emplace_back(Bezier(points, c.bezier().weights()));
    }
    Arrangement at_once, one_by_one;
    CGAL::insert(at_once, curves.begin(), curves.end());
    std::shuffle(curves.begin(), curves.end(), random);
    for (const auto& c : curves) CGAL::insert(one_by_one, c);
    ASSERT_TRUE(one_by_one.is_valid()) << "case " << i;
    ASSERT_EQ(shape_of(at_once), shape_of(one_by_one)) << "case " << i;
    ASSERT_EQ(at_once.number_of_vertices(), one_by_one.number_of_vertices()) << "case " << i;
  }
}

TEST(Arrangements, OfLoopsTangenciesAndUprightPieces) {
  struct Case {
    Curves curves;
    std::size_t vertices, edges, faces;
  };
  const auto curve = [](Lattice_points points, std::vector<double> weights = {}) {
    return ba::Arr_curve_2(Bezier(std::move(points), std::move(weights)));
  };
  const ba::Arr_curve_2 arch = curve({{0, 0}, {2, 4}, {4, 0}});
  Curves circle;
  for (const auto& quarter : circle_of_quarters()) circle.push_back(ba::Arr_curve_2(quarter));
  Curves cut_circle = circle;
  cut_circle.push_back(curve({{0, -2}, {0, 2}}));
  const std::vector<Case> all = {
      {{curve({{0, 0}, {3, 2}, {-2, 2}, {1, 0}})}, 5, 5, 2},                 // a loop, and a turn on either side
      {{arch, curve({{0, 2}, {4, 2}})}, 5, 4, 1},                            // a tangent
      {{arch, curve({{2, -1}, {2, 3}}), curve({{2, 1}, {2, 4}})}, 7, 6, 1},  // upright pieces that overlap
      {{arch, arch}, 2, 1, 1},
      {{curve({{0, 0}, {2, 0}, {1, 0}})}, 3, 2, 1},                   // a fold
      {{curve({{1, 1}, {1, 1}}), curve({{0, 0}, {2, 2}})}, 3, 2, 1},  // a point on a line
      {circle, 4, 4, 2},
      {cut_circle, 6, 7, 3},
  };
  for (std::size_t i = 0; i < all.size(); ++i) {
    Arrangement arrangement;
    CGAL::insert(arrangement, all[i].curves.begin(), all[i].curves.end());
    EXPECT_TRUE(arrangement.is_valid()) << "case " << i;
    EXPECT_EQ(arrangement.number_of_vertices(), all[i].vertices) << "case " << i;
    EXPECT_EQ(arrangement.number_of_edges(), all[i].edges) << "case " << i;
    EXPECT_EQ(arrangement.number_of_faces(), all[i].faces) << "case " << i;
  }
}

// What random curves found, one of each kind.
TEST(Arrangements, AreTheSameInAnyOrderWhereThingsMeet) {
  const auto curve = [](Lattice_points points, std::vector<double> weights = {}) {
    return ba::Arr_curve_2(Bezier(std::move(points), std::move(weights)));
  };
  const std::vector<Curves> all = {
      // x and w of the line have a common root, outside of it
      {curve({{1, -2}, {1, 2}}, {2, 1}), curve({{-2, 2}, {0, -3}, {2, 3}}, {3, 3, 3})},
      // a crossing with one way of a fold is on its way back, too
      {curve({{1, -3}, {-2, 1}, {1, -3}}), curve({{-1, 0}, {0, 0}, {-1, -3}, {-1, 0}}, {1, 2, 2, 1})},
      // a double point is an end of a part at its second parameter
      {curve({{3, -3}, {-2, -1}, {2, 3}, {1, 3}, {1, -3}}, {2, 3, 3, 1, 2}), curve({{1, 0}, {1, -2}})},
  };
  for (std::size_t i = 0; i < all.size(); ++i) {
    Arrangement at_once, one_by_one;
    CGAL::insert(at_once, all[i].begin(), all[i].end());
    for (std::size_t k = all[i].size(); k-- > 0;) CGAL::insert(one_by_one, all[i][k]);
    EXPECT_TRUE(at_once.is_valid()) << "case " << i;
    EXPECT_EQ(shape_of(at_once), shape_of(one_by_one)) << "case " << i;
  }
}

Arrangement arrangement_of(const Curves& curves) {
  Arrangement arrangement;
  CGAL::insert(arrangement, curves.begin(), curves.end());
  return arrangement;
}

TEST(Arrangements, OfOverlaysAreThoseOfAllCurves) {
  for (int i = 0; i < cases(10); ++i) {
    std::mt19937 random(static_cast<unsigned>(i));
    const Curves a = ba::arr_curves(random_pair(random)), b = ba::arr_curves(random_lattice_drawing(random, 3));
    Curves all = a;
    all.insert(all.end(), b.begin(), b.end());
    Arrangement both;
    CGAL::overlay(arrangement_of(a), arrangement_of(b), both);
    ASSERT_EQ(shape_of(both), shape_of(arrangement_of(all))) << "case " << i;
  }
}

// Both ways of point location find one face, edge or vertex.
TEST(Arrangements, LocatePoints) {
  std::mt19937 random(5);
  for (int i = 0; i < cases(3); ++i) {
    const Arrangement arrangement = arrangement_of(ba::arr_curves(random_pair(random)));
    const CGAL::Arr_walk_along_line_point_location<Arrangement> walk(arrangement);
    const CGAL::Arr_trapezoid_ric_point_location<Arrangement> trapezoids(arrangement);
    for (int x = -8; x <= 8; ++x)
      for (int y = -8; y <= 8; ++y) {
        const ba::Arr_point_2 q(x * 0.5, y * 0.5);
        ASSERT_TRUE(walk.locate(q) == trapezoids.locate(q)) << q;
      }
    std::vector<std::pair<Arrangement::Vertex_const_handle, std::pair<CGAL::Object, CGAL::Object>>> above_and_below;
    CGAL::decompose(arrangement, std::back_inserter(above_and_below));
    ASSERT_EQ(above_and_below.size(), arrangement.number_of_vertices());
  }
}

TEST(Arrangements, HaveEnvelopes) {
  const Curves curves = {ba::Arr_curve_2(Bezier({{0, 0}, {2, 4}, {4, 0}})), ba::Arr_curve_2(Bezier({{0, 1}, {4, 1}}))};
  CGAL::Envelope_diagram_1<Traits> below;
  CGAL::lower_envelope_2(curves.begin(), curves.end(), below);
  int edges = 0;
  for (auto e = below.leftmost(); e != below.rightmost(); e = e->right()->right()) edges += e->is_empty() ? 0 : 1;
  EXPECT_EQ(edges, 3);  // arch, line, arch
}

TEST(Arrangements, CarryPolygonSets) {
  using Polygon_traits = CGAL::Gps_traits_2<Traits>;
  const auto disc = [](double x, double y) {
    Lattice_drawing drawing;
    drawing.add(circle_of_quarters({2, x, y}));
    return drawing;
  };
  const auto polygon = [](const Lattice_drawing& drawing) {
    const std::vector<ba::Arr_curve_2::Part> parts =
        bounding_arcs_test::arr_curve_traits::parts_of(Traits(), ba::arr_curves(drawing));
    return Polygon_traits::Polygon_2(parts.begin(), parts.end());
  };
  const Lattice_drawing a = disc(0, 0), b = disc(2, 1), c = disc(9, 0);
  CGAL::General_polygon_set_2<Polygon_traits> set;
  for (const Lattice_drawing* d : {&a, &b, &c}) set.join(polygon(*d));
  EXPECT_EQ(set.number_of_polygons_with_holes(), 2U);
  EXPECT_EQ(set.oriented_side(ba::Arr_point_2(1, 0.5)), CGAL::ON_POSITIVE_SIDE);
  EXPECT_EQ(set.oriented_side(ba::Arr_point_2(6, 0)), CGAL::ON_NEGATIVE_SIDE);
  set.difference(polygon(a));
  EXPECT_EQ(set.oriented_side(ba::Arr_point_2(1, 0.5)), CGAL::ON_NEGATIVE_SIDE);
  EXPECT_EQ(set.oriented_side(ba::Arr_point_2(3, 1)), CGAL::ON_POSITIVE_SIDE);
}

Arrangement arrangement_of(const Lattice_drawing& drawing) {
  const Curves curves = ba::arr_curves(drawing);
  Arrangement arrangement;
  CGAL::insert(arrangement, curves.begin(), curves.end());
  return arrangement;
}

// Of polygons of many corners on the face's boundaries.
double sampled_area(Arrangement::Face_const_handle face) {
  double sum = 0;
  const auto add = [&](Arrangement::Ccb_halfedge_const_circulator first) {
    constexpr int SAMPLES = 2000;
    auto edge = first;
    do {
      const auto& part = edge->curve();
      double from = part.left_parameter().middle(), to = part.right_parameter().middle();
      if (edge->direction() != CGAL::ARR_LEFT_TO_RIGHT) std::swap(from, to);
      auto before = part.curve().bezier().point(from);
      for (int i = 1; i <= SAMPLES; ++i) {
        const auto p = part.curve().bezier().point(from + (to - from) * i / SAMPLES);
        sum += cross(before, p) / 2;
        before = p;
      }
    } while (++edge != first);
  };
  for (auto outer = face->outer_ccbs_begin(); outer != face->outer_ccbs_end(); ++outer) add(*outer);
  for (auto inner = face->inner_ccbs_begin(); inner != face->inner_ccbs_end(); ++inner) add(*inner);
  return sum;
}

TEST(Arrangements, HaveFacesOfKnownArea) {
  for (int i = 0; i < cases(60); ++i) {
    std::mt19937 random(static_cast<unsigned>(i));
    const Arrangement arrangement = arrangement_of(random_pair(random));
    constexpr double EPS = 1e-9;
    for (auto face = arrangement.faces_begin(); face != arrangement.faces_end(); ++face) {
      if (face->is_unbounded()) continue;
      const ba::Measure_bounds area = ba::face_area(face, EPS);
      EXPECT_EQ(area.status, ba::Query_status::COMPLETE) << "case " << i;
      EXPECT_LE(area.upper - area.lower, EPS) << "case " << i;
      EXPECT_GT(area.upper, 0) << "case " << i;
      EXPECT_NEAR(area.lower, sampled_area(face), 1e-5) << "case " << i;
    }
  }
}

TEST(Arrangements, HaveFacesWhoseAreasHoldTheExactOnes) {
  Lattice_drawing drawing;  // a ring, and two circles of radius 2 that meet, of which one is around a hole
  drawing.add(circle_of_quarters({2, 0, 0}));
  drawing.add(circle_of_quarters({2, 2, 0}));
  drawing.add(circle_of_quarters({0.5, -1, 0}));
  const Arrangement arrangement = arrangement_of(drawing);
  const double disc = 3.14159265358979324, lens = 8 * disc / 3 - 2 * std::sqrt(3.0);  // 4 (2 pi / 3 - sqrt(3) / 2)
  std::vector<double> areas;
  for (auto face = arrangement.faces_begin(); face != arrangement.faces_end(); ++face) {
    if (face->is_unbounded()) {
      EXPECT_THROW((void)ba::face_area(face, 1e-9), std::invalid_argument);
      continue;
    }
    EXPECT_THROW((void)ba::face_area(face, -1), std::invalid_argument);
    const ba::Measure_bounds area = ba::face_area(face, 1e-11);
    EXPECT_LE(area.upper - area.lower, 1e-11);
    areas.push_back(area.lower);
  }
  std::sort(areas.begin(), areas.end());
  const std::vector<double> known = {disc / 4, lens, 4 * disc - lens - disc / 4, 4 * disc - lens};
  ASSERT_EQ(areas.size(), known.size());
  for (std::size_t i = 0; i < known.size(); ++i) EXPECT_NEAR(areas[i], known[i], 1e-11);
}

TEST(Arrangements, HaveFacesBesideAntennasAndVerticesOfAlgebraicParameters) {
  Lattice_drawing drawing;  // y = x^2 under y = 2: from -sqrt(2) to sqrt(2); a stroke that ends within
  drawing.add(Bezier({{-2, 4}, {0, -4}, {2, 4}}));
  drawing.add(Bezier({{-2, 2}, {2, 2}}));
  drawing.add(Bezier({{0, 2}, {0, 1}}));
  const Arrangement arrangement = arrangement_of(drawing);
  ASSERT_EQ(arrangement.number_of_faces(), 2U);
  for (auto face = arrangement.faces_begin(); face != arrangement.faces_end(); ++face) {
    if (face->is_unbounded()) continue;
    const ba::Measure_bounds area = ba::face_area(face, 1e-14);
    const double exact = 8 * std::sqrt(2.0) / 3;
    EXPECT_LE(area.lower, exact + 1e-15);
    EXPECT_GE(area.upper, exact - 1e-15);
    EXPECT_LE(area.upper - area.lower, 2e-15);
  }
}

}  // namespace bounding_arcs_test::arrangements
