// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Chains of arcs and CGAL's polygons as curves of a drawing: segments as Bezier curves of degree 1, arcs as rational
// quadratics.

#ifndef CGAL_BOUNDING_ARCS_2_EXCHANGE_ADD_TO_DRAWING_H
#define CGAL_BOUNDING_ARCS_2_EXCHANGE_ADD_TO_DRAWING_H

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>
#include <CGAL/Bounding_arcs_2/arc/arc_beziers.h>
#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>
#include <CGAL/Bounding_arcs_2/number/points_of_kernel.h>
#include <CGAL/Bounding_arcs_2/region/variant.h>

#include <CGAL/Circular_arc_2.h>
#include <CGAL/General_polygon_2.h>
#include <CGAL/General_polygon_with_holes_2.h>
#include <CGAL/Line_arc_2.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/assertions.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

// Arcs by ends and bulge from those of CGAL that have a circle: Circular_arc_2 and Line_arc_2 of the circular kernel,
// and the curves of Arr_circle_segment_traits_2.  Their ends may be algebraic, so all is rounded to double.

namespace internal {
/// The arc of a circle between two points on it, as one Arc_2, or two where it is more than half of the circle. Equal
/// ends are the whole circle.
/// \guarantee ends as given; the bulge within some u of itself and the error of the center over the radius
[[nodiscard]] inline std::vector<Arc_2> arcs_on_circle(const Xy<double>& from, const Xy<double>& to,
                                                       const Xy<double>& center, double squared_radius, bool ccw) {
  const Xy<double> opposite{2 * center.x - from.x, 2 * center.y - from.y};
  const double sign = ccw ? 1 : -1;
  if (from == to) return {{from, opposite, sign}, {opposite, to, sign}};
  const Xy<double> chord = to - from;
  const double length = euclidean_norm(chord), radius = std::sqrt(squared_radius);
  // with h the distance of the center from the chord, on the arc's inner side: (radius + h) (radius - h) = length^2 / 4
  const double h = sign * cross(chord, center - from) / length;
  if (h >= 0) return {{from, to, sign * (std::fmin)(1.0, length / 2 / (radius + h))}};
  const Xy<double> outward = (sign * radius / length) * perp(chord), middle = center - outward;
  const double half = (radius - h) / (length / 2), quarter = half / (1 + std::sqrt(1 + half * half));
  return {{from, middle, sign * quarter}, {middle, to, sign * quarter}};
}
}  // namespace internal

/// An arc of a kernel, rounded to doubles, in arcs of at most half a circle.
template <class CK> [[nodiscard]] std::vector<Arc_2> arcs_of(const CGAL::Circular_arc_2<CK>& arc) {
  return internal::arcs_on_circle(
      internal::point_of_kernel<double>(arc.source()), internal::point_of_kernel<double>(arc.target()),
      internal::point_of_kernel<double>(arc.center()), CGAL::to_double(arc.squared_radius()), true);
}
/// A segment as an arc without bulge.
template <class CK> [[nodiscard]] std::vector<Arc_2> arcs_of(const CGAL::Line_arc_2<CK>& segment) {
  return {
      {internal::point_of_kernel<double>(segment.source()), internal::point_of_kernel<double>(segment.target()), 0}};
}
/// An x-monotone curve of Arr_circular_line_arc_traits_2, which is one of the two.
template <class CK>
[[nodiscard]] std::vector<Arc_2> arcs_of(const Variant<CGAL::Line_arc_2<CK>, CGAL::Circular_arc_2<CK>>& part) {
  if (const auto* arc = get_if<CGAL::Circular_arc_2<CK>>(part)) return arcs_of(*arc);
  return arcs_of(*get_if<CGAL::Line_arc_2<CK>>(part));
}
/// An x-monotone curve of Arr_circle_segment_traits_2, or what has its members.
template <class Curve> [[nodiscard]] std::vector<Arc_2> arcs_of(const Curve& part) {
  const Xy<double> from = internal::point_of_kernel<double>(part.source()),
                   to = internal::point_of_kernel<double>(part.target());
  if (part.orientation() == CGAL::COLLINEAR) return {{from, to, 0}};
  const auto& circle = part.supporting_circle();
  return internal::arcs_on_circle(from, to, internal::point_of_kernel<double>(circle.center()),
                                  CGAL::to_double(circle.squared_radius()),
                                  part.orientation() == CGAL::COUNTERCLOCKWISE);
}

/// Appends a chain of arcs as one curve. Arcs whose ends are equal are left out.
/// \throws std::invalid_argument if there is no other arc, or one does not start where the one before ends
inline void add_to_drawing(Drawing_2<double>& drawing, const std::vector<Arc_2>& arcs, std::string name = {}) {
  std::vector<Bezier_curve_2<double>> curves;
  for (const Arc_2& arc : arcs) {
    if (arc.from == arc.to) continue;
    for (auto& curve : arc_beziers<double>(arc.from, arc.to, arc.bulge)) curves.push_back(std::move(curve));
  }
  drawing.add(std::move(curves), std::move(name));
}

/// Appends a polygon as a closed curve.
/// \throws std::invalid_argument if it has less than two different corners
template <class Kernel, class Container>
void add_to_drawing(Drawing_2<double>& drawing, const CGAL::Polygon_2<Kernel, Container>& polygon,
                    std::string name = {}) {
  const std::vector<Xy<double>> corners = internal::points_of_kernel<double>(polygon.container());
  std::vector<Arc_2> sides;
  for (std::size_t i = 0; i < corners.size(); ++i) sides.push_back({corners[i], corners[(i + 1) % corners.size()], 0});
  add_to_drawing(drawing, sides, std::move(name));
}
/// Appends the boundary of a polygon of arcs and segments as a closed curve.
template <class Traits>
void add_to_drawing(Drawing_2<double>& drawing, const CGAL::General_polygon_2<Traits>& polygon, std::string name = {}) {
  std::vector<Arc_2> arcs;
  for (auto part = polygon.curves_begin(); part != polygon.curves_end(); ++part)
    for (const Arc_2& arc : arcs_of(*part)) {
      arcs.push_back(arc);
      if (arcs.size() > 1) arcs.back().from = arcs[arcs.size() - 2].to;  // the same point, whichever way it is rounded
    }
  if (!arcs.empty()) arcs.back().to = arcs.front().from;
  add_to_drawing(drawing, arcs, std::move(name));
}
/// Appends a polygon with its holes, each a curve of its own with the same name. \pre it is bounded
/// \throws std::invalid_argument if a boundary has less than two different corners; the drawing is then as it was
template <class Polygon>
void add_to_drawing(Drawing_2<double>& drawing, const CGAL::General_polygon_with_holes_2<Polygon>& polygon,
                    const std::string& name = {}) {
  CGAL_precondition(!polygon.is_unbounded());
  Drawing_2<double> added;  // whatever is wrong is thrown here
  add_to_drawing(added, polygon.outer_boundary(), name);
  for (auto hole = polygon.holes_begin(); hole != polygon.holes_end(); ++hole) add_to_drawing(added, *hole, name);
  for (const auto& curve : added.curves()) drawing.add(curve.beziers, name);
}

}  // namespace CGAL::Bounding_arcs

#endif
