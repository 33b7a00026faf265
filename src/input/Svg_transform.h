// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Affine maps of the plane as SVG writes them.

#ifndef BOUNDING_ARCS_TOOL_SVG_TRANSFORM_H
#define BOUNDING_ARCS_TOOL_SVG_TRANSFORM_H

#include "Svg_length.h"

#include <CGAL/Bounding_arcs_2/number/Xy.h>

#include <string_view>

namespace bounding_arcs_tool {

using CGAL::Bounding_arcs::Xy;

/// The map (x, y) -> (a x + c y + e, b x + d y + f).
struct Svg_transform {
  double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;

  /// \return the image, in which no coordinate is -0; p itself under the identity
  [[nodiscard]] Xy<double> operator()(const Xy<double>& p) const;
  /// The map that applies `second` first.
  [[nodiscard]] Svg_transform operator*(const Svg_transform& second) const;
};

[[nodiscard]] Svg_transform svg_translation(double x, double y);
[[nodiscard]] Svg_transform svg_scaling(double x, double y);
/// \param degrees from the x-axis towards the y-axis; quarter turns are exact
[[nodiscard]] Svg_transform svg_rotation(double degrees);

/// The map of a transform attribute: any number of matrix, translate, scale, rotate, skewX and skewY, the last first.
/// \throws Svg_error
[[nodiscard]] Svg_transform parsed_svg_transform(std::string_view text);

/// The map of a transform in a style attribute, in small letters: `none`, or functions of the plane whose lengths and
/// angles have units. \param viewport what per cent of translations refer to
/// \throws Svg_error
[[nodiscard]] Svg_transform parsed_css_transform(std::string_view text, const Svg_viewport& viewport);

/// The fixed point of a transform-origin in small letters: one to three words, lengths or per cent of the viewport.
/// \param in_style whether lengths need units, as they do in style attributes
/// \throws Svg_error
[[nodiscard]] Xy<double> parsed_transform_origin(std::string_view text, const Svg_viewport& viewport, bool in_style);

}  // namespace bounding_arcs_tool

#endif
