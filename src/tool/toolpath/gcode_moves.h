// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Passes as moves of G-code, in whole numbers of the last digit that is written.

#ifndef BOUNDING_ARCS_TOOL_TOOLPATH_GCODE_MOVES_H
#define BOUNDING_ARCS_TOOL_TOOLPATH_GCODE_MOVES_H

#include "Tool_pass.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace bounding_arcs_tool {

/// How passes become G-code. Lengths are in units of the coordinates, a feed in these a minute.
struct Gcode_setup {
  bool is_in_inches = false;
  double scale = 1;    ///< from units of the coordinates to mm, or inches
  bool flips = false;  ///< y of the coordinates is downwards
  int digits = 4;      ///< behind the point
  double feed = 0, safe_height = 5;
  double depth = 0;         ///< of passes in a plane, below 0
  double shortest_arc = 0;  ///< what is shorter becomes lines
  std::string header;       ///< text to put in front as it is

  /// A length in units of the last digit.
  [[nodiscard]] double counts(double length) const;
  /// A length in mm in units of the last digit.
  [[nodiscard]] double counts_of_mm(double length) const;
};

/// What a controller allows both radii of an arc to differ by: 0.002 mm, or 0.1 % of the radius where that is more.
/// GRBL refuses more than 0.005 mm that is more than 0.1 % of the radius, LinuxCNC more than 0.028 mm that is so, and
/// EMC before it more than 0.002 mm.
/// \param radius in units of the last digit
[[nodiscard]] double radius_slack(const Gcode_setup& setup, double radius);

/// A place in units of the last digit.
struct Gcode_place {
  std::int64_t x = 0, y = 0, z = 0;
  bool operator==(const Gcode_place& other) const { return x == other.x && y == other.y && z == other.z; }
  bool operator!=(const Gcode_place& other) const { return !(*this == other); }
};
/// G0 through the air, G1 along a line, G2 and G3 along an arc clockwise and counterclockwise.
struct Gcode_move {
  int motion = 0;
  Gcode_place to;
  std::int64_t i = 0, j = 0;  ///< from the start of an arc to its center
};

/// What a move stands for: a part of a piece of a pass, by shares of its length, or the way to a pass.
struct Gcode_source {
  static constexpr std::size_t NONE = static_cast<std::size_t>(-1);
  std::size_t pass = NONE;   ///< none of the first lift and the last one
  std::size_t piece = NONE;  ///< none of a way to a pass
  double from = 0, to = 1;

  [[nodiscard]] bool is_cut() const { return piece != NONE; }
};

/// Moves, each with what it stands for.
struct Gcode_program {
  std::vector<Gcode_move> moves;      ///< the first one lifts the tool
  std::vector<Gcode_source> sources;  ///< of each move
  std::size_t arcs = 0, broken = 0;   ///< arcs that are written, and arcs that became lines
};

/// How far a move may be from what it stands for, in units of the last digit: its start, its end and its center are
/// each rounded by up to 1/sqrt(2), and the radius by as much as start and center.
inline constexpr double MOVE_ERROR = 3;

/// Returns the piece in units of the last digit, with y upwards.
[[nodiscard]] Arc_2 in_counts(const Gcode_setup& setup, const Arc_2& piece);
/// How far a move is from what it stands for, at most; infinite for an arc that controllers refuse or take for another
/// one.
/// \param from where it starts
/// \param part what it stands for, in_counts
[[nodiscard]] double deviation(const Gcode_setup& setup, const Gcode_place& from, const Gcode_move& move,
                               const Arc_2& part);

/// Returns passes one after the other, as they are given. Before each the tool is lifted, but where it is there
/// already.
///
/// An arc becomes lines where it is shorter than what is asked for, where rounding leaves no center with which
/// controllers take it, where it is as good as a line, and where its radius has more than 24 bits: controllers that
/// reckon in single precision would miss its end. Lines are within half a unit of the last digit of the arc. What is
/// shorter than that is left out.
/// \guarantee the deviation of each move is at most MOVE_ERROR
/// \throws std::invalid_argument where coordinates have more digits than doubles
[[nodiscard]] Gcode_program gcode_program(const std::vector<Tool_pass>& passes, const Gcode_setup& setup);

}  // namespace bounding_arcs_tool

#endif
