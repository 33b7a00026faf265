// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a ray meets the curves of a drawing, in order.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_RAY_HITS_H
#define CGAL_BOUNDING_ARCS_2_QUERY_RAY_HITS_H

#include <CGAL/Bounding_arcs_2/query/Query_point.h>
#include <CGAL/Bounding_arcs_2/query/kernel_points.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>

#include <ostream>
#include <vector>

namespace CGAL::Bounding_arcs {

/// A point of a drawing on a ray.
/// \code
/// for (const auto& hit : ray_hits(tree, {-2, 0}, {1, 0}))
///   std::cout << hit.point << " on curve " << hit.place.curve << '\n';
/// \endcode
template <class Point = Xy<double>> struct Ray_hit {
  Curve_place place;      ///< at a joint of Bezier pieces that of the later one
  Point point;            ///< on the curve but for rounding
  Bracket distance;       ///< of the exact curve's point from the ray's start
  bool is_along = false;  ///< a Bezier piece lies along the ray: one of the places that bound its parts on it

  template <class Other> operator Ray_hit<Other>() const {  // NOLINT: the same with another kernel's point
    return {place, internal::answered<Other>(point), distance, is_along};
  }

  /// Writes the members in their order, with a blank between.
  friend std::ostream& operator<<(std::ostream& out, const Ray_hit& answer) {
    return out << answer.place << ' ' << answer.point << ' ' << answer.distance;
  }
};

namespace internal {
[[nodiscard]] std::vector<Ray_hit<>> ray_hits(const Bounding_arc_tree_2& tree, const Asked_point& q,
                                              const Asked_point& direction);
}  // namespace internal

/// Returns all points in which a ray meets the curves of a drawing, the nearest first.
/// The ray is closed: a point of a curve that it starts in is met at distance 0. Points that it touches a curve in are
/// met once; several curves, or places of one, in one point several times. A Bezier piece along the ray is told by its
/// ends, by where it turns back, and by the ray's start, if these are on the ray and on the piece.
/// \param direction a vector of any kernel, not 0; its length does not matter
/// \guarantee exact: none is missed, invented or counted twice. All are in order, but those whose parameters would have
///   to be told to about 1000 bits for it. Exact arithmetic is used for what doubles leave open over every kernel
/// \complexity boxes that the ray meets, and a few microseconds for each Bezier piece that it comes near. Where the ray
///   touches a piece or passes its end, or numbers are no doubles, about a tenth of a millisecond each
/// \throws std::invalid_argument for a point or a direction that is no number, or a direction that is 0
template <class Point = Default_kernel::Point_2>
[[nodiscard]] std::vector<Ray_hit<Point>> ray_hits(const Bounding_arc_tree_2& tree, const Point& q,
                                                   const Asked_point& direction) {
  return internal::answered<Ray_hit<Point>>(internal::ray_hits(tree, q, direction));
}

}  // namespace CGAL::Bounding_arcs

#endif
