// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Point location in doubles; its body is compiled in the library.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_DRAWING_LOCATION_H
#define CGAL_BOUNDING_ARCS_2_QUERY_DRAWING_LOCATION_H

#include <CGAL/Bounding_arcs_2/query/Point_side.h>
#include <CGAL/Bounding_arcs_2/query/closed_curves.h>
#include <CGAL/Bounding_arcs_2/query/kernel_points.h>
#include <CGAL/Bounding_arcs_2/tree/Drawing_hierarchy.h>

namespace CGAL::Bounding_arcs {

/// Locates points in a drawing. That all curves are closed is checked once.
class Drawing_location {
 public:
  /// \param curves must outlive this
  /// \throws std::invalid_argument if a curve is open, with its name
  explicit Drawing_location(const Drawing_hierarchy& curves) : curves_(&curves) { check_closed(curves.drawing()); }

  [[nodiscard]] Winding_number winding_number(const Asked_point& q) const;
  [[nodiscard]] Point_side locate(const Asked_point& q, Fill_rule rule = Fill_rule::NONZERO) const {
    return side_of(winding_number(q), rule);
  }

 private:
  const Drawing_hierarchy* curves_;
};

/// Returns how often the curves of a drawing run round a point.
[[nodiscard]] inline Winding_number winding_number(const Drawing_hierarchy& curves, const Asked_point& q) {
  return Drawing_location(curves).winding_number(q);
}
/// Tells whether a point is inside the curves of a drawing.
[[nodiscard]] inline Point_side locate(const Drawing_hierarchy& curves, const Asked_point& q,
                                       Fill_rule rule = Fill_rule::NONZERO) {
  return Drawing_location(curves).locate(q, rule);
}

}  // namespace CGAL::Bounding_arcs

#endif
