// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pieces of paths as curve files have them.

#ifndef BOUNDING_ARCS_TOOL_BOOLEAN_PATH_PIECES_H
#define BOUNDING_ARCS_TOOL_BOOLEAN_PATH_PIECES_H

#include "../number_text.h"
#include "../query/Query_answer.h"

#include <CGAL/Bounding_arcs_2/boolean/boolean_operations.h>
#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>

#include <cstddef>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

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

/// What is said where it was not decided how curves meet, with the place where that is known.
/// \param operands the drawings, in their order
[[nodiscard]] inline std::string message_of_undecided(
    const std::optional<CGAL::Bounding_arcs::Overlay_2::Undecided>& found,
    const std::vector<const CGAL::Bounding_arcs::Drawing_2<double>*>& operands, const std::string& kernel) {
  const auto name = [&](const CGAL::Bounding_arcs::Overlay_2::Undecided::Of& of) {
    return '"' + operands[of.operand]->curves()[of.curve].name + '"';
  };
  std::string text = "curves ";
  if (found) text += name(found->a) + " and " + name(found->b) + " ";
  text += "meet ";
  if (found) text += "at about " + place_text(found->at) + " ";
  return text + (kernel == "double" ? "in a way that doubles do not tell; use --kernel filtered"
                                    : "in a way that could not be told apart");
}

}  // namespace bounding_arcs_tool

#endif
