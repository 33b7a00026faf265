// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What tests of intersections share: trees of single chains, and comparison with exact common points.

#ifndef BOUNDING_ARCS_TEST_INTERSECTION_CHECKS_H
#define BOUNDING_ARCS_TEST_INTERSECTION_CHECKS_H

#include <CGAL/Bounding_arcs_2/query/intersections.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace bounding_arcs_test {

namespace ba = CGAL::Bounding_arcs;

inline ba::Bounding_arc_tree_2 index_of(std::vector<ba::Bezier_curve_2<double>> chain,
                                        ba::Decisions decisions = ba::Decisions::EXACT) {
  ba::Drawing_2<double> drawing;
  drawing.add(std::move(chain));
  return ba::Bounding_arc_tree_2(drawing, decisions);
}
inline std::string text_of(const ba::Bezier_curve_2<double>& b) {
  std::string text;
  for (const auto& p : b.control_points()) text += "(" + std::to_string(p.x) + "," + std::to_string(p.y) + ") ";
  for (const double w : b.weights()) text += std::to_string(w) + " ";
  return text;
}

inline bool touch(const ba::Bracket& p, const ba::Bracket& q) { return p.lower <= q.upper && q.lower <= p.upper; }

// Both lists have the same points: ranges that meet, and the same kinds.
inline void expect_same(const ba::Piece_intersections& exact, const ba::Intersections_2<>& found,
                        const std::string& place) {
  ASSERT_EQ(exact.points.size(), found.points.size()) << place;
  ASSERT_EQ(exact.overlaps.size(), found.overlaps.size()) << place;
  for (const ba::Piece_intersections::Intersection& p : exact.points) {
    bool is_found = false;
    for (const ba::Intersections_2<>::Intersection& q : found.points)
      is_found = is_found || (touch(p.a, q.a.t) && touch(p.b, q.b.t) && p.kind == q.kind);
    EXPECT_TRUE(is_found) << place << " t " << p.a.lower << " s " << p.b.lower;
  }
}
inline void expect_same(const ba::Piece_intersections& exact, const ba::Piece_intersections& found,
                        const std::string& place) {
  ASSERT_EQ(exact.points.size(), found.points.size()) << place;
  ASSERT_EQ(exact.overlaps.size(), found.overlaps.size()) << place;
  for (std::size_t i = 0; i < exact.points.size(); ++i) {
    bool is_found = false;
    for (const ba::Piece_intersections::Intersection& q : found.points)
      is_found = is_found ||
                 (touch(exact.points[i].a, q.a) && touch(exact.points[i].b, q.b) && exact.points[i].kind == q.kind);
    EXPECT_TRUE(is_found) << place << " t " << exact.points[i].a.lower << " s " << exact.points[i].b.lower;
  }
}

}  // namespace bounding_arcs_test

#endif
