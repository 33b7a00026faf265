// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads what medial-axis writes.

#ifndef BOUNDING_ARCS_TOOL_MEDIAL_AXIS_READ_AXIS_H
#define BOUNDING_ARCS_TOOL_MEDIAL_AXIS_READ_AXIS_H

#include <CGAL/Bounding_arcs_2/curve/Fill_rule.h>
#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>

#include <optional>
#include <string>
#include <vector>

namespace bounding_arcs_tool {

/// An axis as it is written.
struct Written_axis {
  CGAL::Bounding_arcs::Medial_axis_2 axis;
  std::vector<double> bounds;  ///< of each edge where they are there, eps of an edge without; else empty
  bool is_framed = false;
  std::optional<CGAL::Bounding_arcs::Fill_rule> rule;  ///< that it was made with, where it tells
};

/// \throws Input_error with the place, as edges[3].feet[17], and the reason
[[nodiscard]] Written_axis read_axis(const std::string& path);

}  // namespace bounding_arcs_tool

#endif
