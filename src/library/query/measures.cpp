// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of query/measures.h.

#include "../curve/exact_b_splines.h"

#include <CGAL/Bounding_arcs_2/query/Work_limit.h>
#include <CGAL/Bounding_arcs_2/query/closed_curves.h>
#include <CGAL/Bounding_arcs_2/query/measures.h>
#include "Area_sum.h"
#include "Length_sum.h"
#include "double_double_area.h"
#include "query_units.h"

#include <CGAL/Interval_nt.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <optional>

namespace CGAL::Bounding_arcs {

[[nodiscard]] static Measure_bounds measured(double lower, double upper, double tolerance, bool is_limited) {
  return {lower, upper, status_of(upper - lower, tolerance, is_limited)};
}

Measure_bounds length(const Bounding_arc_tree_2& curves, double eps) {
  check_tolerance(eps);
  if (curves.empty()) return {0, 0};
  if (const auto exact = internal::exact_b_splines(curves.drawing(), false))
    return length(Bounding_arc_tree_2(*exact), eps);
  const double asked = curves.unit().tolerance_in(eps);
  const internal::Length_sum sum(curves.in_unit(), asked);
  return curves.unit().bounds_out(measured(-(-sum.lower()).upper(), sum.upper().upper(), asked, sum.is_limited()));
}

[[nodiscard]] static Measure_bounds area(const Segment_hierarchy& curves, double eps) {
  if (const auto found = internal::double_double_area(curves)) return measured(found->lower, found->upper, eps, false);
  const internal::Area_sum sum(curves, false, eps);
  const Exact_rational lower = sum.exact().area + sum.least().area, upper = sum.exact().area + sum.most().area;
  return measured(CGAL::to_interval(lower).first, CGAL::to_interval(upper).second, eps, sum.is_limited());
}

Measure_bounds area(const Bounding_arc_tree_2& curves, double eps) {
  check_tolerance(eps);
  check_closed(curves.drawing());
  if (curves.empty()) return {0, 0};
  if (const auto exact = internal::exact_b_splines(curves.drawing(), true))
    return area(Bounding_arc_tree_2(*exact), eps);
  constexpr int OF_AREAS = 2;
  return curves.unit().bounds_out(area(curves.in_unit(), curves.unit().tolerance_in(eps, OF_AREAS)), OF_AREAS);
}

// \param tolerance relative to the extent
[[nodiscard]] static std::optional<Centroid_bounds> centroid(const Segment_hierarchy& curves, double tolerance) {
  const double extent = internal::Area_sum::extent_of(curves);
  const Measure_bounds rough = area(curves, 0x1p-10 * extent * extent);
  const double least = rough.lower > 0 ? rough.lower : (rough.upper < 0 ? -rough.upper : 0);
  const auto bounds = [&](double of_sum) -> std::optional<Centroid_bounds> {
    const internal::Area_sum sum(curves, true, of_sum);
    const auto range = [](const Exact_rational& low, const Exact_rational& high) {
      return CGAL::Interval_nt<true>(CGAL::to_interval(low).first, CGAL::to_interval(high).second);
    };
    const Exact_moments &m = sum.exact(), &low = sum.least(), &high = sum.most();
    const auto all = range(m.area + low.area, m.area + high.area);
    if (all.do_overlap(0)) return std::nullopt;
    const auto x = range(m.x + low.x, m.x + high.x) / all + CGAL::Interval_nt<true>(sum.origin().x),
               y = range(m.y + low.y, m.y + high.y) / all + CGAL::Interval_nt<true>(sum.origin().y);
    const double asked = tolerance * extent;
    return Centroid_bounds{measured(x.inf(), x.sup(), asked, sum.is_limited()),
                           measured(y.inf(), y.sup(), asked, sum.is_limited())};
  };
  const auto first = bounds(tolerance * least);
  if (!first) return std::nullopt;
  // where signed areas cancel, the centroid may be far outside, and what is open of the area moves it more
  const double width = (std::max)(first->x.upper - first->x.lower, first->y.upper - first->y.lower),
               asked = tolerance * extent;
  return width <= asked || asked == 0 ? first : bounds(tolerance * least * (asked / width) / 2);
}

std::optional<Centroid_bounds> centroid(const Bounding_arc_tree_2& curves, double eps) {
  check_tolerance(eps);
  check_closed(curves.drawing());
  if (curves.empty()) return std::nullopt;
  if (const auto exact = internal::exact_b_splines(curves.drawing(), true))
    return centroid(Bounding_arc_tree_2(*exact), eps);
  const auto found = centroid(curves.in_unit(), eps);
  if (!found) return std::nullopt;
  return Centroid_bounds{curves.unit().bounds_out(found->x), curves.unit().bounds_out(found->y)};
}

}  // namespace CGAL::Bounding_arcs
