// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A program that reads a file of curves by the library's readers and builds one tree over it.
// Usage: drawing FILE

#include <CGAL/Bounding_arcs_2.h>
#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>

#include <CGAL/Simple_cartesian.h>

#include <iostream>

using namespace CGAL::Bounding_arcs;
using Kernel = CGAL::Circular_kernel_2<CGAL::Simple_cartesian<double>, CGAL::Algebraic_kernel_for_circles_2_2<double>>;

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const Drawing_2<double> drawing = read_drawing(argv[1]);
  const Region_hierarchy_2<Bca_traits_2<Kernel>, Bezier_spiral_2<double>> tree(spiral_segments(drawing), 1e-3);
  const auto& first = drawing.curves().front();
  std::cout << drawing.curves().size() << " curve, " << first.name << ": " << first.beziers.size() << " Bezier pieces, "
            << tree.spirals().size() << " spiral segments, " << tree.number_of_leaves() << " regions\n";
}
