// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Is a point inside a closed curve? The answer is right for every point that doubles can name; area, length and
// centroid come as brackets.

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>
#include <CGAL/Bounding_arcs_2/query/measures.h>
#include <CGAL/Bounding_arcs_2/query/point_location.h>

#include <cstdio>

using namespace CGAL::Bounding_arcs;

int main() {
  const Curve_index_2 index(read_drawing(BOUNDING_ARCS_EXAMPLE_DATA "/h_maple_leaf.json"));
  const Point_location_2 location(index);
  const Xy<double> on_curve = index.piece(0).first.point;
  for (const Xy<double>& q : {Xy<double>{0, 0}, Xy<double>{5, 5}, on_curve}) {
    const Point_side side = location.locate(q);
    std::printf("(%.6f, %.6f) is %s\n", q.x, q.y,
                side == Point_side::INSIDE ? "inside" : (side == Point_side::ON ? "on the curve" : "outside"));
  }
  const Measure_bounds all = area(index, 1e-12), round = length(index, 1e-9);
  std::printf("area %.9f, length %.6f, centroid (%.6f, %.6f)\n", all.upper, round.upper, centroid(index, 1e-9)->x.lower,
              centroid(index, 1e-9)->y.lower);
}
