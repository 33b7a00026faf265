// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a point is with respect to closed curves: how often they run round it, and whether it is inside.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_POINT_LOCATION_H
#define CGAL_BOUNDING_ARCS_2_QUERY_POINT_LOCATION_H

#include <CGAL/Bounding_arcs_2/curve/Fill_rule.h>
#include <CGAL/Bounding_arcs_2/query/Curve_index_2.h>
#include <CGAL/Bounding_arcs_2/query/closed_curves.h>

#include <cstdint>

namespace CGAL::Bounding_arcs {

/// UNDECIDED only where an index has Query_decisions::DOUBLE.
enum class Point_side : std::uint8_t { INSIDE, OUTSIDE, ON, UNDECIDED };

/// How often closed curves run round a point.
struct Winding_number {
  /// Whether there is a number: there is none on a curve.
  enum class State : std::uint8_t { DECIDED, ON, UNDECIDED };
  State state = State::DECIDED;
  int number = 0;  ///< of all curves together, positive counterclockwise; 0 unless it is decided
};

/// Point location for many points: that all curves are closed is checked once.
class Point_location_2 {
 public:
  /// \param index must outlive this
  /// \throws std::invalid_argument if a curve is open, with its name
  explicit Point_location_2(const Curve_index_2& index) : index_(index) { check_closed(index.drawing()); }

  /// How often the curves run round a point.
  /// \guarantee exact for every point with an index for exact decisions; else right where it is decided
  /// \complexity boxes that a ray to the right meets; exact arithmetic only for pieces within some ulp of the point
  /// \throws std::invalid_argument for a point that is no number
  [[nodiscard]] Winding_number winding_number(const Xy<double>& q) const;

  /// Whether a point is inside, with guarantees as above.
  [[nodiscard]] Point_side locate(const Xy<double>& q, Fill_rule rule = Fill_rule::NONZERO) const {
    const Winding_number w = winding_number(q);
    if (w.state == Winding_number::State::ON) return Point_side::ON;
    if (w.state == Winding_number::State::UNDECIDED) return Point_side::UNDECIDED;
    return is_filled(rule, w.number) ? Point_side::INSIDE : Point_side::OUTSIDE;
  }

 private:
  const Curve_index_2& index_;
};

/// How often the curves of a drawing run round one point; see Point_location_2.
[[nodiscard]] inline Winding_number winding_number(const Curve_index_2& index, const Xy<double>& q) {
  return Point_location_2(index).winding_number(q);
}
/// Whether one point is inside the curves of a drawing; see Point_location_2.
[[nodiscard]] inline Point_side locate(const Curve_index_2& index, const Xy<double>& q,
                                       Fill_rule rule = Fill_rule::NONZERO) {
  return Point_location_2(index).locate(q, rule);
}

}  // namespace CGAL::Bounding_arcs

#ifndef BOUNDING_ARCS_KERNELS
#include <CGAL/Bounding_arcs_2/internal/query/point_location_impl.h>
#endif

#endif
