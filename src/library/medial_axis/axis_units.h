// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The ways of an axis into a unit and back (curve/Unit.h).

#ifndef BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_AXIS_UNITS_H
#define BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_AXIS_UNITS_H

#include <CGAL/Bounding_arcs_2/curve/Unit.h>
#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL::Bounding_arcs::internal {

/// The unit of an axis, as that of a drawing.
[[nodiscard]] inline Unit unit_of(const Medial_axis_2& axis) {
  double size = 0;
  for (const Medial_axis_2::Vertex& v : axis.vertices)
    size = (std::max)({size, std::fabs(v.center.x), std::fabs(v.center.y), v.radius});
  for (const Medial_axis_2::Edge& e : axis.edges)
    for (const Medial_axis_2::Sample& s : e.samples)
      size = (std::max)({size, std::fabs(s.center.x), std::fabs(s.center.y), s.radius});
  return Unit::of_size(size);
}

template <class Lengths, class Bounds>
[[nodiscard]] Medial_axis_2 with_lengths(Medial_axis_2 axis, const Lengths& scaled, const Bounds& bounds) {
  for (Medial_axis_2::Vertex& v : axis.vertices)
    v.center = {scaled(v.center.x), scaled(v.center.y)}, v.radius = scaled(v.radius), v.clearance = bounds(v.clearance);
  for (Medial_axis_2::Edge& e : axis.edges)
    for (Medial_axis_2::Sample& s : e.samples)
      s.center = {scaled(s.center.x), scaled(s.center.y)}, s.radius = scaled(s.radius);
  for (Xy<double>& p : axis.unresolved) p = {scaled(p.x), scaled(p.y)};
  axis.eps = bounds(Bracket{0, axis.eps}).upper;
  axis.error = bounds(Bracket{0, axis.error}).upper;
  axis.moved = bounds(Bracket{0, axis.moved}).upper;
  return axis;
}
[[nodiscard]] inline Medial_axis_2 in(const Unit& unit, Medial_axis_2 axis) {
  if (unit.is_one()) return axis;
  return with_lengths(
      std::move(axis), [&](double x) { return unit.in(x); },
      [&](const Bracket& b) {
        return Bracket{unit.in(b.lower), unit.in(b.upper)};
      });
}
[[nodiscard]] inline Medial_axis_2 out(const Unit& unit, Medial_axis_2 axis) {
  if (unit.is_one()) return axis;
  return with_lengths(
      std::move(axis), [&](double x) { return unit.out(x); }, [&](const Bracket& b) { return unit.bounds_out(b); });
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
