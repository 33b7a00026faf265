// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points of arrangements in exact numbers.
//
// A point that is no pair of doubles is at a rational parameter t of a curve (x/w, y/w), or at a root t of a polynomial
// m.  There its coordinates are roots of resultants: x of res_t(m(t), x(t) - x w(t)).  Intervals of t are halved until
// intervals of x hold one root alone.

#ifndef BOUNDING_ARCS_LIBRARY_ARRANGEMENT_EXACT_PLACE_H
#define BOUNDING_ARCS_LIBRARY_ARRANGEMENT_EXACT_PLACE_H

#include "../overlay/Exact_curve.h"

#include <CGAL/Bounding_arcs_2/arrangement/internal/Arranged_curve.h>
#include "../query/exact_intersections.h"

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// What two curves have in common, with exact parameters of the one that comes first.
struct Exact_common {
  bool is_b_first;
  Exact_meetings found;
};
[[nodiscard]] const Exact_common& exact_common(const Arranged_pair& pair);

/// A range of rational numbers.
struct Exact_range {
  Exact_rational lower, upper;
};
/// The values of n / d over a range. \pre d is positive there, for ranges that are small enough
/// \return nothing where the range of d's values reaches 0
[[nodiscard]] std::optional<Exact_range> quotients_over(const Univariate& n, const Univariate& d, const Exact_range& t);

/// Bits that tell nearly all numbers apart which are not equal.
inline constexpr int FIRST_BITS = 96;

/// A point in exact numbers.
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

 private:
  const Exact_curve* curve_ = nullptr;
  std::optional<Exact_parameter> t_;
  std::array<std::optional<Exact_parameter>, 2> coordinates_;  // made when they are asked for
};
[[nodiscard]] Exact_place& exact_place(const Arranged_point& p);

/// The branches of a curve that end and start at a parameter: neighbours where it turns, else one.
struct Branches {
  std::size_t before, behind;
};
[[nodiscard]] Branches branches_at(const Arranged_curve& c, const Exact_parameter& t);

/// Notes all places of a point on a curve, or those in a range.
void add_places(const Arranged_point& p, const Arranged_curve& c, const Bracket& range);

}  // namespace CGAL::Bounding_arcs::internal

#endif
