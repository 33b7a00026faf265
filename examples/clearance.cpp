// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Between obstacles in a frame: the path with the most room from one point to another, and how thick a letter is.

#include <CGAL/Bounding_arcs_2.h>

#include <cstdio>
#include <vector>

using namespace CGAL::Bounding_arcs;

int main() {
  // A wall, which is an open curve, and a drop, in a box with a margin of 2 around both.
  Drawing_2<double> obstacles;
  obstacles.add(Bezier_curve_2<double>({{0, 0}, {3, 6}, {6, -6}, {9, 0}}), "wall");
  obstacles.add(Bezier_curve_2<double>({{4.5, 1}, {9, 5}, {0, 5}, {4.5, 1}}), "drop");
  const Bounding_arc_tree_2 tree(framed(obstacles, 2.0));
  Medial_axis_2::Options options;
  options.is_framed = true;
  const Medial_axis_2 voronoi = medial_axis(tree, 1e-5, options);
  std::size_t between = 0;
  for (const Medial_axis_2::Edge& e : voronoi.edges) between += !e.touches(obstacles.curves().size());
  std::printf("%zu edges, %zu of them between obstacles\n", voronoi.edges.size(), between);

  const auto path = clearance_path(tree, voronoi, {1.0, 3.5}, {8.0, 3.0});
  std::printf("the widest path has a length of %.4f and nowhere less room than %.4f\n", path->length, path->bottleneck);

  Drawing_2<double> letter;
  const std::vector<Xy<double>> corners{{0, 0}, {3, 0}, {3, 0.5}, {1, 0.5}, {1, 5}, {0, 5}};
  std::vector<Bezier_curve_2<double>> sides;
  for (std::size_t i = 0; i < corners.size(); ++i)
    sides.push_back(Bezier_curve_2<double>({corners[i], corners[(i + 1) % corners.size()]}));
  letter.add(sides, "an L");
  const Local_thickness_2 thickness(medial_axis(Bounding_arc_tree_2(letter), 1e-6));
  for (const Xy<double>& p : {Xy<double>{0.3, 3}, Xy<double>{2.2, 0.3}, Xy<double>{2, 2}})
    std::printf("thickness at (%g, %g): %.4f\n", p.x, p.y, thickness(p));
}
