// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a batch tells of a piece's thickness.

#ifndef CGAL_BOUNDING_ARCS_2_REGION_BATCH_BOUNDS_H
#define CGAL_BOUNDING_ARCS_2_REGION_BATCH_BOUNDS_H

namespace CGAL::Bounding_arcs::internal {

/// lower <= thickness <= upper; -1 and infinity where the formula does not hold.
struct Batch_bounds {
  double lower, upper;
};

/// Relative error that the roundings of a batch's formula add to those of its figures: these are exact to 2^-33 where the
/// thresholds of Batch_curve are met, and no formula has more than six of them as factors.
inline constexpr double BATCH_ROUNDING = 0x1p-30;
/// A figure this many times its error bound has a certain sign.
inline constexpr double CERTAIN = 0x1p10;

}  // namespace CGAL::Bounding_arcs::internal

#endif
