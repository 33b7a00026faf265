// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The units of $INSUNITS, by their numbers in the DXF reference.

#ifndef BOUNDING_ARCS_TOOL_DXF_UNITS_H
#define BOUNDING_ARCS_TOOL_DXF_UNITS_H

namespace bounding_arcs_tool {

/// Millimeters in a unit; 0 for a number that has none.
[[nodiscard]] double dxf_unit_in_mm(long long number);
/// The number of a unit; 0 for a length that is none of them.
[[nodiscard]] int dxf_number_of_unit(double in_mm);

}  // namespace bounding_arcs_tool

#endif
