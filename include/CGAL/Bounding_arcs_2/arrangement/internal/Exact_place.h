// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points of arrangements as algebraic numbers.
//
// A point that is no pair of doubles is at a root t of a polynomial m on a curve (x/w, y/w).  Its coordinates are roots
// of resultants: x of res_t(m(t), x(t) - x w(t)).  Intervals of t are halved until intervals of x hold one root alone.

#ifndef CGAL_BOUNDING_ARCS_2_ARRANGEMENT_INTERNAL_EXACT_PLACE_H
#define CGAL_BOUNDING_ARCS_2_ARRANGEMENT_INTERNAL_EXACT_PLACE_H

#include <CGAL/Bounding_arcs_2/arrangement/internal/Arranged_curve.h>
#include <CGAL/Bounding_arcs_2/curve/Integer_piece.h>
#include <CGAL/Bounding_arcs_2/polynomial/Real_root.h>

#include <cstdint>
#include <memory>
#include <optional>

namespace CGAL::Bounding_arcs::internal {

/// A range of rational numbers.
struct Exact_range {
  Exact_rational lower, upper;
};
/// The values of p over a range. \pre the range is in [0, infinity)
[[nodiscard]] Exact_range values_over(const Univariate& p, const Exact_range& t);
/// The values of n / d over a range. \pre d is positive there, for ranges that are small enough
/// \return nothing where the range of d's values reaches 0
[[nodiscard]] std::optional<Exact_range> quotients_over(const Univariate& n, const Univariate& d, const Exact_range& t);

/// The double itself.
[[nodiscard]] Real_root real_root_of(double value);

/// Zero where x of a curve turns, or y of an upright one; of odd multiplicity there, and once.
[[nodiscard]] Univariate turn_polynomial(const Integer_piece& piece, bool is_vertical);

/// A place on a curve.
struct Exact_place {
  std::shared_ptr<const Integer_piece> piece;
  Real_root t;
  std::optional<Real_root> x, y, s;  ///< s on the other curve; all are made when they are asked for
};
/// \pre p is no pair of doubles
[[nodiscard]] Exact_place& exact_place(const Arranged_point& p);
[[nodiscard]] Real_root& exact_coordinate(const Arranged_point& p, bool is_x);

/// The parameter of p at one of its places, where that is one of those that define p.
/// \pre p is no pair of doubles
[[nodiscard]] Real_root* exact_parameter(const Arranged_point& p, const Arranged_place& place);

/// A coordinate in a range that is narrower the more bits are asked for.
[[nodiscard]] Exact_range coordinate_range(const Arranged_point& p, bool is_x, int bits);

}  // namespace CGAL::Bounding_arcs::internal

#endif
