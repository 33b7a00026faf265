// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Drawings in the coordinates of a country, far from the origin and small beside that: moved next to it, exactly.
//
// A number between m and 2 m less one between m and 2 m is exact (Sterbenz 1974).  Points of a drawing and distances
// between them are then told by many more bits than there are at 10^6.  What comes back is rounded once.

#ifndef BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_NEAR_ORIGIN_H
#define BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_NEAR_ORIGIN_H

#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>
#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>
#include <CGAL/Bounding_arcs_2/number/Bounded_double.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// What all coordinates between two are exact beside: one between them, or 0.
[[nodiscard]] inline double exact_origin(double least, double most) {
  if (most < 0) return -exact_origin(-most, -least);
  return most <= 2 * least ? least + (most - least) / 2 : 0;
}
/// A point within a drawing beside which it is small, and its coordinates exact; (0, 0) where there is none.
[[nodiscard]] inline Xy<double> near_origin(const Drawing_2<double>& drawing) {
  if (drawing.curves().empty()) return {0, 0};
  const CGAL::Bbox_2 box = drawing.control_box();
  const Xy<double> origin{exact_origin(box.xmin(), box.xmax()), exact_origin(box.ymin(), box.ymax())};
  const auto size = [&](const Xy<double>& o) {
    return (std::max)({std::fabs(box.xmin() - o.x), std::fabs(box.xmax() - o.x), std::fabs(box.ymin() - o.y),
                       std::fabs(box.ymax() - o.y)});
  };
  constexpr double FAR = 64;  // times as large as the drawing: nearer to the origin little is gained
  return FAR * size(origin) <= size({0, 0}) ? origin : Xy<double>{0, 0};
}

[[nodiscard]] inline Drawing_2<double> moved_along(const Drawing_2<double>& drawing, const Xy<double>& way) {
  Drawing_2<double> moved;
  for (const auto& curve : drawing.curves()) {
    std::vector<Bezier_curve_2<double>> beziers;
    for (const Bezier_curve_2<double>& b : curve.beziers) {
      std::vector<Xy<double>> points = b.control_points();
      for (Xy<double>& p : points) p = p + way;
      beziers.emplace_back(std::move(points), b.weights());
    }
    moved.add(std::move(beziers), curve.name, curve.parameters);
  }
  return moved;
}
/// \param size of coordinates in the end, whose rounding counts
[[nodiscard]] inline Medial_axis_2 moved_along(Medial_axis_2 axis, const Xy<double>& way, double size) {
  const double rounding = 2 * HALF_ULP * size;
  for (Medial_axis_2::Vertex& v : axis.vertices)
    v.center = v.center + way,
    v.clearance = {(std::max)(0.0, v.clearance.lower - rounding), v.clearance.upper + rounding};
  for (Medial_axis_2::Edge& e : axis.edges)
    for (Medial_axis_2::Sample& s : e.samples) s.center = s.center + way;
  for (Xy<double>& p : axis.unresolved) p = p + way;
  axis.error += 2 * rounding;
  axis.bounds = nullptr;  // its parts are elsewhere
  return axis;
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
