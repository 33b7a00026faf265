// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The ways of a query into an index's unit and back: of points, of two indexes, and of what is answered.

#ifndef CGAL_BOUNDING_ARCS_2_INTERNAL_QUERY_COMMON_UNIT_H
#define CGAL_BOUNDING_ARCS_2_INTERNAL_QUERY_COMMON_UNIT_H

#include <CGAL/Bounding_arcs_2/internal/Unit.h>
#include <CGAL/Bounding_arcs_2/query/Curve_index_2.h>
#include <CGAL/Bounding_arcs_2/query/Query_point.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

namespace CGAL::Bounding_arcs::internal {

/// \throws std::invalid_argument for a point that is none, or is out of the range that the unit serves
[[nodiscard]] inline Xy<double> point_in(const Unit& unit, const Xy<double>& q) {
  check_point(q);
  const Xy<double> p = unit.in(q);
  if (!is_queried(p)) throw std::invalid_argument("points are served up to 2^500 times the drawing's coordinates");
  if (!unit.keeps(q)) throw std::invalid_argument("a point's coordinate is lost beside the drawing's");
  return p;
}

[[nodiscard]] inline Closest_point out(const Unit& unit, const Closest_point& p) {
  return {unit.bounds_out(p.distance), unit.out(p.point), p.place, p.status};
}
[[nodiscard]] inline Drawing_point out(const Unit& unit, const Drawing_point& p) {
  return {unit.out(p.point), p.place};
}
[[nodiscard]] inline Drawing_distance out(const Unit& unit, const Drawing_distance& d) {
  return {unit.bounds_out(d.distance), out(unit, d.a), out(unit, d.b), d.status};
}

/// An index in a unit that need not be its own: then it is made again.
class Index_in_unit {
 public:
  /// \param index must outlive this
  Index_in_unit(const Curve_index_2& index, const Unit& unit)
      : made_(index.unit() == unit ? nullptr : index.made_in(unit)), index_(made_ ? made_.get() : &index.in_unit()) {}

  [[nodiscard]] const Curve_index_2& operator*() const { return *index_; }

 private:
  std::shared_ptr<const Curve_index_2> made_;
  const Curve_index_2* index_;
};

/// Two indexes in the larger one's unit.
class Common_unit {
 public:
  Common_unit(const Curve_index_2& a, const Curve_index_2& b)
      : unit_((std::max)(a.unit(), b.unit())), a_(a, unit_), b_(b, unit_) {}

  [[nodiscard]] const Unit& unit() const { return unit_; }
  [[nodiscard]] const Curve_index_2& a() const { return *a_; }
  [[nodiscard]] const Curve_index_2& b() const { return *b_; }

 private:
  Unit unit_;
  Index_in_unit a_, b_;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
