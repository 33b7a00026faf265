// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Chains of arcs as a DXF drawing.

#ifndef BOUNDING_ARCS_TOOL_WRITE_DXF_H
#define BOUNDING_ARCS_TOOL_WRITE_DXF_H

#include "../Hierarchy.h"

#include <ostream>
#include <string>
#include <vector>

namespace bounding_arcs_tool {

/// What goes on one layer.
struct Dxf_chain {
  std::string layer;          ///< any text: what DXF allows in no name becomes _
  std::vector<Arc_2> pieces;  ///< where one does not start at the end of the one before, a polyline begins
};

/// What chains become: one LWPOLYLINE with bulges each, whose ends and bulges read back as the same doubles; or an ARC
/// or LINE for each piece. A chain of two half circles that meet at both ends becomes a CIRCLE.
enum class Dxf_entities { POLYLINES, ARCS };

/// DXF 2000; numbers read back as the same doubles.
/// \param y_is_down coordinates are a drawing's, with y downwards: DXF has it upwards, so y changes its sign
/// \guarantee the ends of an ARC, by its center, radius and angles, are within 2^-30 of the chord's length of the
///   piece's; where doubles do not tell a flat arc's ends as exactly, it becomes an LWPOLYLINE of one bulge
void write_dxf(std::ostream& out, const std::vector<Dxf_chain>& chains, bool y_is_down,
               Dxf_entities entities = Dxf_entities::POLYLINES);

}  // namespace bounding_arcs_tool

#endif
