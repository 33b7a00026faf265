// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The arcs of regions whose sides have a joint, over the unit chord: the tight end at 0, the flat end at 1, centers of
// curvature to the left, points as complex numbers.  With e^(-i alpha0) and e^(i alpha1) the directions of the curve at
// its ends, an arc that leaves 0 in the first and ends in z turns by twice the angle of z e^(i alpha0), and its bulge
// is the tangent of half that angle.

#ifndef BOUNDING_ARCS_LIBRARY_TREE_BATCH_JOINT_ARCS_H
#define BOUNDING_ARCS_LIBRARY_TREE_BATCH_JOINT_ARCS_H

#include "Half_tangents.h"

#include <CGAL/Bounding_arcs_2/number/strict_math.h>

#include <cmath>

namespace CGAL::Bounding_arcs::filter {

/// One side: from the tight end by an arc with the first bulge to the joint, from there by one with the second.
struct Joint_side {
  double x, y;
  double tight, flat;
};

/// The arcs of a region whose sides have a joint, over the unit chord.
struct Joint_arcs {
  Joint_side inner, outer;
  bool holds;
};

/// What a bulge Im / (|q| + Re) of q = Re + i Im is divided by: of wide pieces that, of narrow ones Re alone, and the
/// bulge is had from the quotient by its series.
template <bool WIDE>
[[nodiscard]] CGAL_BOUNDING_ARCS_INLINE double bulge_divisor(double re, [[maybe_unused]] double square) {
  if constexpr (WIDE) return re + std::sqrt(square);
  else return re;
}
template <bool WIDE> [[nodiscard]] CGAL_BOUNDING_ARCS_INLINE double bulge_of(double quotient) {
  if constexpr (WIDE) return quotient;
  else return quotient * Half_tangents::series(quotient * quotient);
}

}  // namespace CGAL::Bounding_arcs::filter

#endif
