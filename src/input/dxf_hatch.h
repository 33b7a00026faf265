// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The outlines of a HATCH as closed curves.

#ifndef BOUNDING_ARCS_TOOL_DXF_HATCH_H
#define BOUNDING_ARCS_TOOL_DXF_HATCH_H

#include "dxf_entity_curves.h"

namespace bounding_arcs_tool {

/// Draws the outlines of a HATCH, of polylines and of edges, without those around texts, in coordinates of its plane.
/// \throws Dxf_left_out where there are none, and where the edges of one do not close
[[nodiscard]] std::vector<Dxf_curve> dxf_hatch(const Dxf_item& item);

}  // namespace bounding_arcs_tool

#endif
