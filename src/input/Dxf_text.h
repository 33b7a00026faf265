// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Characters that are not ASCII, as DXF files have them.

#ifndef BOUNDING_ARCS_TOOL_DXF_TEXT_H
#define BOUNDING_ARCS_TOOL_DXF_TEXT_H

#include <optional>
#include <string>
#include <string_view>

namespace bounding_arcs_tool {

/// The text of a file in UTF-8: `\U+XXXX` as the character that it stands for, and bytes that are not UTF-8 as those of
/// the code page 1252 where the file names it. Lines stay lines.
/// \return nothing where that is the text as it is
[[nodiscard]] std::optional<std::string> dxf_as_utf8(std::string_view text);

/// A text in UTF-8 as DXF 2000 has it: in ASCII, with `\U+XXXX` for what is not, in UTF-16.
[[nodiscard]] std::string dxf_as_ascii(std::string_view text);

}  // namespace bounding_arcs_tool

#endif
