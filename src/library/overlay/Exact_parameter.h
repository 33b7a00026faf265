// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A parameter as the exact number that it is: rational, or a root of a polynomial over the integers.

#ifndef BOUNDING_ARCS_LIBRARY_OVERLAY_EXACT_PARAMETER_H
#define BOUNDING_ARCS_LIBRARY_OVERLAY_EXACT_PARAMETER_H

#include <CGAL/Bounding_arcs_2/number/Bracket.h>
#include <CGAL/Bounding_arcs_2/number/Mpfr_interval.h>
#include "../curve/Integer_piece.h"
#include "../polynomial/Real_root.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/number_utils.h>

#include <optional>
#include <utility>

namespace CGAL::Bounding_arcs::internal {

/// A parameter in [0,1]. Comparing it narrows down what is known of it.
class Exact_parameter {
 public:
  explicit Exact_parameter(Exact_rational t) : number_(std::move(t)) {}
  explicit Exact_parameter(const Real_root& t) {
    if (const Univariate p = t.polynomial(); p.degree() == 1)
      number_ = Exact_rational(Integer(-p[0])) / Exact_rational(p[1]);
    else root_ = t;
  }

  /// Rational bounds: the number itself, or the ends of an open interval around it.
  [[nodiscard]] Exact_rational lower() const { return root_ ? root_->lower() : number_; }
  [[nodiscard]] Exact_rational upper() const { return root_ ? root_->upper() : number_; }
  void refine() const {
    constexpr int STEP = 8;
    if (root_) root_->refine(STEP);
  }
  /// Refines until the bounds are no farther apart than 2^-bits.
  void refine_to(int bits) const {
    if (root_) root_->refine_to(bits);
  }
  /// The doubles next to it on both sides, or the one that it is.
  [[nodiscard]] Bracket range() const {
    constexpr mpfr_prec_t BITS = 64;
    return root_ ? root_->range() : range_of(Mpfr_interval(number_, BITS));
  }
  /// A polynomial of which it is a root, and the only one between its bounds.
  [[nodiscard]] Univariate polynomial() const {
    if (root_) return root_->polynomial();
    const auto [n, d] = decomposed(number_);
    return Bounding_arcs::polynomial<Integer>({Integer(-n), d});
  }

  /// -1, 0 or 1 as it is less, equal or greater.
  [[nodiscard]] int compare(const Exact_rational& t) const {
    return root_ ? root_->compare(t) : static_cast<int>(CGAL::compare(number_, t));
  }
  [[nodiscard]] int compare(const Exact_parameter& other) const {
    if (this == &other) return 0;
    if (!root_) return -other.compare(number_);
    return other.root_ ? root_->compare(*other.root_) : root_->compare(other.number_);
  }
  [[nodiscard]] bool is_in(const Bracket& range) const {
    return compare(Exact_rational(range.lower)) >= 0 && compare(Exact_rational(range.upper)) <= 0;
  }

 private:
  Exact_rational number_{0};
  mutable std::optional<Real_root> root_;
};

/// A range of rational numbers.
struct Exact_range {
  Exact_rational lower, upper;
};
/// The values of p over a range. \pre the range is in [0, infinity)
[[nodiscard]] inline Exact_range values_over(const Univariate& p, const Exact_range& t) {
  Exact_range value{Exact_rational(0), Exact_rational(0)};
  for (int i = p.degree(); i >= 0; --i) {
    const Exact_rational c(coefficient(p, i));
    value = {Exact_rational(value.lower * (CGAL::is_negative(value.lower) ? t.upper : t.lower) + c),
             Exact_rational(value.upper * (CGAL::is_negative(value.upper) ? t.lower : t.upper) + c)};
  }
  return value;
}

/// A rational number between two others. \pre low is less than high
[[nodiscard]] inline Exact_rational number_between(const Exact_parameter& low, const Exact_parameter& high) {
  while (!(low.upper() < high.lower())) {
    low.refine();
    high.refine();
  }
  return (low.upper() + high.lower()) / Exact_rational(2);
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
