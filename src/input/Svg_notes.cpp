// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Notes as they are told.

#include "Svg_notes.h"

#include "Input_text.h"

namespace bounding_arcs_tool {

namespace {

constexpr std::size_t LONGEST_DETAIL = 400;

}  // namespace

std::vector<CGAL::Bounding_arcs::Curve_file::Note> Svg_notes::notes() const {
  std::vector<CGAL::Bounding_arcs::Curve_file::Note> result;
  for (const Entry& entry : notes_) {
    result.push_back(entry.note);
    if (entry.first.empty()) continue;
    result.back().reason += entry.note.count > 1 ? ", the first: " : ", ";
    result.back().reason += one_line(entry.first, LONGEST_DETAIL);
  }
  return result;
}

}  // namespace bounding_arcs_tool
