// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What searches for closest points and point location answer.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_QUERY_POINT_H
#define CGAL_BOUNDING_ARCS_2_QUERY_QUERY_POINT_H

#include <CGAL/Bounding_arcs_2/curve/Fill_rule.h>
#include <CGAL/Bounding_arcs_2/curve/served_range.h>
#include <CGAL/Bounding_arcs_2/number/Bracket.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/number/strict_math.h>
#include <CGAL/Bounding_arcs_2/query/kernel_points.h>
#include <CGAL/Bounding_arcs_2/spiral/Segment_place.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <cmath>
#include <cstdint>
#include <ostream>
#include <stdexcept>

namespace CGAL::Bounding_arcs {

/// How often closed curves run round a point.
struct Winding_number {
  /// Whether there is a number: there is none on a curve.
  enum class State : std::uint8_t { DECIDED, ON, UNDECIDED };
  State state = State::DECIDED;
  int number = 0;  ///< of all curves together, positive counterclockwise; 0 unless it is decided

  /// The side that the number has under a fill rule; uncertain where that is undecided.
  [[nodiscard]] Uncertain<Bounded_side> side(Fill_rule rule) const {
    if (state == State::ON) return ON_BOUNDARY;
    if (state == State::UNDECIDED) return Uncertain<Bounded_side>::indeterminate();
    return is_filled(rule, number) ? ON_BOUNDED_SIDE : ON_UNBOUNDED_SIDE;
  }
};

/// How a search ended. Its bracket holds the true number whatever the status is.
enum class Query_status : std::uint8_t {
  COMPLETE,            ///< the bracket is as narrow as was asked, or as doubles tell where no tolerance was
  RESOLUTION_REACHED,  ///< the bracket is wider than the tolerance, as doubles tell no more
  LIMIT_REACHED        ///< the bracket is wider: the search took as much work as one in a drawing of this size may take
};

/// The answer to closest_point(): the nearest point of a drawing, where it is on the curves, and how far away it is.
/// \code
/// if (const auto found = closest_point(tree, {1, 1}))  // nothing of an empty tree
///   std::cout << found->point << " on curve " << found->place.curve << ", " << found->distance.upper << " away\n";
/// \endcode
/// `distance` is a bracket: the true distance of the exact curves lies between `lower` and `upper`, which are some
/// roundings apart. `point` is rounded; `place` names the curve, the Bezier piece and the parameter. Several points may
/// be nearest, and the answer is one of them. `status` matters only if the bracket is too wide for you.
///
/// Take closest_points() for all points that are about as near, k_nearest_curves() for the nearest curves, and
/// closest_points_of_all() for many points at once. Take signed_distance() where you also need to know the side.
/// \tparam Point the point type of the kernel that was asked with
template <class Point = Xy<double>> struct Closest_point {
  struct On_segment;  ///< the nearest point of curves of one's own, closest_on_regions.h

  Bracket distance;  ///< of the exact curves
  Point point;       ///< on the curve but for rounding
  Curve_place place;
  Query_status status = Query_status::COMPLETE;

  template <class Other> operator Closest_point<Other>() const {  // NOLINT: the same with another kernel's point
    return {distance, internal::answered<Other>(point), place, status};
  }

  /// Writes the members in their order, with a blank between.
  friend std::ostream& operator<<(std::ostream& out, const Closest_point& answer) {
    return out << answer.distance << ' ' << answer.point << ' ' << answer.place;
  }
};

/// A distance with the side, and where it is measured.
/// \code
/// const auto found = signed_distance(closed, {0.1, 0});  // a tree of closed curves
/// if (found && found->side == CGAL::ON_BOUNDED_SIDE) std::cout << -found->distance.upper << " deep at least\n";
/// \endcode
template <class Point = Xy<double>> struct Signed_distance {
  Bracket distance;  ///< of the exact curves, with its sign: both bounds are at most 0 inside, both 0 on a curve
  Uncertain<Bounded_side> side;
  Point point;  ///< the nearest one, on the curve but for rounding
  Curve_place place;
  Query_status status = Query_status::COMPLETE;

  /// A distance with the sign of a side; 0 on a curve.
  [[nodiscard]] static Signed_distance of(const Closest_point<Point>& found, const Uncertain<Bounded_side>& side) {
    Bracket d = found.distance;
    if (!is_certain(side)) d = {-d.upper, d.upper};
    else if (side == ON_BOUNDARY) d = {0, 0};
    else if (side == ON_BOUNDED_SIDE) d = {0 - d.upper, 0 - d.lower};  // no -0
    return {d, side, found.point, found.place, found.status};
  }

  template <class Other> operator Signed_distance<Other>() const {  // NOLINT: the same with another kernel's point
    return {distance, side, internal::answered<Other>(point), place, status};
  }

  /// Writes the members in their order, with a blank between.
  friend std::ostream& operator<<(std::ostream& out, const Signed_distance& answer) {
    return out << answer.distance << ' ' << answer.point << ' ' << answer.place;
  }
};

/// A distance of two drawings and the points, one of each, where it is.
/// \code
/// if (const auto gap = distance(tree, other))
///   std::cout << gap->distance.lower << " between " << gap->a.point << " and " << gap->b.point << '\n';
/// \endcode
template <class Point = Xy<double>> struct Drawing_distance {
  /// A point of one of two drawings.
  struct End {
    Point point;  ///< on the curve but for rounding
    Curve_place place;

    /// Writes the members in their order, with a blank between.
    friend std::ostream& operator<<(std::ostream& out, const End& answer) {
      return out << answer.point << ' ' << answer.place;
    }
  };

  Bracket distance;  ///< of the exact curves
  End a, b;
  Query_status status = Query_status::COMPLETE;

  template <class Other> operator Drawing_distance<Other>() const {  // NOLINT: the same with another kernel's points
    return {
        distance, {internal::answered<Other>(a.point), a.place}, {internal::answered<Other>(b.point), b.place}, status};
  }

  /// Writes the members in their order, with a blank between.
  friend std::ostream& operator<<(std::ostream& out, const Drawing_distance& answer) {
    return out << answer.distance << ' ' << answer.a << ' ' << answer.b;
  }
};

namespace internal {
/// \throws std::invalid_argument for a point that is no number or out of the range of queries
inline void check_point(const Xy<double>& q) {
  if (!std::isfinite(q.x) || !std::isfinite(q.y))
    throw std::invalid_argument(expected("point", "finite coordinates", q));
  if (!is_queried(q)) throw std::invalid_argument(expected("point", "coordinates up to 2^500 (3e150)", q));
}
}  // namespace internal

}  // namespace CGAL::Bounding_arcs

#endif
