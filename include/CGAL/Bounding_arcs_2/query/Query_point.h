// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What searches for closest points answer.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_QUERY_POINT_H
#define CGAL_BOUNDING_ARCS_2_QUERY_QUERY_POINT_H

#include <CGAL/Bounding_arcs_2/query/Query_status.h>
#include <CGAL/Bounding_arcs_2/query/queried_range.h>
#include <CGAL/Bounding_arcs_2/region/region_bounds.h>
#include <CGAL/Bounding_arcs_2/spiral/Segment_place.h>

#include <cmath>
#include <stdexcept>

namespace CGAL::Bounding_arcs {

/// A point of a drawing and how far it is from where it was asked for.
struct Closest_point {
  Distance_bounds distance;  ///< of the exact curves
  Xy<double> point;          ///< on the curve but for rounding
  Curve_place place;
  Query_status status = Query_status::COMPLETE;
};

/// A point of a drawing.
struct Drawing_point {
  Xy<double> point;  ///< on the curve but for rounding
  Curve_place place;
};
/// A distance with a point of each of two drawings that realises it.
struct Drawing_distance {
  Distance_bounds distance;  ///< of the exact curves
  Drawing_point a, b;
  Query_status status = Query_status::COMPLETE;
};

/// \throws std::invalid_argument for a point that is no number or farther than LARGEST_QUERIED
inline void check_point(const Xy<double>& q) {
  if (!std::isfinite(q.x) || !std::isfinite(q.y))
    throw std::invalid_argument("a point has coordinates that are numbers");
  if (!is_queried(q)) throw std::invalid_argument("points are served up to 2^500 (3e150)");
}

}  // namespace CGAL::Bounding_arcs

#endif
