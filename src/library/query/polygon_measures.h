// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Width and diameter of a convex polygon with rotating calipers.

#ifndef BOUNDING_ARCS_LIBRARY_QUERY_POLYGON_MEASURES_H
#define BOUNDING_ARCS_LIBRARY_QUERY_POLYGON_MEASURES_H

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>
#include <CGAL/assertions.h>
#include "Hull_samples.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace CGAL::Bounding_arcs::internal {

/// Calls f(i, j) for each edge i, i + 1 with the corner j farthest from it, and for those that j passes on the way: all
/// pairs of corners with parallel lines that the polygon is between are among them.
/// Distances from a line rise and fall along a convex polygon, so j goes round once; where rounding lets it stop an ulp
/// too early, that corner is as far but for rounding.
/// \pre at least three corners
template <class F> void for_each_antipode(const Convex_polygon& p, const F& f) {
  CGAL_precondition(p.size() >= 3);
  const std::size_t n = p.size();
  std::size_t j = 1;
  for (std::size_t i = 0; i < n; ++i) {
    const Xy<double> edge = p[(i + 1) % n] - p[i];
    f(i, j);
    const auto is_farther = [&](std::size_t k) { return cross(edge, p[(k + 1) % n] - p[k]) > 0; };
    for (std::size_t step = 0; step < n && (j == i || is_farther(j)); ++step) {
      j = (j + 1) % n;
      f(i, j);
    }
  }
}

/// Two corners that are farthest from each other.
struct Corner_pair {
  Xy<double> first, second;
  double distance = 0;
};
[[nodiscard]] inline Corner_pair diameter_of(const Convex_polygon& p) {
  Corner_pair best{p.front(), p.front(), 0};
  const auto offer = [&](const Xy<double>& a, const Xy<double>& b) {
    const double d = euclidean_norm(b - a);
    if (d > best.distance) best = {a, b, d};
  };
  if (p.size() == 2) offer(p[0], p[1]);
  if (p.size() < 3) return best;
  for_each_antipode(p, [&](std::size_t i, std::size_t j) {
    offer(p[i], p[j]);
    offer(p[(i + 1) % p.size()], p[j]);
  });
  return best;
}

/// The least distance of two parallel lines with the polygon between them.
struct Polygon_width {
  double width = 0;
  Xy<double> along;  ///< the direction of the lines
};
[[nodiscard]] inline Polygon_width width_of(const Convex_polygon& p) {
  if (p.size() < 3) return {0, p.size() == 2 ? p[1] - p[0] : Xy<double>{1, 0}};
  Polygon_width best{std::numeric_limits<double>::infinity(), {}};
  double farthest = 0;
  std::size_t last = p.size();
  Xy<double> edge;
  const auto finish = [&] {
    if (last < p.size() && farthest < best.width) best = {farthest, edge};
  };
  for_each_antipode(p, [&](std::size_t i, std::size_t j) {
    if (i != last) {
      finish();
      last = i;
      farthest = 0;
      edge = p[(i + 1) % p.size()] - p[i];
    }
    farthest = (std::max)(farthest, cross(edge, p[j] - p[i]) / euclidean_norm(edge));
  });
  finish();
  return best;
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
