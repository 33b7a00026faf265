// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A Bezier piece, its parameters and its points in exact numbers, and how two pieces leave a common point.

#ifndef BOUNDING_ARCS_LIBRARY_OVERLAY_EXACT_CURVE_H
#define BOUNDING_ARCS_LIBRARY_OVERLAY_EXACT_CURVE_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/number/Bracket.h>
#include <CGAL/Bounding_arcs_2/number/Mpfr_interval.h>
#include "../curve/Integer_piece.h"
#include "../polynomial/Real_root.h"
#include "../query/exact_intersections.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/number_utils.h>

#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// A parameter in [0,1] as the exact number that it is: rational, or a root of a polynomial over the integers.
/// Comparing it narrows down what is known of it.
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

/// A rational number between two others. \pre low is less than high
[[nodiscard]] inline Exact_rational number_between(const Exact_parameter& low, const Exact_parameter& high) {
  while (!(low.upper() < high.lower())) {
    low.refine();
    high.refine();
  }
  return (low.upper() + high.lower()) / Exact_rational(2);
}

/// Parameters inside at which n / w turns, in rising order.
[[nodiscard]] std::vector<Exact_parameter> turns_of(const Univariate& n, const Univariate& w);

/// A Bezier piece in exact numbers, with what is found out of it once.
class Exact_curve {
 public:
  explicit Exact_curve(Bezier_curve_2<Exact_rational> bezier);

  [[nodiscard]] const Bezier_curve_2<Exact_rational>& bezier() const { return bezier_; }
  [[nodiscard]] const Integer_piece& piece() const { return piece_; }
  /// Whether it runs along a line from one end to the other, x and y linear in the parameter.
  [[nodiscard]] bool is_segment() const { return piece_.degree() == 1 && piece_.w.degree() == 0; }
  [[nodiscard]] Exact_point point(const Exact_rational& t) const;
  /// Parameters inside at which x or y turns, in rising order, some perhaps twice.
  [[nodiscard]] const std::vector<Exact_parameter>& turns();

 private:
  Bezier_curve_2<Exact_rational> bezier_;
  Integer_piece piece_;
  std::optional<std::vector<Exact_parameter>> turns_;
};

/// Where two segments that are not parallel meet, on the line of the first one.
/// \return nothing of other curves
[[nodiscard]] std::optional<Exact_parameter> crossing_of_segments(const Exact_curve& a, const Exact_curve& b);

/// A range of rational numbers.
struct Exact_range {
  Exact_rational lower, upper;
};
/// The values of n / d over a range. \pre d is positive there, for ranges that are small enough
/// \return nothing where the range of d's values reaches 0
[[nodiscard]] std::optional<Exact_range> quotients_over(const Univariate& n, const Univariate& d, const Exact_range& t);

/// Bits that tell nearly all numbers apart which are not equal.
inline constexpr int FIRST_BITS = 96;

/// A point in exact numbers: a pair of rational ones, or a place on a curve (x/w, y/w).  At a root t of a polynomial m
/// coordinates are roots of resultants: x of res_t(m(t), x(t) - x w(t)).  Intervals of t are halved until intervals of
/// x hold one root alone.
class Exact_place {
 public:
  explicit Exact_place(const Exact_point& p) : coordinates_{Exact_parameter(p.x), Exact_parameter(p.y)} {}
  Exact_place(const Exact_curve& curve, Exact_parameter t) : curve_(&curve), t_(std::move(t)) {}

  /// The curve that it is on; none of a pair of doubles.
  [[nodiscard]] const Exact_curve* curve() const { return curve_; }
  [[nodiscard]] const Exact_parameter& t() const { return *t_; }
  /// Both coordinates, where a rational parameter or doubles tell them.
  [[nodiscard]] std::optional<Exact_point> rational_point() const;
  /// A coordinate in a range that is narrower the more bits are asked for.
  [[nodiscard]] Exact_range range(bool is_x, int bits) const;
  [[nodiscard]] const Exact_parameter& coordinate(bool is_x);
  /// -1, 0 or 1 as a coordinate is less, equal or greater.
  [[nodiscard]] int compare(Exact_place& other, bool is_x);
  [[nodiscard]] bool is_at(Exact_place& other) { return compare(other, true) == 0 && compare(other, false) == 0; }

 private:
  const Exact_curve* curve_ = nullptr;
  std::optional<Exact_parameter> t_;
  std::array<std::optional<Exact_parameter>, 2> coordinates_;  // made when they are asked for
};

/// The first way of a curve from a place on it, along which x and y are monotone.
struct Exact_way {
  Exact_curve* curve;
  const Exact_parameter* from;
  Exact_rational to;   ///< a parameter on it
  int x_sign, y_sign;  ///< 1 where the coordinate rises from the place on, -1 where it falls, 0 where it stays

  /// Counterclockwise: 0 to the right, 1 up to the right, 2 up, ... 7 down to the right.
  [[nodiscard]] int sector() const;
};
/// \param end where the curve meets others or ends; the way goes towards it
/// \pre the piece is no point between the two
[[nodiscard]] Exact_way exact_way(Exact_curve& curve, const Exact_parameter& from, const Exact_parameter& end);

/// Whether q is counterclockwise of p, both of which leave one point within one sector.
/// \pre they have no other common point
/// \guarantee exact
[[nodiscard]] bool is_counterclockwise_of(const Exact_way& q, const Exact_way& p);

}  // namespace CGAL::Bounding_arcs::internal

#endif
