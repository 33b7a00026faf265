// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The text of a DXF file, group by group: pairs of lines, a code and a value.

#ifndef BOUNDING_ARCS_TOOL_DXF_GROUPS_H
#define BOUNDING_ARCS_TOOL_DXF_GROUPS_H

#include <string>
#include <string_view>

namespace bounding_arcs_tool {

/// Does the text begin as a DXF file does, with a section or a comment?
[[nodiscard]] bool is_dxf(std::string_view text);

/// Checks all that dxflib takes on trust: that codes and numbers are such, numbers are finite, counts that it takes
/// memory for are no larger than the file, lines fit into its buffers, and the drawing ends with EOF.
/// \return the text up to there: behind it, where readers stop, dxflib goes on
/// \throws Input_error with the line
[[nodiscard]] std::string_view checked_dxf(std::string_view text, const std::string& file);

}  // namespace bounding_arcs_tool

#endif
