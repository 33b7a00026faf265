// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The common zeros in [0,1]^2 of two polynomials in two variables without a common factor.

#ifndef BOUNDING_ARCS_LIBRARY_QUERY_COMMON_ZEROS_H
#define BOUNDING_ARCS_LIBRARY_QUERY_COMMON_ZEROS_H

#include <CGAL/Bounding_arcs_2/query/Piece_intersections.h>
#include "../polynomial/Elimination.h"
#include "../polynomial/Real_root.h"
#include "Fibre.h"
#include "Fibre_root.h"
#include "exact_meetings.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// n(t) / d(t) in doubles at a root where it is within (0,1).
[[nodiscard]] inline Bracket range_of_fraction(Real_root& t, const Univariate& n, const Univariate& d) {
  constexpr int STEP = 16;
  constexpr mpfr_prec_t BITS = 64;
  for (;; t.refine(STEP)) {
    if (t.is_dyadic()) return range_of(Mpfr_interval(t.exact_value(n) / t.exact_value(d), BITS));
    const Bracket r = range_of(t.value(n) / t.value(d));
    if (is_narrow(r)) return r;
  }
}

/// Finds the zeros by elimination of s, and by calculation over the roots t where several s share one.
class Common_zeros {
 public:
  /// \param e what elimination made of f and g
  /// \param excluded zeros on this curve are left out
  /// \param which those with s > t or s < t alone; then those with s = t must be excluded
  Common_zeros(const Bivariate& f, const Bivariate& g, Elimination e, const Bivariate& excluded, Parameter_order which)
      : f_(f), g_(g), e_(std::move(e)), excluded_(excluded), which_(which) {
    const Root_multiplicities m = unit_root_multiplicities(e_.resultant);
    solve(m.simple, Intersection_kind::TRANSVERSAL);
    solve(m.multiple, Intersection_kind::TANGENTIAL);
  }
  [[nodiscard]] std::vector<Exact_meeting>& points() { return points_; }

 private:
  // Over a root t with one common root s the multiplicity of t is that of the zero, which is 1 exactly where the
  // gradients of f and g are independent, and that is where the tangents cross.
  void solve(const Univariate& m, Intersection_kind kind) {
    if (m.degree() < 1) return;
    const Univariate several = common_divisor(m, e_.denominator);
    solve_fibres(square_free(several));
    Univariate single = CGAL::integral_division(m, several);
    (void)split_off(single, at_fraction(excluded_, e_.numerator, e_.denominator));
    add_ends(split_off(single, e_.numerator), 0, kind);
    add_ends(split_off(single, e_.numerator - e_.denominator), 1, kind);
    for (Real_root& t : Unit_isolation(single).roots()) add_inner(t, kind);
  }
  static Univariate split_off(Univariate& m, const Univariate& q) {
    const Univariate common = common_divisor(m, q);
    m = CGAL::integral_division(m, common);
    return common;
  }
  void add_ends(const Univariate& m, double s, Intersection_kind kind) {
    if ((which_ == Parameter_order::RISING && s == 0) || (which_ == Parameter_order::FALLING && s == 1)) return;
    for (const Real_root& t : Unit_isolation(m).roots()) points_.push_back({t, {s, s}, kind});
  }
  // Neither end of [0,1], nor t itself where that matters.
  void add_inner(Real_root& t, Intersection_kind kind) {
    const int sign = t.sign_of(e_.denominator, true);
    const auto is_positive = [&](const Univariate& p) { return t.sign_of(p, true) == sign; };
    if (!is_positive(e_.numerator) || !is_positive(e_.denominator - e_.numerator)) return;
    if (which_ != Parameter_order::ANY &&
        is_positive(e_.numerator - polynomial<Integer>({Integer(0), Integer(1)}) * e_.denominator) !=
            (which_ == Parameter_order::RISING))
      return;
    const Bracket s = range_of_fraction(t, e_.numerator, e_.denominator);
    points_.push_back({t, s, kind});
  }

  void solve_fibres(const Univariate& m) {
    if (m.degree() < 1) return;
    std::vector<Fibre> fibres = divided_by_curve(common_fibres(m, f_, g_), excluded_).off;
    const Bivariate jacobian =
        derivative_by_t(f_) * CGAL::differentiate(g_) - CGAL::differentiate(f_) * derivative_by_t(g_);
    const Fibre_parts parts = divided_by_curve(fibres, jacobian);
    add_fibres(parts.off, Intersection_kind::TRANSVERSAL);
    add_fibres(parts.on, Intersection_kind::TANGENTIAL);
  }
  void add_fibres(const std::vector<Fibre>& fibres, Intersection_kind kind) {
    for (const Fibre& fibre : fibres)
      for (Real_root t : Unit_isolation(fibre.m).roots())
        for (Fibre_root& s : Fibre_isolation(t, fibre.h).roots())
          if (which_ == Parameter_order::ANY || s.is_greater(t) == (which_ == Parameter_order::RISING))
            points_.push_back({t, s.range(), kind});
  }

  const Bivariate &f_, &g_;
  Elimination e_;
  const Bivariate& excluded_;
  Parameter_order which_;
  std::vector<Exact_meeting> points_;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
