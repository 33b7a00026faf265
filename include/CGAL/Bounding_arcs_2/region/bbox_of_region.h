// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Axis-aligned boxes of regions, without centers: end points, and the height of an arc where it turns past an axis.

#ifndef CGAL_BOUNDING_ARCS_2_REGION_BBOX_OF_REGION_H
#define CGAL_BOUNDING_ARCS_2_REGION_BBOX_OF_REGION_H

#include <CGAL/Bounding_arcs_2/number/convert.h>
#include <CGAL/Bounding_arcs_2/region/Contact_circle_2.h>

#include <CGAL/Bbox_2.h>

namespace CGAL::Bounding_arcs {
/// \guarantee holds the exact arc or segment
template <class NT> [[nodiscard]] CGAL::Bbox_2 bbox_of_piece(const Boundary_piece_2<NT>& piece) {
  using Interval = CGAL::Interval_nt<true>;
  const Xy<Interval> p = convert<Interval>(piece.from), q = convert<Interval>(piece.to);
  const CGAL::Bbox_2 ends = CGAL::Bbox_2(p.x.inf(), p.y.inf(), p.x.sup(), p.y.sup()) +
                            CGAL::Bbox_2(q.x.inf(), q.y.inf(), q.x.sup(), q.y.sup());
  if (piece.is_segment()) return ends;
  // height = (c^2/4) kappa / (1 + sqrt(1 - kappa^2 c^2/4)) <= (c^2/4) kappa / 1 for an arc of at most half a circle
  const Xy<Interval> n = convert<Interval>(piece.support.normal);
  const Interval kappa = CGAL::abs(convert<Interval>(piece.support.curvature)) / CGAL::sqrt(dot(n, n));
  const double height = (dot(q - p, q - p) / Interval(4) * kappa).sup();
  // Does the tangent turn past an axis? With v = end - point the normal there is n - curvature v.
  const Xy<NT> a = piece.support.normal_at(piece.from), b = piece.support.normal_at(piece.to);
  const double wide_x = sign_of(a.y) == sign_of(b.y) && sign_of(a.y) != 0 ? 0 : height;
  const double wide_y = sign_of(a.x) == sign_of(b.x) && sign_of(a.x) != 0 ? 0 : height;
  const Interval x0 = Interval(ends.xmin()) - Interval(wide_x), x1 = Interval(ends.xmax()) + Interval(wide_x);
  const Interval y0 = Interval(ends.ymin()) - Interval(wide_y), y1 = Interval(ends.ymax()) + Interval(wide_y);
  return CGAL::Bbox_2(x0.inf(), y0.inf(), x1.sup(), y1.sup());
}

/// A box that holds both boundaries, of a Region_boundary_2 or a Region_outline_2.
/// \guarantee certified where the boundary's coordinates and signs are exact; not the smallest box
template <class Boundary> [[nodiscard]] CGAL::Bbox_2 bbox_of_region(const Boundary& region) {
  CGAL::Bbox_2 box;
  for (const auto& piece : region.inner) box += bbox_of_piece(piece);
  for (const auto& piece : region.outer) box += bbox_of_piece(piece);
  return box;
}

}  // namespace CGAL::Bounding_arcs

#endif
