// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One side of a region as arcs, and moved along its normals (see exchange/widened_outline.h).

#ifndef CGAL_BOUNDING_ARCS_2_EXCHANGE_INTERNAL_MOVED_SIDE_H
#define CGAL_BOUNDING_ARCS_2_EXCHANGE_INTERNAL_MOVED_SIDE_H

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>
#include <CGAL/Bounding_arcs_2/region/Arc_region_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

using Arc_side = std::vector<Arc_2>;

[[nodiscard]] inline Arc_side arcs_of(const Arc_region_2& region, const Arc_side_2& side) {
  if (side.size == 1) return {{region.from, region.to, side.bulges[0]}};
  return {{region.from, side.joint, side.bulges[0]}, {side.joint, region.to, side.bulges[1]}};
}

/// A side moved to its left by s, or with s < 0 to its right, and lengthened at both ends.
[[nodiscard]] inline Arc_side moved(const Arc_side& side, double s) {
  Arc_side result;
  const Arc_2 &first = side.front(), &last = side.back();
  Xy<double> at = first.from + s * normal(first, 0);
  result.push_back({at - std::fabs(s) * tangent(first, 0), at, 0});
  for (std::size_t i = 0; i < side.size(); ++i) {
    const Xy<double> n = normal(side[i], 1), m = i + 1 < side.size() ? normal(side[i + 1], 0) : n;
    const Xy<double> to = side[i].to + (s / (1 + dot(n, m))) * (n + m);
    result.push_back({at, to, side[i].bulge});
    at = to;
  }
  result.push_back({at, at + std::fabs(s) * tangent(last, 1), 0});
  return result;
}

[[nodiscard]] inline double shortest_chord(const Arc_side& side) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const Arc_2& arc : side) shortest = (std::min)(shortest, euclidean_norm(arc.to - arc.from));
  return shortest;
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
