// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Places on the curves of a drawing, each with one name: the end of a piece is the start of the next one.

#ifndef BOUNDING_ARCS_LIBRARY_QUERY_CURVE_JOINTS_H
#define BOUNDING_ARCS_LIBRARY_QUERY_CURVE_JOINTS_H

#include <CGAL/Bounding_arcs_2/query/Intersections_2.h>
#include "../tree/Segment_hierarchy.h"

#include <cstddef>
#include <cstdint>
#include <tuple>

namespace CGAL::Bounding_arcs {

/// A parameter range of a Bezier piece; the end of a piece that another one follows is that one's start.
struct Joint_place {
  std::uint32_t bezier;
  Bracket t;

  [[nodiscard]] bool is_start() const { return t.lower == 0 && t.upper == 0; }
  [[nodiscard]] bool touches(const Joint_place& other) const {
    return bezier == other.bezier && t.lower <= other.t.upper && other.t.lower <= t.upper;
  }
};
/// Compares places by their order on the curves.
[[nodiscard]] inline bool operator<(const Joint_place& p, const Joint_place& q) {
  return std::tie(p.bezier, p.t.lower, p.t.upper) < std::tie(q.bezier, q.t.lower, q.t.upper);
}

/// Which Bezier piece follows which, told by the curves: tables would take the time of all pieces where few meet.
class Curve_joints {
 public:
  explicit Curve_joints(const Segment_hierarchy& curves) : curves_(&curves) {}
  [[nodiscard]] Joint_place place(std::uint32_t bezier, const Bracket& t) const {
    if (!(t.lower == 1 && t.upper == 1)) return {bezier, t};
    const std::size_t curve = curves_->curve_of_bezier(bezier);
    const auto& of_curve = curves_->drawing().curves()[curve];
    const std::uint32_t first = curves_->number_of_bezier(curve, 0);
    if (bezier - first + 1 < of_curve.beziers.size()) return {bezier + 1, {0, 0}};
    return of_curve.is_closed ? Joint_place{first, {0, 0}} : Joint_place{bezier, t};
  }
  [[nodiscard]] Curve_range curve_range(std::uint32_t bezier, const Bracket& t) const {
    const std::size_t curve = curves_->curve_of_bezier(bezier);
    return {static_cast<std::uint32_t>(curve), bezier - curves_->number_of_bezier(curve, 0), t};
  }
  [[nodiscard]] Curve_range curve_range(const Joint_place& p) const { return curve_range(p.bezier, p.t); }
  [[nodiscard]] Xy<double> point(const Joint_place& p) const {
    return curves_->evaluator(p.bezier)(p.t.lower + (p.t.upper - p.t.lower) / 2).point;
  }

 private:
  const Segment_hierarchy* curves_;
};

}  // namespace CGAL::Bounding_arcs

#endif
