// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The convex hull of two curves: parts of them, and segments that touch them; and the smallest circle around both.

#include <CGAL/Bounding_arcs_2.h>

#include <cstdio>

using namespace CGAL::Bounding_arcs;

int main() {
  Drawing_2<double> drawing;
  drawing.add(Bezier_curve_2<double>({{-1, 1}, {0, -1}, {1, 1}}), "y = x^2");
  drawing.add(Bezier_curve_2<double>({{2, -1}, {3, 1}, {4, -1}}), "an arch");
  const Bounding_arc_tree_2 tree(drawing);
  for (const auto& p : convex_hull(tree, 1e-9).pieces)
    std::printf("%s from (%.6f, %.6f) to (%.6f, %.6f)\n", p.is_bitangent ? "segment" : "curve", p.from_point.x(),
                p.from_point.y(), p.to_point.x(), p.to_point.y());
  const auto circle = smallest_enclosing_circle(tree, 1e-9).value();
  std::printf("circle about (%.6f, %.6f) with radius %.6f\n", circle.center.x(), circle.center.y(),
              circle.radius.upper);
  std::printf("width %.6f, diameter %.6f\n", width(tree, 1e-7)->width.upper, diameter(tree, 1e-7)->diameter.upper);
}
