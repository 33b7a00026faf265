// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a DXF entity draws, from its groups.

#ifndef BOUNDING_ARCS_TOOL_DXF_ENTITY_CURVES_H
#define BOUNDING_ARCS_TOOL_DXF_ENTITY_CURVES_H

#include "Dxf_groups.h"
#include "Dxf_shapes.h"

#include <string>
#include <vector>

namespace bounding_arcs_tool {

/// The curves of an entity, in coordinates of the drawing or block that it stands in.
struct Dxf_drawn {
  std::vector<Dxf_curve> curves;  ///< several where a spline has a gap, and of an MLINE
  std::string fault;              ///< what was wrong with the entity, which was read all the same; else empty
};

/// Draws a LINE, ARC, CIRCLE, ELLIPSE, LWPOLYLINE, POLYLINE, SPLINE, MLINE, HATCH, SOLID or TRACE.
/// \param vertices of a POLYLINE, the items behind it
/// \throws Dxf_left_out for another entity, and for one without a curve in the plane
[[nodiscard]] Dxf_drawn dxf_entity_curves(const Dxf_item& entity, const std::vector<Dxf_item>& vertices);

/// The point whose x is in a group, and whose y is in that ten further. \throws Dxf_left_out where one is not there
[[nodiscard]] Xy<double> point(const Dxf_item& item, int x);

/// Whether an entity is in a plane that is seen from below: x then runs to the left.
/// \throws Dxf_left_out where the plane is tilted
[[nodiscard]] bool is_seen_from_below(const Dxf_item& entity);

}  // namespace bounding_arcs_tool

#endif
