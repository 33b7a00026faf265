// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Kinds of local curves: the code of batches is compiled for some degrees, and a curve of another one is taken for one
// of the next higher, with leading coefficients of 0.

#ifndef CGAL_BOUNDING_ARCS_2_SPIRAL_CURVE_KIND_H
#define CGAL_BOUNDING_ARCS_2_SPIRAL_CURVE_KIND_H

#include <CGAL/Bounding_arcs_2/number/strict_math.h>

#include <type_traits>

namespace CGAL::Bounding_arcs {

/// Largest degree of curves that have a local curve.
inline constexpr int MAX_LOCAL_DEGREE = 9, MAX_RATIONAL_DEGREE = 5;
/// What the kinds of rational curves have more than those of polynomials, which are degrees. 0 is no kind.
inline constexpr int RATIONAL = 16;

[[nodiscard]] constexpr int degree_of_kind(int kind) { return kind % RATIONAL; }
[[nodiscard]] constexpr bool is_rational_kind(int kind) { return kind >= RATIONAL; }

/// The kind of a curve's local curve, 0 where there is none.
[[nodiscard]] constexpr int curve_kind(int degree, bool is_rational) {
  if (degree > (is_rational ? MAX_RATIONAL_DEGREE : MAX_LOCAL_DEGREE)) return 0;
  if (is_rational) return RATIONAL + (degree <= 2 ? 2 : degree == 3 ? 3 : 5);
  if (degree <= 3) return 3;
  return degree <= 5 ? degree : degree <= 7 ? 7 : 9;
}

template <int KIND> using Kind_constant = std::integral_constant<int, KIND>;

/// Calls f(Kind_constant<kind>()), for a kind that there is.
/// \return what f does, or without a kind a value of this type
template <class Call> [[nodiscard]] auto for_kind(int kind, const Call& f) -> decltype(f(Kind_constant<3>())) {
  switch (kind) {
    case 3:
      return f(Kind_constant<3>());
    case 4:
      return f(Kind_constant<4>());
    case 5:
      return f(Kind_constant<5>());
    case 7:
      return f(Kind_constant<7>());
    case 9:
      return f(Kind_constant<9>());
    case RATIONAL + 2:
      return f(Kind_constant<RATIONAL + 2>());
    case RATIONAL + 3:
      return f(Kind_constant<RATIONAL + 3>());
    case RATIONAL + 5:
      return f(Kind_constant<RATIONAL + 5>());
    default:
      return decltype(f(Kind_constant<3>()))();
  }
}

}  // namespace CGAL::Bounding_arcs

#endif
