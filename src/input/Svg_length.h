// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lengths with units, and what per cent of them refer to.

#ifndef BOUNDING_ARCS_TOOL_SVG_LENGTH_H
#define BOUNDING_ARCS_TOOL_SVG_LENGTH_H

#include "Svg_scanner.h"

#include <string_view>

namespace bounding_arcs_tool {

/// The size of the rectangle that percentages refer to.
struct Svg_viewport {
  double width, height;
  /// What percentages of lengths that are neither widths nor heights refer to.
  [[nodiscard]] double diagonal() const;
};

/// Reads a number and its unit; `whole` is what 100 % is. \throws Svg_error
[[nodiscard]] double scanned_svg_length(Svg_scanner& scanner, double whole);

/// The length that is a whole text, in user units. \throws Svg_error
[[nodiscard]] double parsed_svg_length(std::string_view text, double whole);

/// The length that is a whole text, in mm, of which an inch has 25.4 and 96 px.
/// \return 0 for other units than mm, cm, in, pt, pc, q and px, lengths that are not above 0 and what is no length
[[nodiscard]] double svg_length_in_mm(std::string_view text);

}  // namespace bounding_arcs_tool

#endif
