// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pieces of paths as curve files have them.

#ifndef BOUNDING_ARCS_TOOL_BOOLEAN_PATH_PIECES_H
#define BOUNDING_ARCS_TOOL_BOOLEAN_PATH_PIECES_H

#include "../query/Query_answer.h"

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>

#include <cstddef>
#include <ostream>
#include <string>

namespace bounding_arcs_tool {

inline Json piece_json(const CGAL::Bounding_arcs::Bezier_curve_2<double>& curve) {
  Json piece;
  for (const Xy<double>& p : curve.control_points()) piece["control_points"].push_back(json_of(p));
  if (curve.is_rational()) piece["weights"] = curve.weights();
  return piece;
}

/// What a part of a curve is a part of. \param number the curve's number in its file
template <class Part> [[nodiscard]] Json source_json(const Part& part, std::size_t number, const std::string& name) {
  return {{"curve", number},
          {"name", name},
          {"bezier", part.bezier},
          {"from", {part.from.lower, part.from.upper}},
          {"to", {part.to.lower, part.to.upper}}};
}

/// Writes the key "pieces", one piece a line. \param piece gives a piece with its source
template <class PieceOf> void write_pieces(std::ostream& out, std::size_t count, const PieceOf& piece) {
  out << "\"pieces\":[";
  for (std::size_t i = 0; i < count; ++i)
    out << (i > 0 ? ",\n" : "\n") << piece(i).dump(-1, ' ', false, Json::error_handler_t::replace);
  out << ']';
}

}  // namespace bounding_arcs_tool

#endif
