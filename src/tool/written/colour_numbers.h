// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// AutoCAD's colours: what their numbers show, and the number next to a colour.

#ifndef BOUNDING_ARCS_TOOL_WRITTEN_COLOUR_NUMBERS_H
#define BOUNDING_ARCS_TOOL_WRITTEN_COLOUR_NUMBERS_H

namespace bounding_arcs_tool {

/// The colour of a number from 1 to 255 as 0xRRGGBB; 7, which is seen on any ground, is black.
[[nodiscard]] int rgb_of_colour_number(int number);
/// The number of the colour that is nearest to 0xRRGGBB; 7 for black and white, as dark lines are not seen on dark
/// ground.
[[nodiscard]] int colour_number_of_rgb(int rgb);

}  // namespace bounding_arcs_tool

#endif
