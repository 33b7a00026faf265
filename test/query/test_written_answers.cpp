// Copyright (c) 2026 The Bounding Arcs authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Answers as text: members in their order, a line for each entry of a list.

#include <CGAL/Bounding_arcs_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <string>

namespace test_written_answers {
namespace {

namespace ba = CGAL::Bounding_arcs;
using Bezier = ba::Bezier_curve_2<double>;

template <class T> std::string written(const T& x) {
  std::ostringstream out;
  out << x;
  return out.str();
}

ba::Bounding_arc_tree_2 segment(double x0, double y0, double x1, double y1) {
  return ba::Bounding_arc_tree_2(Bezier({{x0, y0}, {x1, y1}}));
}

TEST(WrittenAnswers, HaveTheNumbersOfTheirMembersInOrder) {
  const auto flat = segment(0, 0, 4, 0);
  const auto found = ba::closest_point(flat, {1, 2});
  ASSERT_TRUE(found);
  const std::string place = written(found->place);
  EXPECT_EQ(place, "0 0 0.25");
  EXPECT_EQ(written(*found), written(found->distance) + " " + written(found->point) + " " + place);
  EXPECT_EQ(written(ba::Bracket{1, 2.5}), "1 2.5");
  EXPECT_EQ(written(ba::Xy<double>{-1, 0.5}), "-1 0.5");
  const auto gap = ba::distance(flat, segment(1, 1, 1, 2));
  ASSERT_TRUE(gap);
  EXPECT_EQ(written(*gap), written(gap->distance) + " " + written(gap->a) + " " + written(gap->b));
}

TEST(WrittenAnswers, HaveALineForEachEntry) {
  const auto flat = segment(0, 0, 4, 0);
  const auto crossing = ba::intersections(flat, segment(1, -1, 1, 1)), along = ba::intersections(flat, flat);
  ASSERT_EQ(crossing.points.size(), 1U);
  EXPECT_EQ(written(crossing), "1 0 0 0 0.25 0.25 0 0 0.5 0.5\n");
  EXPECT_EQ(written(along), "0 0 0 0 0 0 1 1 0 0 0 0 0 0 1 1\n");
  EXPECT_EQ(written(Bezier({{0, 0}, {1, 2}, {3, 0}})), "0 0\n1 2\n3 0\n");
  EXPECT_EQ(written(Bezier({{0, 0}, {1, 2}, {3, 0}}, {1, 2, 1})), "0 0 1\n1 2 2\n3 0 1\n");
  EXPECT_EQ(written(ba::B_spline_curve_2<double>(1, {{0, 0}, {1, 2}}, {0, 0, 1, 1})), "1 0 0 1 1\n0 0\n1 2\n");
}

TEST(WrittenAnswers, HaveAnEmptyLineBehindEachChain) {
  ba::Drawing_2<double> square;
  square.add({Bezier({{0, 0}, {1, 0}}), Bezier({{1, 0}, {1, 1}}), Bezier({{1, 1}, {0, 0}})});
  const ba::Bounding_arc_tree_2 tree(square);
  const std::string outline = written(ba::outline(tree));
  EXPECT_EQ(std::count(outline.begin(), outline.end(), '\n'), 4);
  EXPECT_EQ(outline.substr(outline.size() - 2), "\n\n");
  EXPECT_EQ(written(square), "0 0\n1 0\n\n1 0\n1 1\n\n1 1\n0 0\n\n");
}

TEST(WrittenAnswers, HaveALineForEachSampleOfAnAxis) {
  ba::Drawing_2<double> square;
  square.add({Bezier({{0, 0}, {2, 0}}), Bezier({{2, 0}, {2, 2}}), Bezier({{2, 2}, {0, 2}}), Bezier({{0, 2}, {0, 0}})});
  const ba::Medial_axis_2 axis = ba::medial_axis(ba::Bounding_arc_tree_2(square), 1e-3);
  std::ptrdiff_t lines = 0;
  for (const ba::Medial_axis_2::Edge& edge : axis.edges) lines += static_cast<std::ptrdiff_t>(edge.samples.size()) + 1;
  const std::string text = written(axis);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), lines);
  const ba::Medial_axis_2::Sample& first = axis.edges.front().samples.front();
  EXPECT_EQ(text.substr(0, text.find('\n')), written(first));
  EXPECT_EQ(written(first), written(first.center) + " " + written(first.radius) + " " + written(first.left) + " " +
                                written(first.right));
}

}  // namespace
}  // namespace test_written_answers
