// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of query/closest_points.h, which the library has compiled.

#ifndef CGAL_BOUNDING_ARCS_2_INTERNAL_QUERY_CLOSEST_POINTS_IMPL_H
#define CGAL_BOUNDING_ARCS_2_INTERNAL_QUERY_CLOSEST_POINTS_IMPL_H

#include <CGAL/Bounding_arcs_2/internal/inline.h>
#include <CGAL/Bounding_arcs_2/internal/query/Common_unit.h>
#include <CGAL/Bounding_arcs_2/internal/query/Feet_search.h>
#include <CGAL/Bounding_arcs_2/internal/query/Nearest_curves_search.h>
#include <CGAL/Bounding_arcs_2/query/closest_points.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace CGAL::Bounding_arcs {

CGAL_BOUNDING_ARCS_INLINE std::vector<Closest_point> closest_points(const Curve_index_2& index, const Xy<double>& q,
                                                                    double tolerance) {
  if (!(tolerance > 0) || !std::isfinite(tolerance))
    throw std::invalid_argument("the tolerance of a distance is a positive number");
  const Curve_index_2& in_unit = index.in_unit();
  const Xy<double> p = internal::point_in(index.unit(), q);
  const auto nearest = closest_point(in_unit, p);
  if (!nearest) return {};
  const double most = nearest->distance.upper + index.unit().tolerance_in(tolerance);
  auto found = internal::Feet_search(in_unit, p, most).result();
  for (Closest_point& f : found) f = internal::out(index.unit(), f);
  return found;
}

CGAL_BOUNDING_ARCS_INLINE std::vector<Closest_point> k_nearest_curves(const Curve_index_2& index, const Xy<double>& q,
                                                                      std::size_t k) {
  const Xy<double> p = internal::point_in(index.unit(), q);
  if (k == 0) return {};
  internal::Nearest_curves_search search(index.in_unit(), p, k);
  auto found = search.result();
  for (Closest_point& f : found) f = internal::out(index.unit(), f);
  return found;
}

}  // namespace CGAL::Bounding_arcs

#endif
