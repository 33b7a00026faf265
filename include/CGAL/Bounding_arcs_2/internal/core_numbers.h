// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// CORE::Expr from rationals: the last resort where square roots meet a type that has none.

#ifndef CGAL_BOUNDING_ARCS_2_INTERNAL_CORE_NUMBERS_H
#define CGAL_BOUNDING_ARCS_2_INTERNAL_CORE_NUMBERS_H

#include <CGAL/Bounding_arcs_2/internal/convert.h>

#include <CGAL/CORE_Expr.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Lazy_exact_nt.h>

#include <sstream>

namespace CGAL::Bounding_arcs::internal {

/// The rational x as a CORE expression, without a rounding.
template <class Rational> [[nodiscard]] CORE::Expr to_core(const Rational& x) {
  std::ostringstream text;
  text << x;
  return CORE::Expr(CORE::BigRat(text.str()));
}
template <class ET> [[nodiscard]] CORE::Expr to_core(const CGAL::Lazy_exact_nt<ET>& x) { return to_core(x.exact()); }
[[nodiscard]] inline CORE::Expr to_core(double x) { return CORE::Expr(x); }
[[nodiscard]] inline CORE::Expr to_core(long double x) {  // no more bits than two doubles have
  const double high = static_cast<double>(x);
  return CORE::Expr(high) + CORE::Expr(static_cast<double>(x - static_cast<long double>(high)));
}

template <> struct Converter<CORE::Expr> {
  template <class Source> CORE::Expr operator()(const Source& x) const { return to_core(x); }
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
