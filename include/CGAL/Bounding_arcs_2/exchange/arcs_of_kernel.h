// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Arcs by ends and bulge from those of CGAL that have a circle: Circular_arc_2 and Line_arc_2 of the circular kernel,
// and the curves of Arr_circle_segment_traits_2.  Their ends may be algebraic, so all is rounded to double.

#ifndef CGAL_BOUNDING_ARCS_2_EXCHANGE_ARCS_OF_KERNEL_H
#define CGAL_BOUNDING_ARCS_2_EXCHANGE_ARCS_OF_KERNEL_H

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>
#include <CGAL/Bounding_arcs_2/number/points_of_kernel.h>
#include <CGAL/Bounding_arcs_2/region/variant.h>

#include <CGAL/Circular_arc_2.h>
#include <CGAL/Line_arc_2.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <vector>

namespace CGAL::Bounding_arcs {

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

/// An arc of a kernel, rounded to doubles, in arcs of at most half a circle.
template <class CK> [[nodiscard]] std::vector<Arc_2> arcs_of(const CGAL::Circular_arc_2<CK>& arc) {
  return arcs_on_circle(point_of_kernel<double>(arc.source()), point_of_kernel<double>(arc.target()),
                        point_of_kernel<double>(arc.center()), CGAL::to_double(arc.squared_radius()), true);
}
/// A segment as an arc without bulge.
template <class CK> [[nodiscard]] std::vector<Arc_2> arcs_of(const CGAL::Line_arc_2<CK>& segment) {
  return {{point_of_kernel<double>(segment.source()), point_of_kernel<double>(segment.target()), 0}};
}
/// An x-monotone curve of Arr_circular_line_arc_traits_2, which is one of the two.
template <class CK>
[[nodiscard]] std::vector<Arc_2> arcs_of(const Variant<CGAL::Line_arc_2<CK>, CGAL::Circular_arc_2<CK>>& part) {
  if (const auto* arc = get_if<CGAL::Circular_arc_2<CK>>(part)) return arcs_of(*arc);
  return arcs_of(*get_if<CGAL::Line_arc_2<CK>>(part));
}
/// An x-monotone curve of Arr_circle_segment_traits_2, or what has its members.
template <class Curve> [[nodiscard]] std::vector<Arc_2> arcs_of_part(const Curve& part) {
  const Xy<double> from = point_of_kernel<double>(part.source()), to = point_of_kernel<double>(part.target());
  if (part.orientation() == CGAL::COLLINEAR) return {{from, to, 0}};
  const auto& circle = part.supporting_circle();
  return arcs_on_circle(from, to, point_of_kernel<double>(circle.center()), CGAL::to_double(circle.squared_radius()),
                        part.orientation() == CGAL::COUNTERCLOCKWISE);
}

}  // namespace CGAL::Bounding_arcs

#endif
