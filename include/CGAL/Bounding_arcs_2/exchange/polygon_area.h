// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The area of polygons of arcs, whose number is not algebraic, between doubles.

#ifndef CGAL_BOUNDING_ARCS_2_EXCHANGE_POLYGON_AREA_H
#define CGAL_BOUNDING_ARCS_2_EXCHANGE_POLYGON_AREA_H

#include <CGAL/Bounding_arcs_2/exchange/general_polygon.h>
#include <CGAL/Bounding_arcs_2/number/strict_math.h>
#include <CGAL/Bounding_arcs_2/query/measures.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/assertions.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <algorithm>

namespace CGAL::Bounding_arcs {

namespace internal {

// The area along arcs of CGAL's circle segment traits, in intervals.

using Area_interval = CGAL::Interval_nt<true>;

template <class NT> [[nodiscard]] Area_interval to_area_interval(const NT& x) {
  return Area_interval(CGAL::to_interval(x));
}

/// The area between an arc with bulge b >= 0 and its chord, over the chord's square: with R and the angle 4 atan b
///   ((1 + b^2)^2 atan b - b (1 - b^2)) / (8 b^2) = b/3 + b^3/15 - b^5/105 + ... = sum over k >= 1 of
//   (-1)^k b^(2k-1) / ((2k+1)(2k-1)(2k-3)),
/// whose signs alternate from the second term on. For longer arcs a triangle is taken off, and two arcs are left.
[[nodiscard]] inline Area_interval over_square_of_chord(const Area_interval& b) {
  constexpr double SHORT = 0.25;
  const Area_interval square = CGAL::square(b);
  if (b.sup() > SHORT) {
    const Area_interval half = b / (Area_interval(1) + CGAL::sqrt(Area_interval(1) + square));
    return b / Area_interval(4) +
           Area_interval(2) * (Area_interval(1) + square) / Area_interval(4) * over_square_of_chord(half);
  }
  constexpr int TERMS = 13;  // the next one is below 2^-60 of the first
  Area_interval sum(0), power = b;
  for (int k = 1; k <= TERMS; ++k) {
    const double factor = (2.0 * k + 1) * (2 * k - 1) * (2 * k - 3);
    sum += power / Area_interval(k % 2 == 0 ? factor : -factor);
    power *= square;
  }
  return sum + Area_interval(0, 1) * power;  // the rest has the sign of the next term, and is smaller
}

/// Twice what is to the left of a part that is at most half a circle, seen from an origin.
template <class Part>
[[nodiscard]] Area_interval twice_area_along(const Part& part, const Area_interval& x0, const Area_interval& y0) {
  const Area_interval x = to_area_interval(part.source().x()) - x0, y = to_area_interval(part.source().y()) - y0,
                      u = to_area_interval(part.target().x()) - x0, v = to_area_interval(part.target().y()) - y0;
  const Area_interval triangle = x * v - y * u;
  if (part.orientation() == CGAL::COLLINEAR) return triangle;
  const Area_interval square = CGAL::square(u - x) + CGAL::square(v - y);  // of the chord
  const Area_interval squared_radius = to_area_interval(part.supporting_circle().squared_radius());
  const Area_interval above = CGAL::sqrt(squared_radius - square / Area_interval(4));  // 0 for what is below 0
  Area_interval bulge = CGAL::sqrt(square) / (Area_interval(2) * (CGAL::sqrt(squared_radius) + above));
  bulge = Area_interval(bulge.inf(), (std::min)(bulge.sup(), 1.0));
  const Area_interval segment = Area_interval(2) * square * over_square_of_chord(bulge);
  return part.orientation() == CGAL::COUNTERCLOCKWISE ? triangle + segment : triangle - segment;
}

template <class Polygon> [[nodiscard]] Area_interval twice_area(const Polygon& polygon) {
  Area_interval sum(0);
  if (polygon.is_empty()) return sum;
  const auto& corner = polygon.curves_begin()->source();
  const Area_interval x0(CGAL::to_double(corner.x())), y0(CGAL::to_double(corner.y()));
  for (auto part = polygon.curves_begin(); part != polygon.curves_end(); ++part) sum += twice_area_along(*part, x0, y0);
  return sum;
}

}  // namespace internal

/// The area of an Arc_polygon_2: positive if it runs counterclockwise.
/// \guarantee certified; the bounds are some ulp of the coordinates times the perimeter apart
template <class Traits> [[nodiscard]] Measure_bounds polygon_area(const CGAL::General_polygon_2<Traits>& polygon) {
  const auto area = internal::twice_area(polygon) / CGAL::Interval_nt<true>(2);
  return {area.inf(), area.sup()};
}
/// The area of an Arc_polygon_with_holes_2, whose holes run clockwise. \pre it is bounded
template <class Polygon>
[[nodiscard]] Measure_bounds polygon_area(const CGAL::General_polygon_with_holes_2<Polygon>& polygon) {
  CGAL_precondition(!polygon.is_unbounded());
  CGAL::Interval_nt<true> sum = internal::twice_area(polygon.outer_boundary());
  for (auto hole = polygon.holes_begin(); hole != polygon.holes_end(); ++hole) sum += internal::twice_area(*hole);
  sum /= CGAL::Interval_nt<true>(2);
  return {sum.inf(), sum.sup()};
}

}  // namespace CGAL::Bounding_arcs

#endif
