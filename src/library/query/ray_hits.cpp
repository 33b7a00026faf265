// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of query/ray_hits.h and query/point_location.h.

#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/number/stable_norm.h>
#include <CGAL/Bounding_arcs_2/query/point_location.h>
#include <CGAL/Bounding_arcs_2/query/ray_hits.h>
#include "../tree/Segment_hierarchy.h"
#include "Ray_search.h"
#include "Winding_search.h"
#include "query_units.h"

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

// Finds the hits of a ray on curves whose unit is one.
[[nodiscard]] static std::vector<Ray_hit<>> hits_in_unit(const Segment_hierarchy& curves, const Asked_point& start,
                                                         const Asked_point& way) {
  const Xy<double>&q = start.point, &direction = way.point;
  const double length = stable_norm(direction);
  if (!std::isfinite(q.x) || !std::isfinite(q.y))
    throw std::invalid_argument(expected("start", "finite coordinates", q));
  if (!std::isfinite(length) || length == 0)
    throw std::invalid_argument(expected("direction", "a finite vector other than (0, 0)", direction));
  Ray_search search(curves, start, way);
  std::vector<Ray_hit<>> hits;
  const int exponent = std::ilogb((std::max)(std::fabs(direction.x), std::fabs(direction.y)));
  const Xy<double> unit = Ray_search::scaled(direction);
  const bool is_kept = Xy<double>{std::scalbn(unit.x, exponent), std::scalbn(unit.y, exponent)} == direction;
  if (is_kept && !start.exact && !way.exact)
    if (const auto found = Ray_filter(curves, q, unit).hits(search.segments())) {
      for (const Filtered_hit& hit : *found)
        hits.push_back({curves.place_at(hit.segment, hit.t),
                        curves.evaluator(curves.bezier_of(hit.segment))(hit.t).point, hit.distance, false});
      return hits;
    }
  for (const Exact_hit& hit : search.search()) {
    const std::uint32_t segment = hit.piece->segment;
    const double t = std::clamp(CGAL::to_double(Exact_rational((hit.t.lower() + hit.t.upper()) / 2)), 0.0, 1.0);
    const double of_quotient =
        (way.exact ? 6 : 4) * HALF_ULP;  // stable_norm errs by an ulp, a rounded direction adds one
    hits.push_back({curves.place_at(segment, t),
                    curves.evaluator(curves.bezier_of(segment))(t).point,
                    {(std::max)(0.0, CGAL::to_interval(hit.way.low).first / length * (1 - of_quotient)),
                     CGAL::to_interval(hit.way.high).second / length * (1 + of_quotient)},
                    hit.is_along});
  }
  return hits;
}

std::vector<Ray_hit<>> ray_hits(const Bounding_arc_tree_2& curves, const Asked_point& q, const Asked_point& direction) {
  const Unit& unit = curves.unit();
  std::vector<Ray_hit<>> hits = hits_in_unit(curves.in_unit(), point_in(unit, q), direction);
  for (Ray_hit<>& hit : hits) hit.point = unit.out(hit.point), hit.distance = unit.bounds_out(hit.distance);
  return hits;
}

}  // namespace CGAL::Bounding_arcs::internal

namespace CGAL::Bounding_arcs {

Winding_number Point_location_2::winding_number(const Asked_point& q) const {
  return Bounding_arcs::winding_number(tree_->in_unit(), point_in(tree_->unit(), q));
}

}  // namespace CGAL::Bounding_arcs
