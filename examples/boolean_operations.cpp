// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A plate without a round hole that reaches over its edge: the boundary is made of parts of the given curves.

#include <CGAL/Bounding_arcs_2.h>

#include <iostream>

using namespace CGAL::Bounding_arcs;
using Curve = Bezier_curve_2<double>;

int main() {
  Drawing_2<double> plate, hole;
  plate.add({Curve({{0, 0}, {4, 0}}), Curve({{4, 0}, {4, 3}, {0, 3}}), Curve({{0, 3}, {0, 0}})}, "plate");
  hole.add({Curve({{1, 0}, {1, 1}, {2, 1}}, {1, 1, 2}), Curve({{2, 1}, {3, 1}, {3, 0}}, {2, 1, 1}),
            Curve({{3, 0}, {3, -1}, {2, -1}}, {1, 1, 2}), Curve({{2, -1}, {1, -1}, {1, 0}}, {2, 1, 1})},
           "hole");
  const Bounding_arc_tree_2 a(plate), b(hole);
  const Outline_2 rest = difference(a, b);
  for (const Outline_2::Chain& chain : rest.chains)
    for (const Outline_2::Part& part : chain.parts)
      std::cout << "from (" << part.start.x << ", " << part.start.y << ") along "
                << (part.operand == 0 ? "plate" : "hole") << " piece " << part.bezier
                << (part.is_reversed ? " backwards" : "") << " to (" << part.end.x << ", " << part.end.y << ")\n";
  const Bounding_arc_tree_2 region(drawn_outline({&a, &b}, rest).drawing);  // for queries, offsets, another operation
  std::cout << "area " << area(region, 1e-9).upper << '\n';
}
