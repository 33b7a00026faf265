// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How long units of coordinates are, and drawings in other units than their files have.

#ifndef BOUNDING_ARCS_TOOL_UNITS_H
#define BOUNDING_ARCS_TOOL_UNITS_H

#include <CGAL/Bbox_2.h>
#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>

#include <string>
#include <vector>

namespace bounding_arcs_tool {

/// How long a unit of a file's coordinates is.
struct File_unit {
  std::string file;  ///< empty where the command line tells it
  double in_mm = 0;  ///< 0 where it is not told
};

/// The words of --units.
[[nodiscard]] std::vector<std::string> unit_words();
/// The length of the unit of a word. \pre it is one of unit_words()
[[nodiscard]] double unit_of_word(const std::string& word);
/// The word of a unit, or "" for another length.
[[nodiscard]] std::string word_of_unit(double in_mm);
/// "1 mm", "25.4 mm".
[[nodiscard]] std::string unit_text(double in_mm);

/// What is said of a file that tells no unit beside one that does.
[[nodiscard]] std::string taken_unit_text(const File_unit& other);

/// Whether lengths of units are one but for the digits of files.
[[nodiscard]] bool is_same_unit(double a, double b);

/// The page around a box, to at least three digits of its larger side, with its size in the unit; in none where it is
/// 0.
[[nodiscard]] CGAL::Bounding_arcs::Curve_file::Page page_of(const CGAL::Bbox_2& box, double unit_in_mm);

/// Takes a file's coordinates to be in a unit, as they are.
void tell_unit(CGAL::Bounding_arcs::Curve_file& file, double in_mm);
/// Converts the coordinates of a file that tells its unit.
/// \param name what errors call the file
/// \throws Input_error where coordinates become too large
void convert_to_unit(CGAL::Bounding_arcs::Curve_file& file, double in_mm, const std::string& name);

}  // namespace bounding_arcs_tool

#endif
