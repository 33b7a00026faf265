// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The exact number type behind a number type, and the conversion to it without error.

#ifndef CGAL_BOUNDING_ARCS_2_NUMBER_EXACT_NUMBER_H
#define CGAL_BOUNDING_ARCS_2_NUMBER_EXACT_NUMBER_H

#include <CGAL/Bounding_arcs_2/number/strict_math.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Lazy_exact_nt.h>

#include <cmath>
#include <type_traits>

namespace CGAL::Bounding_arcs {

/// The exact number type that stands for NT; `make` converts without error.
/// By default NT itself, for rationals and for types such as CORE::Expr that no rational can stand for. `Type` needs
/// exact field operations and signs, construction from double and int, and to_interval.
template <class NT, class = void> struct Exact_number {
  using Type = NT;
  static const Type& make(const NT& x) { return x; }
};

/// Floating numbers as the sum of two doubles times a power of two, at most 106 significant bits.
template <class NT> struct Exact_number<NT, std::enable_if_t<std::is_floating_point_v<NT>>> {
  using Type = Exact_rational;
  static Type make(const NT& x) {
    int exponent = 0;
    const NT mantissa = std::frexp(x, &exponent);
    const double hi = static_cast<double>(mantissa), lo = static_cast<double>(mantissa - NT(hi));
    Type r = Type(hi) + Type(lo);
    constexpr int STEP = 1000;
    for (; exponent > STEP; exponent -= STEP) r *= Type(std::ldexp(1.0, STEP));
    for (; exponent < -STEP; exponent += STEP) r *= Type(std::ldexp(1.0, -STEP));
    return Type(r * Type(std::ldexp(1.0, exponent)));
  }
};

/// A lazy number as the exact one that it stands for.
template <class ET> struct Exact_number<Lazy_exact_nt<ET>> {
  using Type = ET;
  static Type make(const Lazy_exact_nt<ET>& x) { return x.exact(); }
};

}  // namespace CGAL::Bounding_arcs

#endif
