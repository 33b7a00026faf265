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
  std::string layer;                 ///< any text: what DXF allows in no name becomes _
  std::vector<Output_piece> pieces;  ///< where one does not start at the end of the one before, a polyline begins
};

/// One LWPOLYLINE with bulges a chain, in DXF 2000; numbers read back as the same doubles.
/// \param y_is_down coordinates are a drawing's, with y downwards: DXF has it upwards, so y changes its sign
void write_dxf(std::ostream& out, const std::vector<Dxf_chain>& chains, bool y_is_down);

}  // namespace bounding_arcs_tool

#endif
