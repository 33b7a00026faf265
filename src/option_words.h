// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Words of the command line that several subcommands take. Checks return what is wrong, or nothing, as CLI11 wants.

#ifndef BOUNDING_ARCS_TOOL_OPTION_WORDS_H
#define BOUNDING_ARCS_TOOL_OPTION_WORDS_H

#include <string>
#include <vector>

namespace bounding_arcs_tool {

[[nodiscard]] std::vector<std::string> words_between_commas(const std::string& list);

/// Of one tolerance, a positive number.
[[nodiscard]] std::string check_tolerance(const std::string& word);
/// Of several with commas between.
[[nodiscard]] std::string check_tolerances(const std::string& list);

}  // namespace bounding_arcs_tool

#endif
