// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// B-spline and NURBS curves: their Bezier pieces, the spiral segments of these, one hierarchy over all.

#include <CGAL/Bounding_arcs_2.h>

#include <CGAL/Simple_cartesian.h>

#include <cstdio>
#include <stdexcept>
#include <vector>

using namespace CGAL::Bounding_arcs;
using Kernel = CGAL::Circular_kernel_2<CGAL::Simple_cartesian<double>, CGAL::Algebraic_kernel_for_circles_2_2<double>>;
using Curve = B_spline_curve_2<double>;

void report(const char* name, const Curve& curve) {
  const Region_hierarchy_2<Bca_traits_2<Kernel>> regions(Bounding_arc_tree_2(curve), 1e-4);
  std::printf("%s: %zu Bezier pieces, %zu spirals, %zu regions\n", name, curve.bezier_pieces().size(),
              regions.spirals().size(), regions.number_of_leaves());
}

int main() {
  // closed, uniform knots: as many pieces as control points
  report("periodic cubic", Curve::periodic(3, {{0, 0}, {4, -1}, {5, 3}, {2, 2}, {1, 5}, {-2, 3}}));

  // clamped: starts and ends at control points; a double knot leaves one derivative there
  report("clamped cubic",
         Curve(3, {{0, 0}, {1, 2}, {3, 3}, {5, 1}, {6, 4}, {8, 4}, {9, 1}}, {0, 0, 0, 0, 1, 1, 2, 3, 3, 3, 3}));

  // weights make it rational; control points stay Euclidean
  report("rational quadratic",
         Curve(2, {{0, 0}, {2, 0}, {3, 1}, {3, 3}, {5, 4}}, {0, 0, 0, 1, 2, 3, 3, 3}, {1, 2, 1, 3, 1}));

  try {
    report("wrong", Curve(2, {{0, 0}, {1, 0}, {1, 1}}, {0, 0, 0, 1, 1, 1}, {1, -1, 1}));
  } catch (const std::invalid_argument& error) {
    std::printf("refused: %s\n", error.what());
  }
}
