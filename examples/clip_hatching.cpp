// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Hatching of a ring: level lines, cut by its two circles.

#include <CGAL/Bounding_arcs_2.h>

#include <iostream>

using namespace CGAL::Bounding_arcs;
using Curve = Bezier_curve_2<double>;

int main() {
  Drawing_2<double> circles, lines;
  for (const double r : {3.0, 1.0})
    circles.add({Curve({{r, 0}, {r, r}, {0, r}}, {1, 1, 2}), Curve({{0, r}, {-r, r}, {-r, 0}}, {2, 1, 1}),
                 Curve({{-r, 0}, {-r, -r}, {0, -r}}, {1, 1, 2}), Curve({{0, -r}, {r, -r}, {r, 0}}, {2, 1, 1})});
  for (const double y : {-2.0, 0.0, 2.0, 3.0}) lines.add({Curve({{-4, y}, {4, y}})});
  const Bounding_arc_tree_2 hatching(lines), ring(circles);
  for (const Clipped_2::Part& part : clip(hatching, ring, Fill_rule::EVEN_ODD).parts)
    if (part.side == CGAL::ON_BOUNDED_SIDE)
      std::cout << "line " << part.curve << ": from x = " << part.start.x << " to " << part.end.x << '\n';
}
