// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is_valid() of trees and regions sees: copies with one thing broken.

#include "../../../src/library/tree/Segment_hierarchy.h"
#include "query_drawings.h"

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>
#include <CGAL/Bounding_arcs_2/region/Bca_traits_2.h>
#include <CGAL/Bounding_arcs_2/tree/Region_hierarchy_2.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace test_check_tree {
namespace {

using namespace bounding_arcs_test;
using Tree = ba::Bounding_arc_tree_2;
using Regions = ba::Region_hierarchy_2<>;

// Regions that tell something else of its nodes.
struct Shifted_leaves : Regions {
  using Regions::Regions;
  [[nodiscard]] ba::Region_node node(const ba::Node_handle& h) const {
    ba::Region_node n = Regions::node(h);
    if (h.spiral == 1) n.t1 = std::nextafter(n.t1, 2);
    return n;
  }
};
struct Small_boxes : Regions {
  using Regions::Regions;
  [[nodiscard]] CGAL::Bbox_2 box(const ba::Node_handle& h) const {
    const CGAL::Bbox_2 b = Regions::box(h);
    if (h.is_region) return b;
    return {b.xmin(), b.ymin(), std::nextafter(b.xmax(), b.xmin()), b.ymax()};
  }
};
struct Segments_twice : Regions {
  using Regions::Regions;
  template <class Visit> void for_each_child(const ba::Node_handle& h, const Visit& visit) const {
    Regions::for_each_child(h, [&](const ba::Node_handle& child) {
      visit(child);
      if (child.is_region) visit(child);
    });
  }
};

TEST(CheckTree, HasLeavesSideBySideInBoxesThatHoldThem) {
  const Drawing drawing = ba::read_drawing(BOUNDING_ARCS_EXAMPLE_DATA "/a_wrench.json");
  EXPECT_TRUE(ba::internal::is_valid_tree(Regions(Tree(drawing), 1e-2)));
  EXPECT_FALSE(ba::internal::is_valid_tree(Shifted_leaves(Tree(drawing), 1e-2)));
  EXPECT_FALSE(ba::internal::is_valid_tree(Small_boxes(Tree(drawing), 1e-2)));
  EXPECT_FALSE(ba::internal::is_valid_tree(Segments_twice(Tree(drawing), 1e-2)));
}

// Segments whose samples are not those of their neighbours.
struct Moved_samples {
  const ba::Segment_hierarchy& curves;
  mutable ba::Spiral_piece_2 moved{};

  [[nodiscard]] std::size_t number_of_segments() const { return curves.number_of_segments(); }
  [[nodiscard]] std::uint32_t bezier_of(std::uint32_t i) const { return curves.bezier_of(i); }
  [[nodiscard]] const ba::Spiral_piece_2& piece(std::uint32_t i) const {
    moved = curves.piece(i);
    moved.last.point.x = std::nextafter(moved.last.point.x, HUGE_VAL);
    return moved;
  }
};

TEST(CheckTree, HasSamplesThatNeighboursShare) {
  const ba::Bounding_arc_tree_2 curves(drawing_of(Bezier({{0, 0}, {1, 2}, {3, -1}, {4, 0}})));
  ASSERT_GT(curves.in_unit().number_of_segments(), 1U);
  EXPECT_TRUE(ba::internal::has_shared_samples(curves.in_unit()));
  EXPECT_FALSE(ba::internal::has_shared_samples(Moved_samples{curves.in_unit()}));
}

}  // namespace
}  // namespace test_check_tree
