// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The medial axis of a drop with a hole: where it ends and branches, and the largest disc inside.

#include <CGAL/Bounding_arcs_2.h>

#include <cstdio>

using namespace CGAL::Bounding_arcs;

int main() {
  Drawing_2<double> drawing;
  drawing.add(Bezier_curve_2<double>({{1, 0}, {9, 8}, {-7, 8}, {1, 0}}), "a drop");
  drawing.add({Bezier_curve_2<double>({{0.5, 4}, {1.5, 4}}), Bezier_curve_2<double>({{1.5, 4}, {1, 3}}),
               Bezier_curve_2<double>({{1, 3}, {0.5, 4}})},
              "a triangle");
  const Bounding_arc_tree_2 tree(drawing);
  Medial_axis_2::Options options;
  options.rule = Fill_rule::EVEN_ODD;
  const Medial_axis_2 axis = medial_axis(tree, 1e-5, options);
  std::printf("%zu vertices, %zu edges, %zu hole\n", axis.vertices.size(), axis.edges.size(), axis.holes);
  const auto degree = axis.degrees();
  for (std::size_t i = 0; i < axis.vertices.size(); ++i) {
    const Medial_axis_2::Vertex& v = axis.vertices[i];
    std::printf("%s about (%.4f, %.4f), radius %.4f, touches", degree[i] == 1 ? "end" : "branch", v.center.x,
                v.center.y, v.radius);
    for (const Curve_place& p : v.touches)
      std::printf(" %s at %.4f", drawing.curves()[p.curve].name.c_str(), p.bezier + p.t);
    std::printf("\n");
  }
  std::printf("%zu vertices without what sticks out by less than 0.2\n", pruned(axis, 0.2).vertices.size());
  std::printf("largest radius %.4f\n", largest_inscribed_disc(tree, axis)->radius.upper);
}
