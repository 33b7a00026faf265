// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Conversions between number types: exact where the target can hold the value, else to the nearest or enclosing one.

#ifndef CGAL_BOUNDING_ARCS_2_NUMBER_CONVERT_H
#define CGAL_BOUNDING_ARCS_2_NUMBER_CONVERT_H

#include <CGAL/Bounding_arcs_2/number/Bounded_double.h>
#include <CGAL/Bounding_arcs_2/number/Xy.h>

#include <CGAL/Fraction_traits.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Lazy_exact_nt.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <limits>
#include <sstream>
#include <type_traits>
#include <utility>

namespace CGAL::Bounding_arcs {

template <class T> inline constexpr bool is_interval_v = false;
template <bool Protected> inline constexpr bool is_interval_v<CGAL::Interval_nt<Protected>> = true;

namespace internal {
/// Makes a Target from numbers that it has no constructor for; specialised beside the types concerned.  Rationals of
/// different libraries have none for each other, but read what the other one writes.
template <class Target> struct Converter {
  template <class Source> Target operator()(const Source& x) const {
    if constexpr (std::is_constructible_v<Target, const Source&>) {
      return Target(x);
    } else {
      static_assert(
          CGAL::Fraction_traits<Source>::Is_fraction::value && CGAL::Fraction_traits<Target>::Is_fraction::value,
          "no conversion keeps these numbers: use a kernel over the number type of the spirals");
      std::stringstream text;
      Target result;
      text << x;
      text >> result;
      return result;
    }
  }
  template <class ET> Target operator()(const CGAL::Lazy_exact_nt<ET>& x) const {
    if constexpr (std::is_same_v<Target, ET>) return x.exact();
    else return (*this)(x.exact());
  }
};
/// Converts to lazy numbers.
template <class ET> struct Converter<CGAL::Lazy_exact_nt<ET>> {
  template <class Source> CGAL::Lazy_exact_nt<ET> operator()(const Source& x) const {
    if constexpr (std::is_same_v<Source, ET>) return x;
    else return Converter<ET>()(x);
  }
};
}  // namespace internal

/// x as the nearest double and the distance to it, which long double holds exactly.
[[nodiscard]] inline Bounded_double bounded(long double x) {
  const double nearest = static_cast<double>(x);
  const double distance = static_cast<double>(std::fabs(x - nearest));
  return x == nearest ? Bounded_double(nearest)
                      : Bounded_double(nearest, std::nextafter(distance, std::numeric_limits<double>::infinity()));
}

/// The target's number for x: x itself, or for floating targets the nearest by CGAL::to_double, or an enclosure.
template <class Target, class Source> [[nodiscard]] Target convert(const Source& x) {
  if constexpr (std::is_same_v<Target, Source>) {
    return x;
  } else if constexpr (std::is_same_v<Source, long double> && std::is_same_v<Target, Bounded_double>) {
    return bounded(x);
  } else if constexpr (std::is_floating_point_v<Source> &&
                       (std::is_floating_point_v<Target> || !std::is_same_v<Source, long double>)) {
    return Target(x);
  } else if constexpr (std::is_floating_point_v<Target>) {
    return static_cast<Target>(CGAL::to_double(x));
  } else if constexpr (std::is_same_v<Target, Bounded_double>) {
    const std::pair<double, double> range = CGAL::to_interval(x);
    return Bounded_double(range.first + (range.second - range.first) / 2, range.second - range.first);
  } else if constexpr (is_interval_v<Target>) {
    return Target(CGAL::to_interval(x));
  } else {
    return internal::Converter<Target>()(x);
  }
}

template <class Target, class Source> [[nodiscard]] Xy<Target> convert(const Xy<Source>& p) {
  return {convert<Target>(p.x), convert<Target>(p.y)};
}

}  // namespace CGAL::Bounding_arcs

#endif
