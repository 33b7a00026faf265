// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Splines of DXF files that have points to run through in place of control points.

#ifndef BOUNDING_ARCS_TOOL_FIT_SPLINE_H
#define BOUNDING_ARCS_TOOL_FIT_SPLINE_H

#include "Dxf_shapes.h"

#include <optional>
#include <vector>

namespace bounding_arcs_tool {

/// The cubic spline with a continuous second derivative through points, its parameter the length of chords. At an end
/// it runs along the tangent that is told, with speed 1; where none is, its second derivative is 0. A closed one is
/// periodic. Empty where no two neighbours differ.
///
/// CAD programs make splines of fit points so; what they draw may differ a little, as no document tells it in full.
[[nodiscard]] Dxf_curve fit_spline(std::vector<Xy<double>> points, const std::optional<Xy<double>>& start_tangent,
                                   const std::optional<Xy<double>>& end_tangent, bool is_closed);

}  // namespace bounding_arcs_tool

#endif
