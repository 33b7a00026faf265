// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Curves over any number type whose exact points are known over any exact number type, and the check that a tree's
// regions over an exact kernel end in them.

#ifndef BOUNDING_ARCS_TEST_EXACT_ENDS_H
#define BOUNDING_ARCS_TEST_EXACT_ENDS_H

#include "trees.h"

#include <CGAL/Bounding_arcs_2.h>

#include <CGAL/Gmpq.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <type_traits>
#include <variant>
#include <vector>

namespace bounding_arcs_test {

/// n/30 as number type NT has it.
template <class NT> [[nodiscard]] NT thirtieth(int n) { return NT(NT(n) / NT(30)); }

/// What NT takes n/30 for, over an exact type: floating numbers are the sum of two doubles.
template <class FT, class NT> [[nodiscard]] FT exact_thirtieth(int n) {
  if constexpr (std::is_floating_point_v<NT>) {
    const NT x = thirtieth<NT>(n);
    const double high = static_cast<double>(x);
    return FT(FT(high) + FT(static_cast<double>(x - NT(high))));
  } else {
    return thirtieth<FT>(n);
  }
}

/// The cubic with control points (.1,.2), (.4,.9), (.7,.3), (1.3,.5), polynomial or with weights.
template <class NT, class Coordinate>
[[nodiscard]] ba::Bezier_curve_2<NT> cubic(const Coordinate& at, bool is_rational) {
  std::vector<NT> weights;
  if (is_rational) weights = {at(30), at(70), at(40), at(50)};
  return ba::Bezier_curve_2<NT>({{at(3), at(6)}, {at(12), at(27)}, {at(21), at(9)}, {at(39), at(15)}}, weights);
}

template <class FT>
void expect_exact_chain(const ba::Boundary_chain_2<FT>& chain, const ba::Xy<FT>& from, const ba::Xy<FT>& to) {
  EXPECT_EQ(chain[0].from, from);
  EXPECT_EQ(chain[chain.size() - 1].to, to);
  for (std::size_t i = 0; i < chain.size(); ++i) {
    EXPECT_EQ(chain[i].support.side(chain[i].from), FT(0));
    EXPECT_EQ(chain[i].support.side(chain[i].to), FT(0));
    if (i > 0) {
      EXPECT_EQ(chain[i].from, chain[i - 1].to);
    }
  }
}

/// Arcs and segments of the kernel: ends on supports, and those of neighbours the same.
template <class Kernel>
void expect_exact_chain(const std::vector<ba::Kernel_piece_2<Kernel>>& chain, const ba::Xy<typename Kernel::FT>& from,
                        const ba::Xy<typename Kernel::FT>& to) {
  using Point = typename Kernel::Circular_arc_point_2;
  std::vector<Point> ends{Point(typename Kernel::Point_2(from.x, from.y))};
  const auto is_on = [](const auto& support, const Point& p) { return Kernel().has_on_2_object()(support, p); };
  const auto follow = [&](const Point& source, const Point& target, bool reversed) {
    EXPECT_TRUE(ends.back() == (reversed ? target : source));
    ends.push_back(reversed ? source : target);
  };
  for (const ba::Kernel_piece_2<Kernel>& piece : chain) {
    if (const auto* arc = std::get_if<typename Kernel::Circular_arc_2>(&piece.curve)) {
      EXPECT_TRUE(is_on(arc->supporting_circle(), arc->source()) && is_on(arc->supporting_circle(), arc->target()));
      follow(arc->source(), arc->target(), piece.reversed);
    } else if (const auto* line = std::get_if<typename Kernel::Line_arc_2>(&piece.curve)) {
      EXPECT_TRUE(is_on(line->supporting_line(), line->source()) && is_on(line->supporting_line(), line->target()));
      follow(line->source(), line->target(), piece.reversed);
    } else {
      const auto& segment = std::get<ba::Algebraic_segment_2<Kernel>>(piece.curve);
      follow(segment.source, segment.target, piece.reversed);
    }
  }
  EXPECT_TRUE(ends.back() == Point(typename Kernel::Point_2(to.x, to.y)));
}

/// A tree over spirals of number type NT under traits over an exact kernel.
/// \param check check(traits, region, from, to) for every leaf, with the exact ends of its piece
template <class Traits, class NT, class Check> void for_exact_leaves(double eps, const Check& check) {
  using FT = typename Traits::FT;
  for (const bool is_rational : {false, true}) {
    SCOPED_TRACE(is_rational ? "rational curve" : "polynomial curve");
    const auto curve = cubic<NT>([](int n) { return thirtieth<NT>(n); }, is_rational);
    const auto exact = cubic<FT>([](int n) { return exact_thirtieth<FT, NT>(n); }, is_rational);
    const ba::Region_hierarchy_2<Traits, ba::Bezier_spiral_2<NT>> tree(ba::spiral_segments(curve), eps);
    EXPECT_EQ(tree.status(), ba::Build_status::COMPLETE);
    tree.for_each_leaf([&](const ba::Node_handle& h) {
      const ba::Region_node n = tree.node(h);
      check(tree.traits(), tree.region(n), exact.point(FT(n.t0)), exact.point(FT(n.t1)));
    });
  }
}

template <class Traits, class NT> void expect_exact_ends(double eps) {
  for_exact_leaves<Traits, NT>(eps, [](const Traits& traits, const auto& region, const auto& from, const auto& to) {
    const auto boundary = traits.construct_region_boundary_2_object()(region);
    expect_exact_chain(boundary.inner, from, to);
    expect_exact_chain(boundary.outer, from, to);
  });
}
template <class Traits, class NT> void expect_exact_ends_in_kernel(double eps) {
  using Kernel = typename Traits::Kernel;
  for_exact_leaves<Traits, NT>(eps, [](const Traits& traits, const auto& region, const auto& from, const auto& to) {
    const auto boundary = traits.construct_boundary_2_object()(region);
    expect_exact_chain<Kernel>(boundary.inner, from, to);
    expect_exact_chain<Kernel>(boundary.outer, from, to);
  });
}

}  // namespace bounding_arcs_test

#endif
