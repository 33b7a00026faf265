// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A tree cuts each Bezier piece of its curves once, and whatever descends it cuts none again.

#include "../../../src/library/spiral/spiral_cuts.h"
#include "../../../src/library/tree/Segment_hierarchy.h"
#include "query_drawings.h"

#include <CGAL/Bounding_arcs_2.h>
#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>
#include <CGAL/Bounding_arcs_2/spiral/spiral_parameters.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace test_cuts {
namespace {

using namespace bounding_arcs_test;
using ba::Bounding_arc_tree_2;

template <class Ask> std::size_t cuts_of(const Ask& ask) {
  const std::size_t before = ba::internal::cut_count();
  ask();
  return ba::internal::cut_count() - before;
}

Drawing bundled(const std::string& name) { return ba::read_drawing(BOUNDING_ARCS_EXAMPLE_DATA "/" + name + ".json"); }
std::size_t pieces_of(const Drawing& drawing) {
  std::size_t count = 0;
  for (const auto& curve : drawing.curves()) count += curve.beziers.size();
  return count;
}

TEST(Cuts, AreMadeByTheTreeAlone) {
  const Drawing drawing = bundled("d_rabbit"), other = moved(bundled("f_crow"), 1, {0.3, 0.2});
  EXPECT_EQ(cuts_of([&] { Bounding_arc_tree_2 made(drawing); }), pieces_of(drawing));
  const Bounding_arc_tree_2 a(drawing), b(other);
  const auto expect_none = [](const char* what, const auto& ask) { EXPECT_EQ(cuts_of(ask), 0U) << what; };
  expect_none("closest point", [&] { (void)ba::closest_point(a, {1, 1}); });
  expect_none("intersections", [&] { (void)ba::intersections(a, b); });
  expect_none("self-intersections", [&] { (void)ba::self_intersections(a); });
  expect_none("distance", [&] { (void)ba::distance(a, b); });
  expect_none("Hausdorff distance", [&] { (void)ba::hausdorff_distance(a, b, 1e-3); });
  expect_none("location", [&] { (void)ba::locate(a, {1, 1}); });
  expect_none("rays", [&] { (void)ba::ray_hits(a, {1, 1}, {1, 0}); });
  expect_none("hull", [&] { (void)ba::convex_hull(a, 1e-6); });
  expect_none("circle", [&] { (void)ba::smallest_enclosing_circle(a, 1e-6); });
  expect_none("length", [&] { (void)ba::length(b, 1e-6); });  // of no B-splines, whose exact pieces it asks
  expect_none("chain", [&] { (void)ba::arc_chain(a, 1e-4); });
  expect_none("offset", [&] { (void)ba::offset(a, 0.1, 1e-4); });
  expect_none("insets", [&] { (void)ba::insets(a, 0.1, 1e-4); });
  expect_none("opening", [&] { (void)ba::opening(a, 0.05, 1e-4); });
  expect_none("overlay", [&] { (void)ba::overlay(a, b); });
  expect_none("union", [&] { (void)ba::unite(a, b); });
  expect_none("outline", [&] { (void)ba::outline(a); });
  expect_none("clip", [&] { (void)ba::clip(a, b); });
  expect_none("axis", [&] { (void)ba::medial_axis(a, 1e-4); });
  expect_none("regions", [&] { (void)ba::Region_hierarchy_2<>(a, 1e-4); });
  expect_none("copy", [&] {
    const Bounding_arc_tree_2 copy = a;
    (void)copy;
  });
}

TEST(Cuts, AreThoseOfReplacedCurves) {
  Drawing drawing;
  for (int i = 0; i < 8; ++i) drawing.add(Bezier({{2.0 * i, 0}, {2.0 * i, 1}, {2.0 * i + 1, 1}, {2.0 * i + 1, 0}}));
  Bounding_arc_tree_2 tree(drawing);
  const Drawing other = drawing_of(Bezier({{4, 0}, {4, 2}, {5, 1}, {5, 0}}));
  EXPECT_EQ(cuts_of([&] { tree.replace(2, 3, other); }), 1U);
  EXPECT_EQ(cuts_of([&] { tree.replace(2, 3, Drawing()); }), 0U);
}

// Trees of other sizes meet in the unit of the larger one, bit for bit as if they were cut there.
TEST(Cuts, AreThoseOfTheTreeInOtherUnits) {
  std::mt19937 random(3);
  for (int i = 0; i < 20; ++i) {
    const Drawing drawing = random_drawing(random);
    const Drawing small = moved(drawing, 0x1p-90, {});
    const Bounding_arc_tree_2 tree(small), large(random_drawing(random));
    EXPECT_EQ(cuts_of([&] { (void)ba::distance(tree, large); }), 0U);
    EXPECT_EQ(cuts_of([&] { (void)ba::overlay(tree, large); }), 0U) << i;
    const auto again = tree.in_unit(ba::internal::Unit());
    const ba::Segment_hierarchy cut(std::make_shared<const Drawing>(small), ba::Decisions::EXACT);
    ASSERT_EQ(again->number_of_segments(), cut.number_of_segments());
    for (std::uint32_t s = 0; s < cut.number_of_segments(); ++s) {
      for (const auto end : {&ba::Spiral_piece_2::first, &ba::Spiral_piece_2::last}) {
        const ba::Spiral_sample p = again->piece(s).*end, q = cut.piece(s).*end;
        EXPECT_TRUE(p.t == q.t && p.point == q.point && p.tangent == q.tangent && p.tangent_error == q.tangent_error &&
                    p.most_curvature == q.most_curvature)
            << i << ' ' << s;
      }
      EXPECT_EQ(again->error(s), cut.error(s));
    }
  }
}

// Roots are isolated once also where regions are made over other numbers.
TEST(Cuts, AreThoseOfTheTreeOverOtherKernels) {
  using Exact_kernel = CGAL::Simple_cartesian<CGAL::Exact_rational>;
  using Traits = ba::Bca_traits_2<
      CGAL::Circular_kernel_2<Exact_kernel, CGAL::Algebraic_kernel_for_circles_2_2<CGAL::Exact_rational>>>;
  const Bounding_arc_tree_2 tree(Bezier({{0, 0}, {1, 2}, {3, -1}, {4, 0}}));
  EXPECT_EQ(cuts_of([&] { (void)ba::Region_hierarchy_2<Traits>(tree, 1e-2); }), 0U);
}

}  // namespace
}  // namespace test_cuts
