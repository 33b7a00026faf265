// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Chains of arcs and CGAL's polygons as curves of a drawing: segments as Bezier curves of degree 1, arcs as rational
// quadratics.

#ifndef CGAL_BOUNDING_ARCS_2_EXCHANGE_ADD_TO_DRAWING_H
#define CGAL_BOUNDING_ARCS_2_EXCHANGE_ADD_TO_DRAWING_H

#include <CGAL/Bounding_arcs_2/arc/arc_beziers.h>
#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>
#include <CGAL/Bounding_arcs_2/exchange/arcs_of_kernel.h>

#include <CGAL/General_polygon_2.h>
#include <CGAL/General_polygon_with_holes_2.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/assertions.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

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
  const std::vector<Xy<double>> corners = points_of_kernel<double>(polygon.container());
  std::vector<Arc_2> sides;
  for (std::size_t i = 0; i < corners.size(); ++i) sides.push_back({corners[i], corners[(i + 1) % corners.size()], 0});
  add_to_drawing(drawing, sides, std::move(name));
}
/// Appends the boundary of a polygon of arcs and segments as a closed curve.
template <class Traits>
void add_to_drawing(Drawing_2<double>& drawing, const CGAL::General_polygon_2<Traits>& polygon, std::string name = {}) {
  std::vector<Arc_2> arcs;
  for (auto part = polygon.curves_begin(); part != polygon.curves_end(); ++part)
    for (const Arc_2& arc : arcs_of_part(*part)) {
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
