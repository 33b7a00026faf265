// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rounding error bounds ahead of time, from the sizes of arguments.

#ifndef CGAL_BOUNDING_ARCS_2_NUMBER_MAGNITUDE_H
#define CGAL_BOUNDING_ARCS_2_NUMBER_MAGNITUDE_H

#include <CGAL/Bounding_arcs_2/number/half_ulp.h>
#include <CGAL/Bounding_arcs_2/number/strict_math.h>

namespace CGAL::Bounding_arcs {

/// Rounding error bounds ahead of time: a formula over Magnitude tells how large its results and their rounding errors
/// can get over doubles, for all arguments up to given sizes. Invariant, where nothing underflows and after less than
/// 2^12 operations: for arguments within their sizes, the value and what double arithmetic makes of it are at most
/// size * SLACK in absolute value, and they differ by at most bound().
struct Magnitude {
  double size = 0;
  double half_ulps = 0;  ///< the error in units of HALF_ULP, which saves its product with each size

  constexpr Magnitude() = default;
  constexpr Magnitude(double x) : size(x < 0 ? -x : x) {}  // NOLINT: a number type converts from double; held exactly
  constexpr Magnitude(double s, double e) : size(s), half_ulps(e) {}

  // The slack is for roundings of the bounds themselves, two half ulps an operation, and for what errors of errors add.
  static constexpr double SLACK = 1 + 0x1p-40;

  [[nodiscard]] constexpr double bound() const { return half_ulps * (HALF_ULP * SLACK); }

  friend constexpr Magnitude operator+(const Magnitude& a, const Magnitude& b) {
    const double sum = a.size + b.size;
    return {sum, a.half_ulps + b.half_ulps + sum};
  }
  friend constexpr Magnitude operator-(const Magnitude& a, const Magnitude& b) { return a + b; }
  friend constexpr Magnitude operator*(const Magnitude& a, const Magnitude& b) {
    const double product = a.size * b.size;
    return {product, a.size * b.half_ulps + a.half_ulps * b.size + product};
  }
};

}  // namespace CGAL::Bounding_arcs

#endif
