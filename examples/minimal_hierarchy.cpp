// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The regions of a tree: a cubic Bezier curve, its spiral segments, a hierarchy of bounding circular arcs.

#include <CGAL/Bounding_arcs_2.h>
#include <iostream>

using namespace CGAL::Bounding_arcs;

int main() {
  const Bezier_curve_2<double> curve({{0, 0.6}, {6.4, 3}, {-2.4, 3.4}, {3, 0}});
  const Bounding_arc_tree_2 tree(curve);
  const Region_hierarchy_2 regions(tree, 1e-3);
  std::cout << regions.spirals().size() << " spiral segments, " << regions.number_of_leaves() << " regions, "
            << (regions.bound() <= 1e-3 ? "none thicker than 0.001\n" : "eps was not reached\n");
}
