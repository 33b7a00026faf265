// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Common points of two pieces with the first one's parameters as exact numbers: what exact_intersections rounds.

#ifndef BOUNDING_ARCS_LIBRARY_QUERY_EXACT_MEETINGS_H
#define BOUNDING_ARCS_LIBRARY_QUERY_EXACT_MEETINGS_H

#include <CGAL/Bounding_arcs_2/number/Bracket.h>
#include <CGAL/Bounding_arcs_2/number/Exact_number.h>
#include <CGAL/Bounding_arcs_2/number/Xy.h>
#include <CGAL/Bounding_arcs_2/query/Intersections_2.h>
#include "../curve/Integer_piece.h"
#include "../polynomial/Real_root.h"

#include <vector>

namespace CGAL::Bounding_arcs {

/// A common point: the exact parameter of the first piece, and doubles around that of the second one.
struct Exact_meeting {
  Real_root t;
  Bracket s;
  Intersection_kind kind;
};
/// The ends of a part along which pieces run together, as t rises.
struct Exact_overlap {
  Real_root t_from, t_to, s_from, s_to;
};
/// All that two pieces have in common, in no order.
struct Exact_meetings {
  std::vector<Exact_meeting> points;
  std::vector<Exact_overlap> overlaps;
};

/// \pre neither is a point
/// \guarantee exact and complete, as exact_intersections
[[nodiscard]] Exact_meetings exact_meetings(const Integer_piece& a, const Integer_piece& b);
/// Which pairs of parameters of a piece with itself are taken.
enum class Parameter_order { RISING, FALLING, ANY };
/// Returns what a piece has in common with itself. \param order whether the second parameter is greater or less
[[nodiscard]] Exact_meetings exact_meetings(const Integer_piece& a, Parameter_order order);

/// The parameters in [0,1] at which a piece is at a point, in rising order. \pre the piece is no point
[[nodiscard]] std::vector<Real_root> exact_roots_at(const Integer_piece& a, const Xy<Exact_rational>& p);

/// Zero at the parameters of a where it is at b(s), for a root s of a polynomial; some zeros are none of these.
/// \pre a is no point
[[nodiscard]] Univariate places_of(const Integer_piece& a, const Integer_piece& b, const Univariate& roots);

/// A zero of a polynomial, with its signs between this zero and its neighbours; -1 beyond 0 and 1.
struct Exact_zero {
  Real_root t;
  int sign_before, sign_behind;
};
/// All zeros in [0,1], in rising order. \pre the polynomial is not zero
[[nodiscard]] std::vector<Exact_zero> exact_zeros(const Univariate& p);

}  // namespace CGAL::Bounding_arcs

#endif
