// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Drawings as DXF files.

#ifndef BOUNDING_ARCS_TOOL_WRITE_DXF_H
#define BOUNDING_ARCS_TOOL_WRITE_DXF_H

#include "../written/Written_drawing.h"

#include <ostream>

namespace bounding_arcs_tool {

/// What arcs and segments that follow each other become: one LWPOLYLINE with bulges, whose ends and bulges read back as
/// the same doubles; or an ARC or LINE each. Two half circles that meet at both ends become a CIRCLE.
enum class Dxf_entities { POLYLINES, ARCS };

/// DXF 2000; numbers read back as the same doubles. Bezier curves of one degree that follow each other become a SPLINE.
/// A curve with a height for each vertex becomes one 3D POLYLINE.
/// A curve without a layer is on one of its name. Layers have the colour of their first curve, and curves with another
/// one their own; what has none is black or white, whichever is seen. A layer's name is any text in UTF-8: what DXF
/// allows in no name becomes _, and what is not ASCII `\U+XXXX`. y of a drawing with y downwards changes its sign.
/// \guarantee the ends of an ARC, by its center, radius and angles, are within 2^-30 of the chord's length of the
///   piece's; where doubles do not tell a flat arc's ends as exactly, it becomes an LWPOLYLINE of one bulge
void write_dxf(std::ostream& out, const Written_drawing& drawing, Dxf_entities entities = Dxf_entities::POLYLINES);

}  // namespace bounding_arcs_tool

#endif
