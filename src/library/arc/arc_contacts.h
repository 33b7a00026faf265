// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where two arcs come within a reach of each other, as far as that is needed to cut them into parts that lie on each
// other, from end to end, or do not touch but at their ends: crossings, ends of one next to the other, and touchings.

#ifndef BOUNDING_ARCS_LIBRARY_ARC_ARC_CONTACTS_H
#define BOUNDING_ARCS_LIBRARY_ARC_ARC_CONTACTS_H

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>
#include <CGAL/Bounding_arcs_2/arc/arc_crossings.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Bounding_arcs {

/// A place on each of two arcs, as Moebius parameters, no farther from each other than the reach.
struct Arc_contact {
  double u, v;
};
/// The places in which two arcs are within reach of each other.
struct Arc_contacts {
  Arc_contact at[7];
  int count = 0;
};

[[nodiscard]] inline double clamped_parameter(const Arc_2& arc, const Xy<double>& q) {
  return (std::min)((std::max)(moebius_parameter(arc, q), 0.0), 1.0);
}

/// \param room what rounding may move points by, at most the reach
[[nodiscard]] inline Arc_contacts contacts(const Arc_2& e, const Arc_2& f, double room, double reach) {
  Arc_contacts result;
  const auto add = [&](double u, double v) { result.at[result.count++] = {u, v}; };
  const auto is_near = [reach](const Xy<double>& q, const Arc_2& arc) {
    return std::fabs(signed_distance(q, arc)) <= reach;
  };
  if (is_near(f.from, e)) add(clamped_parameter(e, f.from), 0);
  if (is_near(f.to, e)) add(clamped_parameter(e, f.to), 1);
  if (is_near(e.from, f)) add(0, clamped_parameter(f, e.from));
  if (is_near(e.to, f)) add(1, clamped_parameter(f, e.to));
  const Arc_crossings found = crossings(e, f, room);
  for (int k = 0; k < found.count; ++k) add(found.at[k].u, found.at[k].v);
  // Where both are nearest to each other without a crossing, side(q(v)) |g|^2 has nearly a double zero.  On one circle
  // no place is nearest.
  const Side_along s = side_along(e, f);
  const double bend = s.c0 - 2 * s.c1 + s.c2, v = (s.c0 - s.c1) / bend;
  const double flat = (1 + e.bulge * e.bulge) * euclidean_norm(e.to - e.from) * reach / 2;
  const bool is_one_circle = std::fabs(s.c0) <= flat && std::fabs(s.c1) <= flat && std::fabs(s.c2) <= flat;
  if (found.count == 0 && !is_one_circle && v > 0 && v < 1) {
    const Xy<double> q = moebius_point(f, v);
    if (is_near(q, e)) add(clamped_parameter(e, q), v);
  }
  return result;
}

}  // namespace CGAL::Bounding_arcs

#endif
