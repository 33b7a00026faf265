// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of query/measures.h, which the library has compiled.

#ifndef CGAL_BOUNDING_ARCS_2_INTERNAL_QUERY_MEASURES_IMPL_H
#define CGAL_BOUNDING_ARCS_2_INTERNAL_QUERY_MEASURES_IMPL_H

#include <CGAL/Bounding_arcs_2/internal/inline.h>
#include <CGAL/Bounding_arcs_2/internal/query/Area_sum.h>
#include <CGAL/Bounding_arcs_2/internal/query/Length_sum.h>
#include <CGAL/Bounding_arcs_2/internal/query/Work_limit.h>
#include <CGAL/Bounding_arcs_2/internal/query/double_double_area.h>
#include <CGAL/Bounding_arcs_2/internal/query/exact_b_splines.h>
#include <CGAL/Bounding_arcs_2/query/measures.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <optional>

namespace CGAL::Bounding_arcs {

namespace internal {

[[nodiscard]] inline Measure_bounds measured(double lower, double upper, double tolerance, bool is_limited) {
  return {lower, upper, status_of(upper - lower, tolerance, is_limited)};
}

}  // namespace internal

CGAL_BOUNDING_ARCS_INLINE Measure_bounds length(const Curve_index_2& index, double tolerance) {
  check_tolerance(tolerance);
  if (index.empty()) return {0, 0};
  if (const auto exact = internal::exact_b_splines(index.drawing(), false))
    return length(Curve_index_2(*exact), tolerance);
  const internal::Unit& unit = index.unit();
  const double asked = unit.tolerance_in(tolerance);
  const internal::Length_sum sum(index.in_unit(), asked);
  return unit.bounds_out(internal::measured(-(-sum.lower()).upper(), sum.upper().upper(), asked, sum.is_limited()));
}

CGAL_BOUNDING_ARCS_INLINE Measure_bounds area(const Curve_index_2& index, double tolerance) {
  check_tolerance(tolerance);
  check_closed(index.drawing());
  if (index.empty()) return {0, 0};
  if (const auto exact = internal::exact_b_splines(index.drawing(), true))
    return area(Curve_index_2(*exact), tolerance);
  constexpr int OF_AREAS = 2;
  const Curve_index_2& in_unit = index.in_unit();
  const double asked = index.unit().tolerance_in(tolerance, OF_AREAS);
  const auto bounds = [&](double lower, double upper, bool is_limited) {
    return index.unit().bounds_out(internal::measured(lower, upper, asked, is_limited), OF_AREAS);
  };
  if (const auto found = internal::double_double_area(in_unit)) return bounds(found->lower, found->upper, false);
  const internal::Area_sum sum(in_unit, false, asked);
  const Exact_rational lower = sum.exact().area + sum.least().area, upper = sum.exact().area + sum.most().area;
  return bounds(CGAL::to_interval(lower).first, CGAL::to_interval(upper).second, sum.is_limited());
}

CGAL_BOUNDING_ARCS_INLINE std::optional<Centroid_bounds> centroid(const Curve_index_2& index, double tolerance) {
  check_tolerance(tolerance);
  check_closed(index.drawing());
  if (index.empty()) return std::nullopt;
  if (const auto exact = internal::exact_b_splines(index.drawing(), true))
    return centroid(Curve_index_2(*exact), tolerance);
  if (&index.in_unit() != &index) {
    const auto found = centroid(index.in_unit(), tolerance);
    if (!found) return std::nullopt;
    return Centroid_bounds{index.unit().bounds_out(found->x), index.unit().bounds_out(found->y)};
  }
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
    const double asked = tolerance * extent;
    return Centroid_bounds{internal::measured(x.inf(), x.sup(), asked, sum.is_limited()),
                           internal::measured(y.inf(), y.sup(), asked, sum.is_limited())};
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
