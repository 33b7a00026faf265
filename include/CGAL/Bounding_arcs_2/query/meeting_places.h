// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Polynomials whose roots are where pieces meet: the numbers that exact decisions about common points are made of.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_MEETING_PLACES_H
#define CGAL_BOUNDING_ARCS_2_QUERY_MEETING_PLACES_H

#include <CGAL/Bounding_arcs_2/curve/Integer_piece.h>
#include <CGAL/Bounding_arcs_2/polynomial/Integer_polynomial.h>

namespace CGAL::Bounding_arcs {

/// Zero at each parameter of a where it meets b at a single point, or where both stop running together though neither
/// ends. If they are parts of one curve, it is zero at the double points of a.
/// \pre neither is a point
/// \return zero everywhere, where single points are not what they have in common
[[nodiscard]] Univariate meeting_places(const Integer_piece& a, const Integer_piece& b, bool is_overlap_end);

/// Zero at the parameters of a where it is at b(s), for a root s of a polynomial.
/// \pre a is no point
[[nodiscard]] Univariate places_of(const Integer_piece& a, const Integer_piece& b, const Univariate& roots);

}  // namespace CGAL::Bounding_arcs

#endif
