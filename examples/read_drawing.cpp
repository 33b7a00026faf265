// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A file of curves, JSON or SVG, as one drawing with one hierarchy over it, and where on the drawing a leaf is.
// Link Bounding_arcs::readers. Usage: read_drawing [FILE]

#include <CGAL/Bounding_arcs_2.h>
#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>

#include <CGAL/Simple_cartesian.h>

#include <cstdio>

using namespace CGAL::Bounding_arcs;
using Kernel = CGAL::Circular_kernel_2<CGAL::Simple_cartesian<double>, CGAL::Algebraic_kernel_for_circles_2_2<double>>;

int main(int argc, char** argv) try {
  const auto drawing = read_drawing(argc > 1 ? argv[1] : BOUNDING_ARCS_EXAMPLE_DATA "/c_letter_K.json");
  for (const auto& curve : drawing.curves())
    std::printf("%s: %s, %zu Bezier pieces\n", curve.name.c_str(), curve.is_closed ? "closed" : "open",
                curve.beziers.size());

  const Region_hierarchy_2<Bca_traits_2<Kernel>> regions(Bounding_arc_tree_2(drawing), 1e-2);
  std::printf("%zu spiral segments, %zu regions; every 25th:\n", regions.spirals().size(), regions.number_of_leaves());
  std::size_t count = 0;
  regions.for_each_leaf([&](const Node_handle& leaf) {
    if (count++ % 25 != 0) return;
    const Region_node node = regions.node(leaf);
    const Curve_place from = regions.place_of(node, node.t0);
    std::printf("%s from Bezier piece %u, t = %.3f: parameter %.3f\n", drawing.curves()[from.curve].name.c_str(),
                from.bezier, from.t, drawing.parameter(from.curve, from.bezier, from.t));
  });
} catch (const Input_error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
