// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers of some 100 bits, as sums of two doubles.

#ifndef CGAL_BOUNDING_ARCS_2_NUMBER_DOUBLE_DOUBLE_H
#define CGAL_BOUNDING_ARCS_2_NUMBER_DOUBLE_DOUBLE_H

#include <CGAL/Bounding_arcs_2/number/convert.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <optional>
#include <utility>

namespace CGAL::Bounding_arcs {

/// A number as an unevaluated sum of two doubles with a bound on its error: some 100 bits, and certain signs.
/// Invariant: the exact value lies within err of hi + lo, given rounding to nearest and no contraction of products.
/// Bounds below are for rounding to nearest: u = 2^-53; a sum or product of the low parts is off by at most u times its
/// size, and ROUNDING covers four of them.
struct Double_double {
  static constexpr double ROUNDING = 0x1p-51, INFLATION = 1 + 0x1p-49, UNDERFLOW_SLACK = 0x1p-1000;
  double hi = 0, lo = 0, err = 0;

  Double_double() = default;
  Double_double(double h) : hi(h) {}  // NOLINT: a number type converts from double
  Double_double(double h, double l, double e) : hi(h), lo(l), err(e) {}

  [[nodiscard]] double size() const { return std::abs(hi) + std::abs(lo) + err; }
  // -1, 0, 1, or nothing when the bound does not decide.
  [[nodiscard]] std::optional<int> sign() const {
    if (std::abs(hi) > (std::abs(lo) + err) * INFLATION) return hi > 0 ? 1 : -1;
    if (hi == 0 && lo == 0 && err == 0) return 0;
    return std::nullopt;
  }

  // In large units the compiler calls these few instructions if it may, which takes a sixth of all time more.
  // a + b exactly, as a rounded sum and its error (Knuth).
  BOOST_FORCEINLINE static Double_double two_sum(double a, double b) {
    const double s = a + b, v = s - a;
    return {s, (a - (s - v)) + (b - v), 0};
  }
  BOOST_FORCEINLINE friend Double_double operator+(const Double_double& a, const Double_double& b) {
    const Double_double s = two_sum(a.hi, b.hi);
    const double low = a.lo + b.lo, tail = s.lo + low;
    Double_double r = two_sum(s.hi, tail);
    r.err = (a.err + b.err + ROUNDING * (std::abs(low) + std::abs(tail))) * INFLATION;
    return r;
  }
  friend Double_double operator-(const Double_double& a) { return {-a.hi, -a.lo, a.err}; }
  BOOST_FORCEINLINE friend Double_double operator-(const Double_double& a, const Double_double& b) { return a + (-b); }
  BOOST_FORCEINLINE friend Double_double operator*(const Double_double& a, const Double_double& b) {
    const double p = a.hi * b.hi, e = std::fma(a.hi, b.hi, -p), cross = a.hi * b.lo + a.lo * b.hi, tail = e + cross;
    Double_double r = two_sum(p, tail);
    const double rounded = std::abs(a.hi * b.lo) + std::abs(a.lo * b.hi) + std::abs(tail);
    const double inherited = a.size() * b.err + b.size() * a.err + std::abs(a.lo * b.lo);
    r.err = (inherited + ROUNDING * rounded) * INFLATION + UNDERFLOW_SLACK;
    return r;
  }
  // Two steps of long division; the error is what is left over, divided by the divisor.
  friend Double_double operator/(const Double_double& a, const Double_double& b) {
    const double q = a.hi / b.hi, correction = (a - Double_double(q) * b).hi / b.hi;
    Double_double r = two_sum(q, correction);
    const Double_double rest = a - r * b;
    const double least = std::abs(b.hi) - std::abs(b.lo) - b.err;
    r.err = least > 0 ? rest.size() / least * INFLATION : HUGE_VAL;
    return r;
  }
  // A step of Newton's from the root of the high part; the error is what its square is off by, over twice the root.
  friend Double_double sqrt(const Double_double& a) {
    if (a.hi == 0 && a.lo == 0 && a.err == 0) return a;
    const double root = std::sqrt(a.hi);
    if (!(root > 0)) return {0, 0, std::sqrt(a.size())};
    Double_double r = two_sum(root, (a - Double_double(root) * Double_double(root)).hi / (2 * root));
    // |r - sqrt(a)| = |r^2 - a| / (r + sqrt(a)), and sqrt(a) >= 0
    r.err = (r * r - a).size() / (r.hi - std::abs(r.lo)) * INFLATION;
    return r;
  }
  friend Double_double abs(const Double_double& a) { return a.hi < 0 ? -a : a; }
  // An enclosure of the larger one: which that is may be open.
  friend Double_double max BOOST_PREVENT_MACRO_SUBSTITUTION(const Double_double& a, const Double_double& b) {
    Double_double r = a < b ? b : a;
    r.err = a.err < b.err ? b.err : a.err;
    return r;
  }
  // A double that is at least the exact value, and few ulp above where the error is small.
  [[nodiscard]] double upper() const {
    return std::nextafter(hi + (lo + err * INFLATION), std::numeric_limits<double>::infinity());
  }
  // By value; sign() of the difference tells whether it is certain.
  friend bool operator<(const Double_double& a, const Double_double& b) {
    return a.hi < b.hi || (a.hi == b.hi && a.lo < b.lo);
  }
  friend bool operator>(const Double_double& a, const Double_double& b) { return b < a; }
  friend bool operator==(const Double_double& a, const Double_double& b) { return a.hi == b.hi && a.lo == b.lo; }
};

[[nodiscard]] inline bool certainly_less(const Double_double& x, const Double_double& y) {
  return (x - y).sign() == -1;
}

// An exact number of any size as a double-double.
template <class Exact> Double_double to_double_double(const Exact& x) {
  const std::pair<double, double> rough = CGAL::to_interval(x);
  const double hi = rough.first + (rough.second - rough.first) / 2;
  if (!std::isfinite(hi)) return {0, 0, HUGE_VAL};
  const std::pair<double, double> rest = CGAL::to_interval(Exact(x - Exact(hi)));
  const Double_double r = Double_double::two_sum(hi, rest.first);
  return {r.hi, r.lo, (rest.second - rest.first) * Double_double::INFLATION};
}

/// Converts to double-doubles.
template <> struct internal::Converter<Double_double> {
  template <class Source> Double_double operator()(const Source& x) const { return to_double_double(x); }
  /// Converts exactly: a long double has no more bits than two doubles.
  Double_double operator()(long double x) const {
    const double high = static_cast<double>(x);
    return Double_double::two_sum(high, static_cast<double>(x - static_cast<long double>(high)));
  }
};

}  // namespace CGAL::Bounding_arcs

#endif
