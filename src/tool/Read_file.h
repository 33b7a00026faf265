// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A file as the command line asks for it: of some layers, joined, some curves, without those that stay open.

#ifndef BOUNDING_ARCS_TOOL_READ_FILE_H
#define BOUNDING_ARCS_TOOL_READ_FILE_H

#include "reading.h"

#include <cstddef>
#include <string>
#include <vector>

namespace bounding_arcs_tool {

/// A file that was read, and what was joined in it.
struct Read_file {
  CGAL::Bounding_arcs::Curve_file file;
  std::vector<std::size_t> parts;  ///< of how many curves of the file each curve was made
  std::string converted;           ///< "converted from units of 25.4 mm to mm"; empty where it was not
  std::string joined;     ///< "joined: 8 open curves to 2 closed ones, ends moved by up to 1e-07"; empty where none was
  std::string ambiguous;  ///< "ambiguous: more than two ends meet at 2 places, the first at (1, 1)"; empty for none
  double moved = 0;       ///< how far an end was moved at most
  std::string skipped;    ///< "left out: 1 open curve, ..." where these were to be skipped; empty where there was none

  /// Leaves those curves for which a function of their number is true.
  template <class Is_wanted> void keep_if(const Is_wanted& is_wanted) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (!is_wanted(i)) continue;
      parts[kept] = parts[i];
      if (kept != i) file.curves[kept] = std::move(file.curves[i]);
      ++kept;
    }
    parts.resize(kept);
    file.curves.resize(kept);
  }
};

/// Reads a file, and tells nothing. \throws Input_error also for layers and names that the file has not
[[nodiscard]] Read_file read_file(const std::string& path, const Reading_words& words);

/// Leaves out what is open. \throws Input_error where nothing is left
void skip_open(const std::string& name, Read_file& read);

}  // namespace bounding_arcs_tool

#endif
