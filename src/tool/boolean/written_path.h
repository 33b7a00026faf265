// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Paths of results for DXF and plain SVG: the curves themselves, or arcs within a tolerance.

#ifndef BOUNDING_ARCS_TOOL_BOOLEAN_WRITTEN_PATH_H
#define BOUNDING_ARCS_TOOL_BOOLEAN_WRITTEN_PATH_H

#include "../written/Written_drawing.h"

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace bounding_arcs_tool {

/// In what form a path is wanted.
struct Path_words {
  std::string eps;        ///< how far arcs may be from the curves; empty for the curves themselves
  bool is_plain = false;  ///< as SVG
};

/// Adds the options --plain and --eps.
void add_path_options(CLI::App& command, Path_words& words);
/// Refuses them where the form of the output has no use for them. \throws Usage_error
void check_path_words(const Path_words& words, const std::string& format);

/// \param file what errors call the file
/// \throws Input_error for an eps that coordinates do not resolve, and without one for a curve that SVG cannot draw
[[nodiscard]] Written_curve written_path(const std::string& file, const std::string& name, const Curve_look& look,
                                         const std::vector<CGAL::Bounding_arcs::Bezier_curve_2<double>>& pieces,
                                         const Path_words& words);

}  // namespace bounding_arcs_tool

#endif
