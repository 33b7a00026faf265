// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// NURBS in CGAL's arrangements: faces, and which of them has a point, exactly.

#include <CGAL/Arr_walk_along_line_point_location.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Bounding_arcs_2/arrangement/Arr_curve_traits_2.h>
#include <iostream>

using namespace CGAL::Bounding_arcs;
using Arrangement = CGAL::Arrangement_2<Arr_curve_traits_2>;

int main() {
  Drawing_2<double> drawing;
  drawing.add(B_spline_curve_2<double>(2, {{0, 0}, {2, 3}, {4, -2}, {6, 1}}, {0, 0, 0, 1, 2, 2, 2}, {1, 2, 1, 1}));
  drawing.add(B_spline_curve_2<double>::periodic(3, {{1, -1}, {5, -1}, {5, 1}, {3, 2}, {1, 1}}));
  const auto curves = arr_curves(drawing);
  Arrangement arrangement;
  CGAL::insert(arrangement, curves.begin(), curves.end());
  std::cout << arrangement.number_of_vertices() << " vertices, " << arrangement.number_of_edges() << " edges, "
            << arrangement.number_of_faces() << " faces\n";
  const CGAL::Arr_walk_along_line_point_location<Arrangement> location(arrangement);
  const auto found = location.locate(Arr_point_2(3.5, 0.5));
  const auto face = *value_as<Arrangement::Face_const_handle>(found);
  auto edge = face->outer_ccb();
  do std::cout << "curve " << edge->curve().curve().curve() << " from " << edge->source()->point() << '\n';
  while (++edge != face->outer_ccb());
}
