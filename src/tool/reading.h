// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The one way by which subcommands read drawings: what a file has and is not read is said on standard error.

#ifndef BOUNDING_ARCS_TOOL_READING_H
#define BOUNDING_ARCS_TOOL_READING_H

#include "units.h"

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace bounding_arcs_tool {

/// What the command line says about reading.
struct Reading_words {
  CGAL::Bounding_arcs::Curve_file::Options options;
  bool is_strict = false;    ///< files have to be read as they stand there
  std::string join;          ///< how far apart ends may be that are joined, or none; empty for the file's rounding
  bool skips_open = false;   ///< open curves are left out
  std::string layers, ids;   ///< that are wanted, with commas between; empty for all
  std::string rule;          ///< nonzero or evenodd for what needs one; empty for the file's own
  File_unit unit;            ///< that coordinates are converted to; none for that of the file
  std::string without_unit;  ///< the first file that tells none

  /// Has the files that are read from now on converted to the unit of one, if it tells one and no unit was wanted yet.
  /// Says so of the first file before it that tells none.
  void keep_unit(const File_unit& of);
};

/// Adds the options --units, --join-ends, --skip-open, --layers, --ids, --strict, --hidden and --paper.
void add_reading_options(CLI::App& command, Reading_words& words);

/// What messages call a file.
[[nodiscard]] std::string name_of_file(const std::string& path);

/// "1 curve", "2 curves".
[[nodiscard]] std::string count_text(std::size_t count, const std::string& noun);
/// Says something about a file, in one line on standard error.
void tell(const std::string& file, const std::string& text);

/// Says in one line on standard error what was read otherwise than it stands in a file, if anything was.
/// \throws Input_error in place of the line where --strict forbids it
void tell_change(const std::string& file, const std::string& text, const Reading_words& words);
/// Says so what notes tell. \throws Input_error likewise
void tell_notes(const std::string& file, const std::vector<CGAL::Bounding_arcs::Curve_file::Note>& notes,
                const Reading_words& words);

/// What a reader is asked for.
[[nodiscard]] CGAL::Bounding_arcs::Curve_file::Options reading_options(const Reading_words& words);
/// Reads a file and joins what meets, and tells that: a change, but where --join-ends asks for it. \throws Input_error
[[nodiscard]] CGAL::Bounding_arcs::Curve_file read_joined(const std::string& path, const Reading_words& words);
/// Reads a file so, without open curves where they are to be skipped, and tells its notes. \throws Input_error
[[nodiscard]] CGAL::Bounding_arcs::Curve_file read_told(const std::string& path, const Reading_words& words);

/// Says in one line on standard error how many curves bound nothing, if there are any.
/// \param command whose words these are
void tell_left_out(const std::string& file, const std::string& command, std::size_t count,
                   CGAL::Bounding_arcs::Fill_rule rule);

/// Says that a unit is none of DXF, which then has none.
void tell_units_of_dxf(const File_unit& unit);

}  // namespace bounding_arcs_tool

#endif
