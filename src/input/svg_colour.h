// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The colours of SVG.

#ifndef BOUNDING_ARCS_TOOL_SVG_COLOUR_H
#define BOUNDING_ARCS_TOOL_SVG_COLOUR_H

#include <string_view>

namespace bounding_arcs_tool {

/// A colour in small letters as 0xRRGGBB: `#rgb`, `#rrggbb`, `rgb(255, 0, 0)` and the sixteen names of HTML.
/// \return -1 for what is none of these
[[nodiscard]] int svg_colour(std::string_view text);

}  // namespace bounding_arcs_tool

#endif
