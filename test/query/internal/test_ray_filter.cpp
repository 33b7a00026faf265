// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Hits that doubles tell, beside those of exact arithmetic.

#include "../../../src/library/tree/Segment_hierarchy.h"
#include "cases.h"
#include "closed_drawings.h"

#include "../../../src/library/query/Ray_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace test_ray_filter {
namespace {

using namespace bounding_arcs_test;
namespace ba = CGAL::Bounding_arcs;
using ba::Bounding_arc_tree_2;
using Point = ba::Xy<double>;
using Exact = CGAL::Exact_rational;

TEST(RayFilter, HitsAreThoseOfExactArithmetic) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> unit(-1, 1);
  const Placing places[] = {{}, {1e-9, 0, 0}, {1e9, 0, 0}, {1, 1e8, -3e8}, {1.0 / 3, 0.1, 0.7}};
  int told = 0, rays = 0;
  for (int i = 0; i < cases(300); ++i) {
    const Placing& place = places[i % 5];
    const Bounding_arc_tree_2 index(random_lattice_drawing(random, 3, place));
    for (int k = 0; k < 5; ++k, ++rays) {
      // one in five touches the curve but for rounding
      const ba::Spiral_sample& sample = index.in_unit().piece(0).last;
      const Point q = k == 4 ? sample.point - place.scale * sample.tangent : place(4 * unit(random), 4 * unit(random)),
                  d = k == 4 ? sample.tangent : Point{unit(random), unit(random)};
      ba::internal::Ray_search search(index.in_unit(), q, d);
      const auto found =
          ba::internal::Ray_filter(index.in_unit(), q, ba::internal::Ray_search::scaled(d)).hits(search.segments());
      if (!found) continue;
      ++told;
      const std::vector<ba::internal::Exact_hit> exact = search.search();
      ASSERT_EQ(found->size(), exact.size()) << i << ' ' << k;
      for (std::size_t h = 0; h < exact.size(); ++h) {
        EXPECT_EQ(index.in_unit().bezier_of((*found)[h].segment), index.in_unit().bezier_of(exact[h].piece->segment));
        const double t = CGAL::to_double(exact[h].t.lower());
        EXPECT_NEAR((*found)[h].t, t, 0x1p-50);
        // squares of distances, exactly
        const Exact x = exact[h].way.low, y = exact[h].way.high, norm = Exact(d.x) * d.x + Exact(d.y) * d.y,
                    low = (*found)[h].distance.lower, high = (*found)[h].distance.upper;
        EXPECT_TRUE(low * low * norm <= y * y && x * x <= high * high * norm) << i << ' ' << k;
        EXPECT_LE((*found)[h].distance.upper, (*found)[h].distance.lower * (1 + 0x1p-50));
      }
    }
  }
  EXPECT_GT(told, rays * 3 / 4);
}

}  // namespace
}  // namespace test_ray_filter
