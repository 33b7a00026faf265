// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A number as an unevaluated sum of two doubles, without a bound of its error: that is known ahead, as the same formula
// over Pair_magnitude tells (see Magnitude), which makes it several times faster than Double_double.

#ifndef BOUNDING_ARCS_LIBRARY_NUMBER_PAIR_H
#define BOUNDING_ARCS_LIBRARY_NUMBER_PAIR_H

#include <CGAL/Bounding_arcs_2/number/strict_math.h>

#include <cmath>

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

/// hi + lo; lo is small against the terms that hi was made of, but not always against hi.
struct Pair {
  double hi = 0, lo = 0;

  // a - b exactly.
  CGAL_BOUNDING_ARCS_INLINE static Pair difference(double a, double b) {
    const double s = a - b, v = s - a;
    return {s, (a - (s - v)) - (b + v)};
  }
  CGAL_BOUNDING_ARCS_INLINE friend Pair operator-(const Pair& a) { return {-a.hi, -a.lo}; }
  CGAL_BOUNDING_ARCS_INLINE friend Pair operator+(const Pair& a, const Pair& b) {  // Knuth's sum of the high parts
    const double s = a.hi + b.hi, v = s - a.hi;
    return {s, ((a.hi - (s - v)) + (b.hi - v)) + (a.lo + b.lo)};
  }
  CGAL_BOUNDING_ARCS_INLINE friend Pair operator-(const Pair& a, const Pair& b) { return a + (-b); }
  CGAL_BOUNDING_ARCS_INLINE friend Pair operator*(double a, const Pair& b) {
    return {a * b.hi, product_error(a, b.hi) + a * b.lo};
  }
  CGAL_BOUNDING_ARCS_INLINE friend Pair operator*(const Pair& a, const Pair& b) {
    return {a.hi * b.hi, product_error(a.hi, b.hi) + (a.hi * b.lo + a.lo * b.hi)};
  }
  CGAL_BOUNDING_ARCS_INLINE friend Pair twice(const Pair& a) { return {2 * a.hi, 2 * a.lo}; }

 private:
  // a b less a b rounded, by Dekker: where std::fma is no instruction it is a call.
  CGAL_BOUNDING_ARCS_INLINE static double product_error(double a, double b) {
    constexpr double SPLIT = 0x1p27 + 1;
    const double ca = SPLIT * a, a1 = ca - (ca - a), a0 = a - a1, cb = SPLIT * b, b1 = cb - (cb - b), b0 = b - b1;
    return a0 * b0 - (((a * b - a1 * b1) - a0 * b1) - a1 * b0);
  }
};

/// hi + lo is off by error at most, |hi| <= size and |lo| <= low, but for underflow and overflow.
struct Pair_magnitude {
  double size = 0, low = 0, error = 0;

  static constexpr double U = HALF_ULP, SLACK = Magnitude::SLACK;

  friend constexpr Pair_magnitude operator+(const Pair_magnitude& a, const Pair_magnitude& b) {
    const double sum = (a.size + b.size) * SLACK, lows = (a.low + b.low) * SLACK, tail = (U * sum + lows) * SLACK;
    return {sum, tail, (a.error + b.error + U * (lows + tail)) * SLACK};
  }
  friend constexpr Pair_magnitude operator-(const Pair_magnitude& a) { return a; }
  friend constexpr Pair_magnitude operator-(const Pair_magnitude& a, const Pair_magnitude& b) { return a + b; }
  friend constexpr Pair_magnitude operator*(double a, const Pair_magnitude& b) { return Pair_magnitude{a, 0, 0} * b; }
  friend constexpr Pair_magnitude operator*(const Pair_magnitude& a, const Pair_magnitude& b) {
    const double product = a.size * b.size * SLACK, lows = (a.size * b.low + a.low * b.size) * SLACK,
                 tail = (U * product + lows) * SLACK;
    const double inherited = (a.size + a.low) * b.error + a.error * (b.size + b.low + b.error);
    return {product, tail, (inherited + a.low * b.low + U * (2 * lows + tail)) * SLACK};
  }
  friend constexpr Pair_magnitude twice(const Pair_magnitude& a) { return {2 * a.size, 2 * a.low, 2 * a.error}; }
};

}  // namespace CGAL::Bounding_arcs

#endif
