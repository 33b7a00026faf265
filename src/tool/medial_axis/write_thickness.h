// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the thickness command has found, as JSON, CSV or a picture.

#ifndef BOUNDING_ARCS_TOOL_MEDIAL_AXIS_WRITE_THICKNESS_H
#define BOUNDING_ARCS_TOOL_MEDIAL_AXIS_WRITE_THICKNESS_H

#include "../written/Written_drawing.h"
#include "found_axis.h"

#include <CGAL/Bounding_arcs_2/medial_axis/thin_places.h>

#include <cmath>
#include <optional>
#include <ostream>
#include <vector>

namespace bounding_arcs_tool {

struct Found_thickness {
  const Found_axis& axis;
  const Query_drawing& loaded;
  double below;                                                 ///< the limit; infinite for none
  std::optional<ba::Medial_axis_2::Sample> thickest = {};       ///< none of an axis without vertices
  std::optional<ba::Medial_axis_2::Sample> thinnest = {};       ///< outside of corners
  std::vector<ba::Medial_axis_2::Thin_stretch> stretches = {};  ///< below the limit
  std::vector<ba::Medial_axis_2::Neck> necks = {};              ///< below the limit, or all

  [[nodiscard]] bool has_limit() const { return std::isfinite(below); }
};

/// The point that is at a place.
[[nodiscard]] Xy<double> point_of(const Found_thickness& found, const Curve_place& place);
/// Whether a neck is a place of a stretch.
[[nodiscard]] bool is_on(const ba::Medial_axis_2::Neck& neck, const ba::Medial_axis_2::Thin_stretch& stretch);

void write_thickness_json(std::ostream& out, const Found_thickness& found);
/// A line a stretch where there is a limit, else one a neck.
void write_thickness_csv(std::ostream& out, const Found_thickness& found);
/// Stretches on the layer "thin", one that is a single disc from one side to the other, and necks so on "necks".
[[nodiscard]] Written_drawing written_thickness(const Found_thickness& found);
/// Each point of the shape in the colour of its thickness, with a scale below; places that were left open in circles.
void draw_thickness(std::ostream& out, const Found_thickness& found);

}  // namespace bounding_arcs_tool

#endif
