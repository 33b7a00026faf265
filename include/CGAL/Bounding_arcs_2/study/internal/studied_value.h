// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers of any type as enclosures, to be compared with exact ones.

#ifndef CGAL_BOUNDING_ARCS_2_STUDY_INTERNAL_STUDIED_VALUE_H
#define CGAL_BOUNDING_ARCS_2_STUDY_INTERNAL_STUDIED_VALUE_H

#include <CGAL/Bounding_arcs_2/number/Double_double.h>
#include <CGAL/Bounding_arcs_2/number/Mpfr_interval.h>
#include <CGAL/Bounding_arcs_2/number/Xy.h>

#include <cmath>
#include <optional>
#include <type_traits>
#include <utility>

namespace CGAL::Bounding_arcs::study {

template <class NT, class = void> inline constexpr bool has_inf_and_sup_v = false;
template <class NT>
inline constexpr bool
    has_inf_and_sup_v<NT, std::void_t<decltype(std::declval<NT>().inf()), decltype(std::declval<NT>().sup())>> = true;
template <class NT, class = void> inline constexpr bool has_bounds_v = false;
template <class NT>
inline constexpr bool
    has_bounds_v<NT, std::void_t<decltype(std::declval<NT>().lower()), decltype(std::declval<NT>().upper())>> = true;
template <class NT, class = void> inline constexpr bool estimates_errors_v = false;
template <class NT>
inline constexpr bool estimates_errors_v<NT, std::void_t<decltype(std::declval<NT>().estimated_error())>> = true;

inline constexpr mpfr_prec_t VALUE_BITS = 1024;  // holds the sum of PARTS doubles of neighbouring sizes

[[nodiscard]] inline Mpfr_interval long_number(double x) { return Mpfr_interval(CGAL::Exact_rational(x), VALUE_BITS); }

/// The value of a number, as the sum of doubles that are taken off it, or what its bounds enclose; nothing where it is
/// not finite.
template <class NT> [[nodiscard]] std::optional<Mpfr_interval> value_of(NT x) {
  const auto bounded = [](double low, double high) -> std::optional<Mpfr_interval> {
    if (!std::isfinite(low) || !std::isfinite(high)) return std::nullopt;
    return joined(long_number(low), long_number(high));
  };
  if constexpr (has_inf_and_sup_v<NT>) {
    return bounded(x.inf(), x.sup());
  } else if constexpr (has_bounds_v<NT>) {
    return bounded(x.lower(), x.upper());
  } else if constexpr (std::is_same_v<NT, Double_double>) {
    if (!std::isfinite(x.hi) || !std::isfinite(x.lo)) return std::nullopt;
    return long_number(x.hi) + long_number(x.lo);
  } else {
    constexpr int PARTS = 8;
    Mpfr_interval sum = long_number(0);
    for (int i = 0; i < PARTS; ++i) {
      const auto part = static_cast<double>(x);
      if (!std::isfinite(part)) return std::nullopt;
      sum = sum + long_number(part);
      if (estimates_errors_v<NT> || part == 0) break;
      x = NT(x - NT(part));
    }
    return sum;
  }
}
template <class NT> [[nodiscard]] std::optional<Xy<Mpfr_interval>> value_of(const Xy<NT>& p) {
  const auto x = value_of(p.x), y = value_of(p.y);
  if (!x || !y) return std::nullopt;
  return Xy<Mpfr_interval>{*x, *y};
}

/// Estimated errors of a point's coordinates; 0 of types that estimate none.
template <class NT> [[nodiscard]] Xy<double> estimated_errors(const Xy<NT>& p) {
  if constexpr (estimates_errors_v<NT>) return {p.x.estimated_error(), p.y.estimated_error()};
  else return {0, 0};
}

}  // namespace CGAL::Bounding_arcs::study

#endif
