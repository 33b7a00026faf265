// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// DXF entities as Bezier curves, in coordinates of the drawing or block that they stand in.

#ifndef BOUNDING_ARCS_TOOL_DXF_SHAPES_H
#define BOUNDING_ARCS_TOOL_DXF_SHAPES_H

#include "Svg_transform.h"

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>

#include <vector>

namespace bounding_arcs_tool {

using Dxf_curve = std::vector<CGAL::Bounding_arcs::Bezier_curve_2<double>>;

/// A vertex of a polyline, and the bulge of the arc that leaves it.
struct Dxf_vertex {
  Xy<double> point;
  double bulge;
};

/// The polyline; arcs are rational quadratics. Empty where no two neighbours differ.
[[nodiscard]] Dxf_curve polyline_curve(const std::vector<Dxf_vertex>& vertices, bool is_closed);

/// The end of a range of angles, in degrees, of a turn where it is one but for the digits that it was written with.
/// Else it would be open, or next to nothing, by what was rounded.
/// \param last_place that of the angles in the file, in degrees, see last_place_of_angles
[[nodiscard]] double end_of_range(double from, double to, double last_place);

/// The image of the unit circle between two angles in degrees, counterclockwise, in rational quadratics of at most 90
/// degrees; all of it, closed, where the angles are 360 degrees apart. Quarters come out without rounding of angles.
[[nodiscard]] Dxf_curve conic_curve(const Svg_transform& of_unit_circle, double from, double to);

/// The image of a curve. \throws std::invalid_argument if a coordinate exceeds 2^1000
[[nodiscard]] Dxf_curve transformed(const Dxf_curve& curve, const Svg_transform& transform);

}  // namespace bounding_arcs_tool

#endif
