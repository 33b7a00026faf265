// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The subcommand `medial-axis`: its options and its run.

#ifndef BOUNDING_ARCS_TOOL_MEDIAL_AXIS_MEDIAL_AXIS_COMMAND_H
#define BOUNDING_ARCS_TOOL_MEDIAL_AXIS_MEDIAL_AXIS_COMMAND_H

#include "../query/query_command.h"
#include "../reading.h"
#include "../stream/record_stream.h"
#include "../toolpath/gcode_options.h"

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace bounding_arcs_tool {

struct Medial_axis_words {
  std::string file, eps, format = "json", output;
  double prune = 0, prune_angle = 0;
  double v_bit = 0;      ///< the angle of a conical bit, in degrees; 0 for none
  double max_depth = 0;  ///< of the bit; 0 for any
  double flat_tool = 0;  ///< the diameter of another tool for what is flat; 0 for none
  double margin = 0;     ///< of the frame; 0 for a default
  bool is_framed = false;
  bool with_discs = false, with_feet = false, with_cells = false, with_conics = false;
  bool is_plain = false;
  bool is_proving = false;  ///< edges have proven bounds
  Gcode_words gcode;
  Stream_options stream;
  Reading_words reading;
};

/// The drawing, with a frame where it is asked for, as its axis is made of: decided exactly. \throws Input_error
[[nodiscard]] Query_drawing with_frame(Query_drawing loaded, const Medial_axis_words& words);
/// Loads a file's drawing as its axis is made of: closed curves, or all of them and a frame. \throws Input_error
[[nodiscard]] Query_drawing load_axis_drawing(const Medial_axis_words& words);
/// Adds the option for a frame.
void add_frame_option(CLI::App& command, Medial_axis_words& words);

/// The axis as marks on the curves, with a row a vertex. \throws Input_error
[[nodiscard]] Query_answer medial_axis_answer(const Medial_axis_words& words, const Query_drawing& drawing);

/// Adds the subcommand to the command line.
CLI::App* add_medial_axis_command(CLI::App& app, Medial_axis_words& words);

/// Makes "--frame WORD" "--frame=0 WORD" where the word is no number: CLI11 would take the name of a file for a margin.
void give_margins(std::vector<std::string>& words);

/// \return the exit status; bad input is thrown as Input_error
int run_medial_axis(const Medial_axis_words& words);

}  // namespace bounding_arcs_tool

#endif
