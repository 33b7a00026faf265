// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a report tells of one file, as compact JSON for the page's script.

#ifndef BOUNDING_ARCS_TOOL_REPORT_FILE_REPORT_H
#define BOUNDING_ARCS_TOOL_REPORT_FILE_REPORT_H

#include "../query/Query_answer.h"
#include "report_command.h"

#include <optional>
#include <string>
#include <vector>

namespace bounding_arcs_tool {

/// Any text as a JSON string that ends no element of a page; bytes that are no UTF-8 are replaced.
[[nodiscard]] std::string page_string(const std::string& text);
/// Any text as content of an element of a page, with such bytes replaced, too.
[[nodiscard]] std::string page_text(const std::string& text);

/// Something drawn over the curves: the answer to a query, or chains of arcs.
struct Overlay {
  Query_answer answer;
  std::vector<std::vector<Arc_2>> chains = {};
};
/// What was asked, beside the regions, of a file's curves. \param rule the file's own \throws Input_error
[[nodiscard]] std::vector<Overlay> overlays_of(const std::string& file, const std::vector<Loaded_curve>& curves,
                                               CGAL::Bounding_arcs::Fill_rule rule, const Report_words& words,
                                               double eps);

/// \param read what was read of the file
/// \param options methods, eps (none: of powers of ten of the drawing's extent), kernel, repetitions of measurements
/// \param room bytes: what does not fit is left out, the finest trees first, and notes say so
/// \throws Input_error
[[nodiscard]] std::string file_json(const std::string& file, CGAL::Bounding_arcs::Curve_file&& read,
                                    const Report_words& words, const Options& options, std::size_t room);

}  // namespace bounding_arcs_tool

#endif
