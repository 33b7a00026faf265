// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rounding error bounds ahead of time, from the ranges of arguments.

#ifndef CGAL_BOUNDING_ARCS_2_NUMBER_RANGED_MAGNITUDE_H
#define CGAL_BOUNDING_ARCS_2_NUMBER_RANGED_MAGNITUDE_H

#include <CGAL/Bounding_arcs_2/number/Magnitude.h>
#include <CGAL/Bounding_arcs_2/number/always_inline.h>

#include <cmath>

namespace CGAL::Bounding_arcs {

/// Rounding error bounds ahead of time as by Magnitude, from ranges of the arguments instead of their sizes: tighter
/// where terms of a sum have other signs, and with quotients.
///
/// Invariant, where nothing underflows: for arguments in their ranges the exact value is within radius of middle, and
/// what double arithmetic makes of it differs by at most half_ulps u, u = 2^-53. In float this holds for u = 2^-24.
/// Computed values are at most size, so bounds have terms of second order, too. Middle and radius are themselves
/// rounded: each operation adds at least u times its result to the error, and they err by less than that, which size
/// has in it 2^29 times.
struct Ranged_magnitude {
  double middle = 0, radius = 0;
  double size = 0;
  double half_ulps = 0;

  static constexpr double LARGEST_HALF_ULP = 0x1p-24;  ///< of the types that bounds are for

  Ranged_magnitude() = default;
  Ranged_magnitude(double x) : middle(x), size(std::fabs(x)) {}  // NOLINT: a number type converts from double
  /// \param error of the argument, in half ulps
  Ranged_magnitude(double m, double r, double error)
      : middle(m), radius(r), size(std::fabs(m) + r + LARGEST_HALF_ULP * error), half_ulps(error) {}

  [[nodiscard]] double bound() const { return half_ulps * (HALF_ULP * Magnitude::SLACK); }

  CGAL_BOUNDING_ARCS_INLINE friend Ranged_magnitude operator+(const Ranged_magnitude& a, const Ranged_magnitude& b) {
    return rounded(a.middle + b.middle, a.radius + b.radius, a.half_ulps + b.half_ulps);
  }
  CGAL_BOUNDING_ARCS_INLINE friend Ranged_magnitude operator-(const Ranged_magnitude& a, const Ranged_magnitude& b) {
    return rounded(a.middle - b.middle, a.radius + b.radius, a.half_ulps + b.half_ulps);
  }
  CGAL_BOUNDING_ARCS_INLINE friend Ranged_magnitude operator*(const Ranged_magnitude& a, const Ranged_magnitude& b) {
    return rounded(a.middle * b.middle, std::fabs(a.middle) * b.radius + a.radius * b.size,
                   a.size * b.half_ulps + a.half_ulps * b.size);
  }
  /// One over a positive number x, computed as y: it errs by |x - y| / (x y), and is rounded. Where x is not certain to
  /// be positive the result is too large for any use, but finite as products of it are.
  friend Ranged_magnitude inverse(const Ranged_magnitude& x) {
    constexpr double USELESS = 0x1p100;
    const double low = x.middle - x.radius, high = x.middle + x.radius, least = low - LARGEST_HALF_ULP * x.half_ulps;
    if (!(least > 1 / USELESS)) return {0, USELESS, USELESS};
    const double product = low * high;
    return rounded(x.middle / product, x.radius / product, x.half_ulps / (least * least));
  }

 private:
  // A result with the error of what it is made from, which its own rounding is added to.
  CGAL_BOUNDING_ARCS_INLINE static Ranged_magnitude rounded(double middle, double radius, double inherited) {
    Ranged_magnitude r(middle, radius, inherited);
    r.half_ulps += r.size;
    return r;
  }
};

}  // namespace CGAL::Bounding_arcs

#endif
