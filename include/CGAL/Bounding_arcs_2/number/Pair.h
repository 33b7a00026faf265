// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A number as an unevaluated sum of two doubles, without a bound of its error: that is known ahead, as the same formula
// over Pair_magnitude tells (see Magnitude), which makes it several times faster than Double_double.

#ifndef CGAL_BOUNDING_ARCS_2_NUMBER_PAIR_H
#define CGAL_BOUNDING_ARCS_2_NUMBER_PAIR_H

#include <CGAL/Bounding_arcs_2/number/Magnitude.h>
#include <CGAL/Bounding_arcs_2/number/always_inline.h>

namespace CGAL::Bounding_arcs {

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
