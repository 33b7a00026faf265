// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether chains of arcs cross, exactly: by a sweep over rational circles through their ends.

#ifndef BOUNDING_ARCS_TEST_EXACT_SWEEP_H
#define BOUNDING_ARCS_TEST_EXACT_SWEEP_H

#include <CGAL/Bounding_arcs_2/exchange/circle_segment_curve.h>
#include <CGAL/Bounding_arcs_2/offset/Offset_2.h>

#include <CGAL/Arr_circle_segment_traits_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Surface_sweep_2_algorithms.h>

#include <set>
#include <utility>
#include <vector>

namespace bounding_arcs_test {

/// Nothing crosses, nor passes a corner twice, which a sweep takes for neighbours.
inline bool do_not_cross(const std::vector<CGAL::Bounding_arcs::Offset::Chain>& chains) {
  using Traits = CGAL::Arr_circle_segment_traits_2<CGAL::Exact_predicates_exact_constructions_kernel>;
  std::vector<Traits::Curve_2> curves;
  std::set<std::pair<double, double>> corners;
  for (const auto& chain : chains)
    for (const auto& piece : chain.pieces) {
      curves.push_back(CGAL::Bounding_arcs::circle_segment_curve(piece.arc));
      if (!corners.insert({piece.arc.from.x, piece.arc.from.y}).second) return false;
    }
  Traits traits;
  return !CGAL::do_curves_intersect(curves.begin(), curves.end(), traits);
}

}  // namespace bounding_arcs_test

#endif
