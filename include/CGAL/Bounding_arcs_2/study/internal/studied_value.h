// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers of any type beside enclosures of the exact ones.

#ifndef CGAL_BOUNDING_ARCS_2_STUDY_INTERNAL_STUDIED_VALUE_H
#define CGAL_BOUNDING_ARCS_2_STUDY_INTERNAL_STUDIED_VALUE_H

#include <CGAL/Bounding_arcs_2/number/Double_double.h>
#include <CGAL/Bounding_arcs_2/number/Mpfr_interval.h>
#include <CGAL/Bounding_arcs_2/number/Xy.h>
#include <CGAL/Bounding_arcs_2/study/internal/figure_errors.h>

#include <cmath>
#include <limits>
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
[[nodiscard]] inline Mpfr_interval between(double low, double high) {
  return joined(long_number(low), long_number(high));
}

/// The value of a number, as the sum of doubles that are taken off it, or what its bounds enclose; nothing where it is
/// not finite.
template <class NT> [[nodiscard]] std::optional<Mpfr_interval> value_of(NT x) {
  const auto bounded = [](double low, double high) -> std::optional<Mpfr_interval> {
    if (!std::isfinite(low) || !std::isfinite(high)) return std::nullopt;
    return between(low, high);
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

[[nodiscard]] inline bool is_narrow_value(const Xy<Mpfr_interval>& v) {
  return is_narrow(v.x) && is_narrow(v.y) ? true : is_narrow(v);
}

[[nodiscard]] inline double at_most_largest(double x) { return (std::min)(x, (std::numeric_limits<double>::max)()); }

[[nodiscard]] inline Mpfr_interval length_of(const Xy<Mpfr_interval>& v) { return sqrt(dot(v, v)); }

/// No value is there, or none that is finite.
[[nodiscard]] inline Deviation lost_value(const Xy<Mpfr_interval>& exact) {
  return {at_most_largest(length_of(exact).upper()), 1};
}

/// |x - exact| at most, and that over |exact| or over the least normal double where that is larger.
template <class NT> [[nodiscard]] Deviation deviation_of_value(const Xy<NT>& x, const Xy<Mpfr_interval>& exact) {
  const auto a = value_of(x.x), b = value_of(x.y);
  if (!a || !b) return lost_value(exact);
  const Mpfr_interval difference = length_about_zero({*a - exact.x, *b - exact.y});
  const Mpfr_interval least(static_cast<double>((std::numeric_limits<double>::min)()));
  return {at_most_largest(difference.upper()), at_most_largest((difference / larger(length_of(exact), least)).upper())};
}

template <class NT> [[nodiscard]] Deviation wrong_verdict(const NT& x, const Mpfr_interval& exact) {
  const auto value = value_of(x);
  const bool is_right = value && CGAL::certainly(*value == exact);
  return is_right ? Deviation{} : Deviation{1, 1};
}

/// What a number type says of its own error.
template <class NT> [[nodiscard]] Deviation estimated_deviation(const Xy<NT>& x) {
  const double error = std::hypot(x.x.estimated_error(), x.y.estimated_error()),
               size = std::hypot(static_cast<double>(x.x), static_cast<double>(x.y));
  if (!std::isfinite(error)) return {(std::numeric_limits<double>::max)(), 1};
  return {error, at_most_largest(error / (std::max)(size, (std::numeric_limits<double>::min)()))};
}

}  // namespace CGAL::Bounding_arcs::study

#endif
