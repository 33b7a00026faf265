// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where is a drawing nearest to a point, and how far away is it? The answer is a place on a curve, and two bounds
// between which the true distance lies.

#include <CGAL/Bounding_arcs_2.h>
#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>

#include <cstdio>

using namespace CGAL::Bounding_arcs;
using Tree = Bounding_arc_tree_2;
using Point = Default_kernel::Point_2;  // or that of any other kernel

int main() {
  const Tree tree(read_drawing(BOUNDING_ARCS_EXAMPLE_DATA "/d_rabbit.json"));
  for (const Point& q : {Point(0, 0), Point(1, 1), Point(-3, 40)}) {
    const auto found = *closest_point(tree, q);  // nothing only of an empty drawing
    std::printf("(%g, %g): distance %.6f, bracket %s, at (%.6f, %.6f), piece %u, t = %.6f\n", q.x(), q.y(),
                found.distance.upper,
                found.distance.upper - found.distance.lower < 1e-13 ? "narrower than 1e-13" : "wide", found.point.x(),
                found.point.y(), found.place.bezier, found.place.t);
  }
}
