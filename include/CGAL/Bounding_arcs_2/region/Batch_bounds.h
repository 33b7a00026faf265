// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a batch tells of a piece's thickness.

#ifndef CGAL_BOUNDING_ARCS_2_REGION_BATCH_BOUNDS_H
#define CGAL_BOUNDING_ARCS_2_REGION_BATCH_BOUNDS_H

#include <CGAL/Bounding_arcs_2/spiral/Batch_curve.h>

#include <limits>

namespace CGAL::Bounding_arcs::internal {

/// lower <= thickness <= upper; -1 and infinity where the formula does not hold.
template <class Real>
struct Batch_bounds {
  Real lower, upper;
};

/// scale (size +- size relative +- absolute); nothing where `holds` is false.
template <class Real>
[[nodiscard, gnu::always_inline]] inline Batch_bounds<Real> scaled_bounds(Real scale, Real size, Real relative, Real absolute, bool holds) {
  const Real middle = scale * size, error = middle * relative + scale * absolute + Batch_precision<Real>::UNDERFLOW_LENGTH;
  const Real lower = middle - error, upper = middle + error;
  return {holds ? lower : Real(-1), holds ? upper : std::numeric_limits<Real>::infinity()};
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
