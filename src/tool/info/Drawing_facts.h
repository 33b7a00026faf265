// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What there is to know of a drawing before anything is done with it: its curves, which is inside of which, loose ends.

#ifndef BOUNDING_ARCS_TOOL_INFO_DRAWING_FACTS_H
#define BOUNDING_ARCS_TOOL_INFO_DRAWING_FACTS_H

#include "../reading.h"

#include <CGAL/Bbox_2.h>
#include <CGAL/Bounding_arcs_2/query/measures.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace bounding_arcs_tool {

/// What is known of a curve.
struct Curve_facts {
  CGAL::Bbox_2 box;
  double length = 0;  ///< within 1e-9 of the drawing's extent
  double area = 0;    ///< what a closed curve runs round, above 0 counterclockwise; 0 where bounds have no sign
  bool is_closed = false;
  std::optional<std::size_t> inside;  ///< the smallest closed curve around its start and its box
  std::size_t depth = 0;              ///< how many are around it

  /// "ccw", "cw", or "" for an open curve and one that runs round as much either way.
  [[nodiscard]] const char* direction() const { return area > 0 ? "ccw" : (area < 0 ? "cw" : ""); }
};

/// An end of an open curve, and the end nearest to it of all others.
struct Loose_end {
  struct Place {
    std::size_t curve;
    bool is_start;
    CGAL::Bounding_arcs::Xy<double> point;
  };
  Place end;
  std::optional<Place> nearest;  ///< nothing where there is no other end
  double distance = 0;           ///< to it
};

struct Drawing_facts {
  std::vector<Curve_facts> curves;
  std::vector<Loose_end> loose_ends;  ///< in the order of the curves
  std::vector<std::size_t> alike;     ///< curves that run round as the one that they are inside of does
  std::size_t closed = 0;
};

/// \throws Input_error for coordinates that are too large, with the curve
[[nodiscard]] Drawing_facts drawing_facts(const std::string& file,
                                          const CGAL::Bounding_arcs::Drawing_2<double>& drawing);

}  // namespace bounding_arcs_tool

#endif
