// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pieces of paths as curve files have them.

#ifndef BOUNDING_ARCS_TOOL_BOOLEAN_PATH_PIECES_H
#define BOUNDING_ARCS_TOOL_BOOLEAN_PATH_PIECES_H

#include "../query/Query_answer.h"

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/number/Bracket.h>

namespace bounding_arcs_tool {

inline Json range_json(const CGAL::Bounding_arcs::Bracket& t) { return {t.lower, t.upper}; }

inline Json piece_json(const CGAL::Bounding_arcs::Bezier_curve_2<double>& curve) {
  Json piece;
  for (const Xy<double>& p : curve.control_points()) piece["control_points"].push_back(json_of(p));
  if (curve.is_rational()) piece["weights"] = curve.weights();
  return piece;
}

}  // namespace bounding_arcs_tool

#endif
