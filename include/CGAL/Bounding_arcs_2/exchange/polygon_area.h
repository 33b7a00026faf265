// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The area of polygons of arcs, whose number is not algebraic, between doubles.

#ifndef CGAL_BOUNDING_ARCS_2_EXCHANGE_POLYGON_AREA_H
#define CGAL_BOUNDING_ARCS_2_EXCHANGE_POLYGON_AREA_H

#include <CGAL/Bounding_arcs_2/arc/arc_area.h>
#include <CGAL/Bounding_arcs_2/exchange/general_polygon.h>
#include <CGAL/Bounding_arcs_2/query/measures.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/assertions.h>

namespace CGAL::Bounding_arcs {

/// The area of an Arc_polygon_2: positive if it runs counterclockwise.
/// \guarantee certified; the bounds are some ulp of the coordinates times the perimeter apart
template <class Traits> [[nodiscard]] Measure_bounds polygon_area(const CGAL::General_polygon_2<Traits>& polygon) {
  const auto area = twice_area(polygon) / CGAL::Interval_nt<true>(2);
  return {area.inf(), area.sup()};
}
/// The area of an Arc_polygon_with_holes_2, whose holes run clockwise. \pre it is bounded
template <class Polygon>
[[nodiscard]] Measure_bounds polygon_area(const CGAL::General_polygon_with_holes_2<Polygon>& polygon) {
  CGAL_precondition(!polygon.is_unbounded());
  CGAL::Interval_nt<true> sum = twice_area(polygon.outer_boundary());
  for (auto hole = polygon.holes_begin(); hole != polygon.holes_end(); ++hole) sum += twice_area(*hole);
  sum /= CGAL::Interval_nt<true>(2);
  return {sum.inf(), sum.sup()};
}

}  // namespace CGAL::Bounding_arcs

#endif
