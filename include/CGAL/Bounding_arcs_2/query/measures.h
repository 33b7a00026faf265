// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How long curves are, and the area inside closed ones with its centroid, between bounds.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_MEASURES_H
#define CGAL_BOUNDING_ARCS_2_QUERY_MEASURES_H

#include <CGAL/Bounding_arcs_2/internal/query/Area_sum.h>
#include <CGAL/Bounding_arcs_2/internal/query/Length_sum.h>
#include <CGAL/Bounding_arcs_2/internal/query/double_double_area.h>
#include <CGAL/Bounding_arcs_2/query/Curve_index_2.h>
#include <CGAL/Bounding_arcs_2/query/closed_curves.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

/// A number of the exact curves is between these.
struct Measure_bounds {
  double lower, upper;
};
/// A box that holds the centroid.
struct Centroid_bounds {
  Measure_bounds x, y;
};

/// \throws std::invalid_argument for less than 0 and for no number
inline void check_tolerance(double tolerance) {
  if (!(tolerance >= 0)) throw std::invalid_argument("a tolerance is a number that is not less than 0");
}

/// The length of all curves together.
/// \param tolerance how far the bounds may be apart; they are farther where doubles tell no more
/// \guarantee certified
/// \complexity n, some microseconds a Bezier piece; next to cusps pieces as the logarithm of 1 / tolerance
[[nodiscard]] inline Measure_bounds length(const Curve_index_2& index, double tolerance) {
  check_tolerance(tolerance);
  if (index.empty()) return {0, 0};
  const internal::Length_sum sum(index, tolerance);
  return {-(-sum.lower()).upper(), sum.upper().upper()};
}

/// The area that closed curves run round, each part as often as they do: counterclockwise more than 0, holes that are
/// clockwise taken off.
/// \param tolerance how far the bounds may be apart; they are farther where doubles tell no more of rational curves
/// \guarantee certified; for polynomial curves the nearest doubles
/// \complexity n for polynomial curves; for rational ones pieces as the third root of 1 / tolerance, times its
///   logarithm
/// \throws std::invalid_argument if a curve is open, with its name
[[nodiscard]] inline Measure_bounds area(const Curve_index_2& index, double tolerance) {
  check_tolerance(tolerance);
  check_closed(index.drawing());
  if (index.empty()) return {0, 0};
  if (const auto found = internal::double_double_area(index)) return {found->lower, found->upper};
  const internal::Area_sum sum(index, false, tolerance);
  const Exact_rational lower = sum.exact().area + sum.least().area, upper = sum.exact().area + sum.most().area;
  return {CGAL::to_interval(lower).first, CGAL::to_interval(upper).second};
}

/// The centroid of that area.
/// \param tolerance as for area(), of each coordinate, relative to the extent of the drawing
/// \return nothing where the area may be 0
/// \guarantee certified
/// \complexity as for area()
/// \throws std::invalid_argument if a curve is open, with its name
[[nodiscard]] inline std::optional<Centroid_bounds> centroid(const Curve_index_2& index, double tolerance) {
  check_tolerance(tolerance);
  check_closed(index.drawing());
  if (index.empty()) return std::nullopt;
  const double extent = internal::Area_sum::extent_of(index);
  const Measure_bounds rough = area(index, 0x1p-10 * extent * extent);
  const double least = rough.lower > 0 ? rough.lower : (rough.upper < 0 ? -rough.upper : 0);
  const auto bounds = [&](double of_sum) -> std::optional<Centroid_bounds> {
    const internal::Area_sum sum(index, true, of_sum);
    const auto range = [](const Exact_rational& low, const Exact_rational& high) {
      return CGAL::Interval_nt<true>(CGAL::to_interval(low).first, CGAL::to_interval(high).second);
    };
    const internal::Exact_moments &m = sum.exact(), &low = sum.least(), &high = sum.most();
    const auto all = range(m.area + low.area, m.area + high.area);
    if (all.do_overlap(0)) return std::nullopt;
    const auto x = range(m.x + low.x, m.x + high.x) / all + CGAL::Interval_nt<true>(sum.origin().x),
               y = range(m.y + low.y, m.y + high.y) / all + CGAL::Interval_nt<true>(sum.origin().y);
    return Centroid_bounds{{x.inf(), x.sup()}, {y.inf(), y.sup()}};
  };
  const auto first = bounds(tolerance * least);
  if (!first) return std::nullopt;
  // where signed areas cancel, the centroid may be far outside, and what is open of the area moves it more
  const double width = (std::max)(first->x.upper - first->x.lower, first->y.upper - first->y.lower),
               asked = tolerance * extent;
  return width <= asked || asked == 0 ? first : bounds(tolerance * least * (asked / width) / 2);
}

}  // namespace CGAL::Bounding_arcs

#endif
