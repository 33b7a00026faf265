// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a tool cuts from one plunge to the next lift.

#ifndef BOUNDING_ARCS_TOOL_TOOLPATH_TOOL_PASS_H
#define BOUNDING_ARCS_TOOL_TOOLPATH_TOOL_PASS_H

#include "../Hierarchy.h"

#include <cstddef>
#include <string>
#include <vector>

namespace bounding_arcs_tool {

/// Arcs and segments that a tool follows without a lift. Invariant: there is a piece, and each starts where the one
/// before ends; there are no heights, or one more than pieces.
struct Tool_pass {
  std::string title;              ///< what people call it: a layer in DXF, a comment in G-code
  std::vector<Arc_2> pieces{};    ///< in units of the coordinates; one of no length for a place to drill
  double height = 0;              ///< z of all of it, where `heights` has none
  std::vector<double> heights{};  ///< z of the start of each piece and of the last one's end; pieces are segments then

  [[nodiscard]] const Xy<double>& from() const { return pieces.front().from; }
  [[nodiscard]] const Xy<double>& to() const { return pieces.back().to; }
  /// Tells whether it ends where it starts, at the same height.
  [[nodiscard]] bool is_closed() const {
    return from() == to() && (heights.empty() || heights.front() == heights.back());
  }
  [[nodiscard]] double height_at(std::size_t vertex) const { return heights.empty() ? height : heights[vertex]; }
};

/// Returns the way from its other end.
[[nodiscard]] Tool_pass reversed(Tool_pass pass);
/// Returns a closed way from the start of another one of its pieces. \pre pass.is_closed()
[[nodiscard]] Tool_pass started_at(Tool_pass pass, std::size_t piece);

/// The parts of pieces that follow each other, each a pass.
[[nodiscard]] std::vector<Tool_pass> passes_of(const std::string& title, double height,
                                               const std::vector<Arc_2>& pieces);

}  // namespace bounding_arcs_tool

#endif
