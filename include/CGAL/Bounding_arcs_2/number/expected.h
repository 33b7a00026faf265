// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What errors say: the argument or the place, what was expected of it, and what was found. Numbers have the fewest
// digits that read back as the same double.

#ifndef CGAL_BOUNDING_ARCS_2_NUMBER_EXPECTED_H
#define CGAL_BOUNDING_ARCS_2_NUMBER_EXPECTED_H

#include <CGAL/Bounding_arcs_2/number/Xy.h>

#include <charconv>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace CGAL::Bounding_arcs {

/// Returns a number's digits; of numbers that are neither floating nor whole the words.
template <class NT> [[nodiscard]] std::string text_of(const NT& x, const std::string& words) {
  if constexpr (std::is_arithmetic_v<NT>) {
    if constexpr (std::is_floating_point_v<NT>)
      if (std::isnan(x)) return "nan";  // without the sign that it may have
    constexpr std::size_t ROOM = 64;
    char digits[ROOM];
    return {digits, std::to_chars(digits, digits + ROOM, x).ptr};
  } else {
    return words;
  }
}
[[nodiscard]] inline std::string text_of(const std::string& found) { return found; }
template <class Number> [[nodiscard]] std::enable_if_t<std::is_arithmetic_v<Number>, std::string> text_of(Number x) {
  return text_of(x, {});
}
[[nodiscard]] inline std::string text_of(const Xy<double>& p) { return "(" + text_of(p.x) + ", " + text_of(p.y) + ")"; }

/// Returns what an error says: "eps: expected a number above 0, found nan".
/// \param argument its name, or that of a place
/// \param found a number, a point, or words
template <class Found>
[[nodiscard]] std::string expected(const std::string& argument, const std::string& what, const Found& found) {
  return argument + ": expected " + what + ", found " + text_of(found);
}

/// \throws std::invalid_argument unless the number is above 0
inline void check_above_zero(const std::string& argument, double x) {
  if (!(x > 0)) throw std::invalid_argument(expected(argument, "a number above 0", x));
}

}  // namespace CGAL::Bounding_arcs

#endif
