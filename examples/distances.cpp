// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How near do two drawings come, and how far is a point of one from the other at most (the Hausdorff distance)? Both
// with the points between which that is.

#include <CGAL/Bounding_arcs_2.h>

#include <cstdio>

using namespace CGAL::Bounding_arcs;

using Tree = Bounding_arc_tree_2;
using Point = Default_kernel::Point_2;  // or that of any other kernel

void print(const char* what, const Drawing_distance<Point>& d) {
  std::printf("%s: %.9f from (%.6f, %.6f) to (%.6f, %.6f)\n", what, d.distance.upper, d.a.point.x(), d.a.point.y(),
              d.b.point.x(), d.b.point.y());
}

int main() {
  Drawing_2<double> drawing;
  drawing.add(Bezier_curve_2<double>({{0, 2}, {1, 4}, {2, 0}, {3, 3}}), "wave");
  const Tree wave(drawing), circle(circle_drawing({1, 0}, 0.5));
  print("least distance", distance(wave, circle).value());
  print("Hausdorff distance", hausdorff_distance(wave, circle, 1e-12).value());
  print("from the circle to the wave", directed_hausdorff_distance(circle, wave, 1e-12).value());
}
