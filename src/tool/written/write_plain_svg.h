// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Drawings as SVG files that are drawings again: in the coordinates of what was read.

#ifndef BOUNDING_ARCS_TOOL_WRITTEN_WRITE_PLAIN_SVG_H
#define BOUNDING_ARCS_TOOL_WRITTEN_WRITE_PLAIN_SVG_H

#include "Written_drawing.h"

#include <ostream>

namespace bounding_arcs_tool {

/// Whether SVG has a command for a piece: all but curves of degree 4 and more, and rational ones that are no part of an
/// ellipse.
[[nodiscard]] bool is_of_svg(const Written_piece& piece);

/// A path a curve with its name as id, and a group a layer, which Inkscape shows as one. Names that are there already
/// get a number, "a_2". Arcs are A, parts of ellipses, too; numbers read back as the same doubles. The page is that of
/// the drawing, else the box around its curves. y of a drawing with y upwards changes its sign.
/// \pre is_of_svg holds of all pieces
void write_plain_svg(std::ostream& out, const Written_drawing& drawing);

}  // namespace bounding_arcs_tool

#endif
