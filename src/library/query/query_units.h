// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The ways of a query into a drawing's unit (curve/Unit.h) and of its answer back, tolerances and limits of work.

#ifndef BOUNDING_ARCS_LIBRARY_QUERY_QUERY_UNITS_H
#define BOUNDING_ARCS_LIBRARY_QUERY_QUERY_UNITS_H

#include <CGAL/Bounding_arcs_2/curve/Unit.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/query/Intersections_2.h>
#include <CGAL/Bounding_arcs_2/query/Query_point.h>
#include <CGAL/Bounding_arcs_2/query/kernel_points.h>
#include <CGAL/Bounding_arcs_2/query/measures.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>
#include "../tree/Segment_hierarchy.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace CGAL::Bounding_arcs {

/// \throws std::invalid_argument for a point that the unit does not serve: farther away than all curves by 2^500 of
///   them, or with a coordinate that is lost beside theirs
[[nodiscard]] inline Xy<double> point_in(const internal::Unit& unit, const Xy<double>& q) {
  internal::check_point(q);
  const Xy<double> p = unit.in(q);
  if (!internal::is_queried(p))
    throw std::invalid_argument(expected("point", "coordinates up to 2^500 times the drawing's", q));
  if (!unit.keeps(q))
    throw std::invalid_argument(expected("point", "coordinates that are not lost beside the drawing's", q));
  return p;
}

/// Returns a point that is asked about in a unit.
[[nodiscard]] inline Asked_point point_in(const internal::Unit& unit, const Asked_point& q) {
  if (q.exact) return Asked_point(Xy<Exact_rational>{unit.exactly_in(q.exact->x), unit.exactly_in(q.exact->y)});
  return point_in(unit, q.point);
}

/// Returns a closest point in the drawing's own lengths.
[[nodiscard]] inline Closest_point<> out(const internal::Unit& unit, const Closest_point<>& p) {
  return {unit.bounds_out(p.distance), unit.out(p.point), p.place, p.status};
}
/// Returns a point of a drawing in its own lengths.
[[nodiscard]] inline Drawing_distance<>::End out(const internal::Unit& unit, const Drawing_distance<>::End& p) {
  return {unit.out(p.point), p.place};
}
/// Returns a distance in the drawings' own lengths.
[[nodiscard]] inline Drawing_distance<> out(const internal::Unit& unit, const Drawing_distance<>& d) {
  return {unit.bounds_out(d.distance), out(unit, d.a), out(unit, d.b), d.status};
}

/// Returns common points in the drawings' own lengths.
[[nodiscard]] inline Intersections_2<> out(const internal::Unit& unit, Intersections_2<> found) {
  for (Intersections_2<>::Intersection& i : found.points) i.point = unit.out(i.point);
  return found;
}

/// Bounds of the distance from a point that is at most so far from the one that they are for.
[[nodiscard]] inline Bracket widened(const Bracket& d, double error) {
  constexpr double INFINITE = std::numeric_limits<double>::infinity();
  return {(std::max)(0.0, std::nextafter(d.lower - error, -INFINITE)), std::nextafter(d.upper + error, INFINITE)};
}

/// \throws std::invalid_argument unless a tolerance is a positive number
inline void check_positive(double eps) {
  if (!(eps > 0) || !std::isfinite(eps)) throw std::invalid_argument(expected("eps", "a finite number above 0", eps));
}
/// \throws std::invalid_argument for less than 0 and for no number
inline void check_tolerance(double eps) {
  if (!(eps >= 0)) throw std::invalid_argument(expected("eps", "a number of at least 0", eps));
}

/// How much work a search may take. Halving goes on until a bracket is as narrow as doubles tell, which takes some
/// dozens of pieces. Where curves run at one distance for long, it takes the cube root of the resolution, 1e5 of them.
/// Where errors hide the direction of a curve, it would be as many as the error goes into its length. So each search
/// counts its pieces, and ends at a limit with what it knows by then.
class Work_limit {
 public:
  explicit Work_limit(std::size_t most) : left_(most) {}

  /// \return false where not so much is left
  [[nodiscard]] bool spend(std::size_t work = 1) {
    if (left_ < work) {
      left_ = 0;
      is_reached_ = true;
      return false;
    }
    left_ -= work;
    return true;
  }
  [[nodiscard]] bool is_reached() const { return is_reached_; }

 private:
  std::size_t left_;
  bool is_reached_ = false;
};

/// For one point: pieces that are halved.
[[nodiscard]] inline std::size_t work_of_point(std::size_t segments) { return (std::size_t(1) << 19) + 16 * segments; }
/// For two drawings: pairs of pieces, or of boxes, which take some Newton steps.
[[nodiscard]] inline std::size_t work_of_pairs(std::size_t segments) {
  return (std::size_t(1) << 19) + 2048 * segments;
}
/// For points of one drawing and another one: pieces that are halved, and each point counts for some.
[[nodiscard]] inline std::size_t work_of_points(std::size_t segments) {
  return (std::size_t(1) << 21) + 256 * segments;
}
/// For a sum or a hull: pieces that are kept, some 200 bytes each.
[[nodiscard]] inline std::size_t most_pieces(std::size_t segments) { return (std::size_t(1) << 18) + 16 * segments; }

/// The status of a bracket so wide that a tolerance was asked for.
[[nodiscard]] inline Query_status status_of(double width, double tolerance, bool is_limited) {
  if (width <= tolerance) return Query_status::COMPLETE;
  return is_limited ? Query_status::LIMIT_REACHED : Query_status::RESOLUTION_REACHED;
}

/// Bounds of a measure, with the status of being so wide where a tolerance was asked for.
[[nodiscard]] inline Measure_bounds measured(double lower, double upper, double tolerance, bool is_limited) {
  return {lower, upper, status_of(upper - lower, tolerance, is_limited)};
}

}  // namespace CGAL::Bounding_arcs

namespace CGAL::Bounding_arcs::internal {

/// The longer side of a drawing's box; 0 of an empty one.
[[nodiscard]] inline double extent_of(const Segment_hierarchy& curves) {
  if (curves.empty()) return 0;
  const CGAL::Bbox_2& box = curves.boxes().box();
  return (std::max)(box.xmax() - box.xmin(), box.ymax() - box.ymin());
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
