// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rounding error bounds ahead of time: a formula over Magnitude tells how large its results and their rounding errors
// can get over doubles, for all arguments up to given sizes. Invariant: for arguments within their sizes, the value and
// what double arithmetic makes of it are at most size in absolute value, and they differ by at most error.

#ifndef CGAL_BOUNDING_ARCS_2_INTERNAL_MAGNITUDE_H
#define CGAL_BOUNDING_ARCS_2_INTERNAL_MAGNITUDE_H

namespace CGAL::Bounding_arcs::internal {

struct Magnitude {
  double size = 0;
  double error = 0;

  constexpr Magnitude() = default;
  constexpr Magnitude(double x) : size(x < 0 ? -x : x) {}  // NOLINT: a number type converts from double; this one is held exactly
  constexpr Magnitude(double s, double e) : size(s), error(e) {}

  // The slack covers the roundings of the bounds themselves; the tiny term covers products that underflow.
  static constexpr double HALF_ULP = 0x1p-53, SLACK = 1 + 0x1p-48, TINY = 0x1p-1000;

  friend constexpr Magnitude operator+(const Magnitude& a, const Magnitude& b) {
    const double sum = (a.size + b.size) * SLACK;
    return {sum, (a.error + b.error + HALF_ULP * sum) * SLACK};
  }
  friend constexpr Magnitude operator-(const Magnitude& a, const Magnitude& b) { return a + b; }
  friend constexpr Magnitude operator*(const Magnitude& a, const Magnitude& b) {
    const double product = a.size * b.size * SLACK + TINY;
    return {product, (a.size * b.error + a.error * b.size + HALF_ULP * product) * SLACK + TINY};
  }
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
