// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Is a point inside a closed curve? The answer is right for every point that doubles can name; area, length and
// centroid come as brackets.

#include <CGAL/Bounding_arcs_2.h>
#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>

#include <cstdio>

using namespace CGAL::Bounding_arcs;
using Tree = Bounding_arc_tree_2;
using Point = Default_kernel::Point_2;  // or that of any other kernel

int main() {
  const Drawing_2<double> leaf = read_drawing(BOUNDING_ARCS_EXAMPLE_DATA "/h_maple_leaf.json");
  const Tree tree(leaf);
  const Point_location_2 location(tree);
  const Xy<double> start = leaf.curves()[0].beziers[0].control_points()[0];
  for (const Point& q : {Point(0, 0), Point(5, 5), Point(start.x, start.y)}) {
    const CGAL::Bounded_side side = location.locate(q);
    std::printf("(%.6f, %.6f) is %s\n", q.x(), q.y(),
                side == CGAL::ON_BOUNDED_SIDE ? "inside" : (side == CGAL::ON_BOUNDARY ? "on the curve" : "outside"));
  }
  const Measure_bounds all = area(tree, 1e-12), round = length(tree, 1e-9);
  std::printf("area %.9f, length %.6f, centroid (%.6f, %.6f)\n", all.upper, round.upper, centroid(tree, 1e-9)->x.lower,
              centroid(tree, 1e-9)->y.lower);
}
