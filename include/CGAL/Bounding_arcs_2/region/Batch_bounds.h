// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a batch tells of a piece's thickness.

#ifndef CGAL_BOUNDING_ARCS_2_REGION_BATCH_BOUNDS_H
#define CGAL_BOUNDING_ARCS_2_REGION_BATCH_BOUNDS_H

#include <CGAL/Bounding_arcs_2/spiral/Batch_curve.h>

#include <cstddef>
#include <limits>

namespace CGAL::Bounding_arcs::internal {

inline constexpr std::size_t BATCH_SIZE = 64;
inline constexpr std::size_t BATCH_ALIGNMENT = 64;  ///< of arrays: bytes of the widest register

template <class Real>
[[nodiscard, gnu::always_inline]] inline Real smaller(Real x, Real y) {
  return x < y ? x : y;
}

/// lower <= thickness <= upper; -1 and infinity where the formula does not hold.
struct Batch_bounds {
  double lower, upper;
};

/// scale (size +- size relative +- absolute); nothing where `holds` is false.
[[nodiscard, gnu::always_inline]] inline Batch_bounds scaled_bounds(double scale, double size, double relative, double absolute, bool holds) {
  const double middle = scale * size, error = middle * relative + scale * absolute + Batch_precision<double>::UNDERFLOW_LENGTH;
  const double lower = middle - error, upper = middle + error;
  return {holds ? lower : -1.0, holds ? upper : std::numeric_limits<double>::infinity()};
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
