// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What do two drawings have in common? Crossings, points where they only touch, and parts along which they run
// together, each with its place on both curves. No epsilon decides: what doubles leave open is asked for exactly.

#include <CGAL/Bounding_arcs_2.h>

#include <cstdio>

using namespace CGAL::Bounding_arcs;

using Tree = Bounding_arc_tree_2;
using Point = Default_kernel::Point_2;  // or that of any other kernel

void print(const char* what, const Intersections_2<Point>& found) {
  std::printf("%s: %zu points, %zu overlaps\n", what, found.points.size(), found.overlaps.size());
  for (const auto& p : found.points)
    std::printf("  (%.6f, %.6f), %s, t = %.6f and %.6f\n", p.point.x(), p.point.y(),
                p.kind == Intersection_kind::TANGENTIAL ? "touching" : "crossing", p.a.t.lower, p.b.t.lower);
}

int main() {
  Drawing_2<double> drawing;
  drawing.add(Bezier_curve_2<double>({{-1, 1}, {0, -1}, {1, 1}}));  // y = x^2
  const Tree parabola(drawing);
  print("the line y = x + 1/8", intersections(parabola, Tree(line_drawing(parabola, {0, 0.125}, {1, 1}))));
  print("the tangent y = 0", intersections(parabola, Tree(line_drawing(parabola, {0, 0}, {1, 0}))));
  print("a line 1e-300 below", intersections(parabola, Tree(line_drawing(parabola, {0, -1e-300}, {1, 0}))));
  print("its osculating circle", intersections(parabola, Tree(circle_drawing({0, 0.5}, 0.5))));
  Drawing_2<double> half;
  half.add(drawing.curves()[0].beziers[0].split(0.5).second);
  print("its own right half", intersections(parabola, Tree(half)));
}
