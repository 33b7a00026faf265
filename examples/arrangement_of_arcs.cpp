// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The arcs of two curves in CGAL's arrangements: ends and bulges in doubles define rational circles, so that all that
// the arrangement tells is exact of them. Arcs that follow each other meet in the same point.

#include <CGAL/Bounding_arcs_2.h>
#include <CGAL/Bounding_arcs_2/exchange/circle_segment_curve.h>

#include <CGAL/Arrangement_2.h>

#include <iostream>
#include <vector>

using namespace CGAL::Bounding_arcs;
using Traits = CGAL::Arr_circle_segment_traits_2<CGAL::Epeck>;

int main() {
  const Bezier_curve_2<double> loop({{0, 0.6}, {6.4, 3}, {-2.4, 3.4}, {3, 0}}), wave({{0, 1}, {1, 4}, {2, -2}, {3, 2}});
  std::vector<Traits::Curve_2> curves;
  for (const auto* curve : {&loop, &wave}) {
    const Arc_chain chain = arc_chain(Bounding_arc_tree_2(*curve), 1e-3);
    std::cout << chain.arcs.size() << " arcs within " << chain.error << "\n";
    for (const Arc_chain::Arc& arc : chain.arcs) curves.push_back(circle_segment_curve(arc));
  }
  CGAL::Arrangement_2<Traits> arrangement;
  insert(arrangement, curves.begin(), curves.end());
  std::size_t crossings = 0;
  for (auto v = arrangement.vertices_begin(); v != arrangement.vertices_end(); ++v) crossings += v->degree() == 4;
  std::cout << crossings << " crossings, " << arrangement.number_of_faces() - 1 << " bounded faces\n";
}
