// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Regions of all three kinds are proven to hold a curve's pieces and to be thin. A distance is where samples have it.

#include <CGAL/Bounding_arcs_2.h>
#include <CGAL/Bounding_arcs_2/verify/verify_region.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iostream>

using namespace CGAL::Bounding_arcs;

const Bezier_curve_2<double> CURVE({{0, 0.6}, {6.4, 3}, {-2.4, 3.4}, {3, 0}});

template <class Construction> void test_regions() {
  for (const Bezier_spiral_2<double>& s : spiral_segments(CURVE)) {
    const double thickness = Construction::thickness(s.shape<double>(s.first(), s.last()));
    assert(verify_region<Construction>(s, s.first(), s.last()).holds());
    assert(verify_thickness<Construction>(s, s.first(), s.last(), thickness * (1 + 1e-12)));
  }
}

void test_distance() {
  const Bounding_arc_tree_2 tree(CURVE);
  const Xy<double> q{1, 5};
  const auto found = closest_point(tree, q);
  assert(found);
  double least = HUGE_VAL;
  constexpr int SAMPLES = 10000;
  for (int i = 0; i <= SAMPLES; ++i) {
    const Xy<double> p = CURVE.point(static_cast<double>(i) / SAMPLES);
    least = (std::min)(least, std::hypot(p.x - q.x, p.y - q.y));
  }
  assert(found->distance.lower <= least && least <= found->distance.upper + 1e-6);
}

int main() {
  test_regions<Bca>();
  test_regions<Spiral_fat_arc>();
  test_regions<Bilens>();
  test_distance();
  std::cout << "done\n";
}
