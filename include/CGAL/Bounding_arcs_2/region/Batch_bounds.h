// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a batch tells of a piece's thickness.

#ifndef CGAL_BOUNDING_ARCS_2_REGION_BATCH_BOUNDS_H
#define CGAL_BOUNDING_ARCS_2_REGION_BATCH_BOUNDS_H

#include <cmath>

namespace CGAL::Bounding_arcs::internal {

/// lower <= thickness <= upper; -1 and infinity where the formula does not hold.
struct Batch_bounds {
  double lower, upper;
};

/// Relative error that the roundings of a batch's formula, and what its series leave out, add to the errors of numerator
/// and knesers: the other figures are exact to 2^-33 where the thresholds of Batch_curve are met, and no formula has more
/// than 16 of them as factors. Derived in doc/batches.md.
inline constexpr double BATCH_ROUNDING = 0x1p-29;
/// A figure this many times its error bound has a certain sign.
inline constexpr double CERTAIN = 0x1p14;
/// More than products near the least double lose of lengths.
inline constexpr double UNDERFLOW_LENGTH = 0x1p-1000;

/// scale (size +- size relative +- absolute); nothing where `holds` is false.
[[nodiscard, gnu::always_inline]] inline Batch_bounds scaled_bounds(double scale, double size, double relative, double absolute, bool holds) {
  const double middle = scale * size, error = middle * relative + scale * absolute + UNDERFLOW_LENGTH;
  const double lower = middle - error, upper = middle + error;
  return {holds ? lower : -1.0, holds ? upper : HUGE_VAL};
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
