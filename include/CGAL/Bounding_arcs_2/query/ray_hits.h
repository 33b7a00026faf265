// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a ray meets the curves of a drawing, in order.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_RAY_HITS_H
#define CGAL_BOUNDING_ARCS_2_QUERY_RAY_HITS_H

#include <CGAL/Bounding_arcs_2/internal/query/Ray_filter.h>
#include <CGAL/Bounding_arcs_2/internal/query/Ray_search.h>
#include <CGAL/Bounding_arcs_2/query/Curve_index_2.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace CGAL::Bounding_arcs {

/// A point of a drawing on a ray.
struct Ray_hit {
  Curve_place place;         ///< at a joint of Bezier pieces that of the later one
  Xy<double> point;          ///< on the curve but for rounding
  Distance_bounds distance;  ///< of the exact curve's point from the ray's start
  bool is_along = false;     ///< a Bezier piece lies along the ray: one of the places that bound its parts on it
};

/// All points in which a ray meets the curves of a drawing, the nearest first.
/// The ray is closed: a point of a curve that it starts in is met at distance 0. Points that it touches a curve in are
/// met once; several curves, or places of one, in one point several times. Of a Bezier piece along the ray its ends,
/// where it turns back and the ray's start are told, if they are on the ray.
/// \param direction not 0; its length does not matter
/// \guarantee exact: none is missed, invented or counted twice, and all are in order, but those whose parameters would
///   have to be told to about 1000 bits for it; exact arithmetic is used for what doubles leave open whatever the index
///   asks for
/// \complexity boxes that the ray meets, and a few microseconds for each Bezier piece that it comes near; about a tenth
///   of a millisecond for each of them where the ray touches one or passes its end, or numbers are no doubles
/// \throws std::invalid_argument for a point or a direction that is no number, or a direction that is 0
[[nodiscard]] inline std::vector<Ray_hit> ray_hits(const Curve_index_2& index, const Xy<double>& q,
                                                   const Xy<double>& direction) {
  const double length = std::hypot(direction.x, direction.y);
  if (!std::isfinite(q.x) || !std::isfinite(q.y) || !std::isfinite(length) || length == 0)
    throw std::invalid_argument("a ray has a start and a direction that are numbers, and the direction is not 0");
  internal::Ray_search search(index, q, direction);
  std::vector<Ray_hit> hits;
  const int exponent = std::ilogb((std::max)(std::fabs(direction.x), std::fabs(direction.y)));
  const Xy<double> unit = internal::Ray_search::scaled(direction);
  if (Xy<double>{std::scalbn(unit.x, exponent), std::scalbn(unit.y, exponent)} == direction)
    if (const auto found = internal::Ray_filter(index, q, unit).hits(search.segments())) {
      for (const internal::Filtered_hit& hit : *found)
        hits.push_back({index.place_at(hit.segment, hit.t), index.evaluator(index.bezier_of(hit.segment))(hit.t).point,
                        hit.distance, false});
      return hits;
    }
  for (const internal::Exact_hit& hit : search.search()) {
    const std::uint32_t segment = hit.piece->segment;
    const double t = std::clamp(CGAL::to_double(Exact_rational((hit.t.low + hit.t.high) / 2)), 0.0, 1.0);
    constexpr double OF_QUOTIENT = 4 * ARC_HALF_ULP;  // hypot errs by an ulp
    hits.push_back({index.place_at(segment, t),
                    index.evaluator(index.bezier_of(segment))(t).point,
                    {(std::max)(0.0, CGAL::to_interval(hit.way.low).first / length * (1 - OF_QUOTIENT)),
                     CGAL::to_interval(hit.way.high).second / length * (1 + OF_QUOTIENT)},
                    hit.is_along});
  }
  return hits;
}

}  // namespace CGAL::Bounding_arcs

#endif
