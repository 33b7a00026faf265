// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The first program: a file of curves, their tree, the point nearest to another one, and an offset as a picture.

#include <CGAL/Bounding_arcs_2.h>
#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>
#include <CGAL/Bounding_arcs_2/exchange/svg_path.h>
#include <fstream>
#include <iostream>

using namespace CGAL::Bounding_arcs;

int main() {
  const Bounding_arc_tree_2 tree(read_drawing(BOUNDING_ARCS_EXAMPLE_DATA "/d_rabbit.json"));
  const auto found = closest_point(tree, {1, 1});
  std::cout << "nearest to (1, 1) is (" << found->point << "), " << found->distance.upper << " away\n";
  const Offset grown = offset(tree, 0.1, 1e-4);  // by 0.1, within 0.0001
  std::ofstream("rabbit.svg") << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='-1.4 -1.4 2.8 2.8'>"
                              << "<path transform='scale(1,-1)' d='" << svg_path(grown) << "'/></svg>\n";
  std::cout << grown.chains.front().pieces.size() << " arcs in rabbit.svg\n";
}
