// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lines that run beside each other, which a DXF file has as one MLINE.

#ifndef BOUNDING_ARCS_TOOL_DXF_MULTILINE_H
#define BOUNDING_ARCS_TOOL_DXF_MULTILINE_H

#include "dxf_entity_curves.h"

namespace bounding_arcs_tool {

/// Draws a polyline for each element of an MLINE. Caps at its ends are in its style, which is not read. Where an
/// element is cut it is drawn without its gaps, which the fault tells.
/// \throws Dxf_left_out where vertices do not have the same elements
[[nodiscard]] Dxf_drawn dxf_multiline(const Dxf_item& item);

}  // namespace bounding_arcs_tool

#endif
