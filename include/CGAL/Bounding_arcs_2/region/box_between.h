// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A box that holds a piece of a curve which is monotone in x and y: that of its two end points, and of their errors.

#ifndef CGAL_BOUNDING_ARCS_2_REGION_BOX_BETWEEN_H
#define CGAL_BOUNDING_ARCS_2_REGION_BOX_BETWEEN_H

#include <CGAL/Bounding_arcs_2/number/Bracket.h>
#include <CGAL/Bounding_arcs_2/number/Xy.h>
#include <CGAL/Bounding_arcs_2/number/convert.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/number_utils.h>

#include <limits>
#include <type_traits>
#include <utility>

namespace CGAL::Bounding_arcs::internal {

/// Holds all numbers within `error` of those between x and y.
template <class NT> [[nodiscard]] Bracket widened_range(const NT& x, const NT& y, double error) {
  double low, high;
  if constexpr (std::is_same_v<NT, double> || std::is_same_v<NT, float>) {
    low = static_cast<double>(y < x ? y : x);
    high = static_cast<double>(y < x ? x : y);
  } else {
    const std::pair<double, double> of_x = CGAL::to_interval(x), of_y = CGAL::to_interval(y);
    low = of_y.first < of_x.first ? of_y.first : of_x.first;
    high = of_y.second < of_x.second ? of_x.second : of_y.second;
  }
  // the differences below are rounded by at most half an ulp of the larger number and the error together
  const double size = -low < high ? high : -low;
  const double margin = error + (size + error) * std::numeric_limits<double>::epsilon();
  return {low - margin, high + margin};
}

/// Holds what is monotone between two points, each within `error` of its own.
template <class NT> [[nodiscard]] CGAL::Bbox_2 box_between(const Xy<NT>& p, const Xy<NT>& q, double error) {
  const Bracket x = widened_range(p.x, q.x, error), y = widened_range(p.y, q.y, error);
  return CGAL::Bbox_2(x.lower, y.lower, x.upper, y.upper);
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
