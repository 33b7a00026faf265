// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A double that carries a bound of its own rounding error, in round-to-nearest: running error analysis
// (Wilkinson 1986).  The value takes the same operations in the same order as plain double, so it has the same bits.

#ifndef CGAL_BOUNDING_ARCS_2_NUMBER_BOUNDED_DOUBLE_H
#define CGAL_BOUNDING_ARCS_2_NUMBER_BOUNDED_DOUBLE_H

#include <CGAL/Bounding_arcs_2/number/number_types.h>
#include <CGAL/Bounding_arcs_2/number/strict_math.h>

#include <boost/config.hpp>

#include <cmath>
#include <limits>

namespace CGAL::Bounding_arcs {

/// value and a bound: |value - true value| <= error_bound().
/// \guarantee certified. Each operation adds half an ulp of its result, u |value|, and UNDERFLOW_SLACK for a lost
///   subnormal; the bounds themselves are rounded, which BOUND_SLACK makes up for (valid below 2^20 chained operations,
///   each with at most 2^4 roundings of u = 2^-53 in its bound).
class Bounded_double {
 public:
  Bounded_double() = default;
  Bounded_double(double value) : value_(value) {}  // NOLINT: a double is its own exact value
  Bounded_double(int value) : value_(value) {}     // NOLINT
  Bounded_double(double value, double error) : value_(value), error_(error) {}

  [[nodiscard]] double value() const { return value_; }
  [[nodiscard]] double error_bound() const { return error_ * (1 + BOUND_SLACK); }
  /// A double that is at least the true value.
  [[nodiscard]] double upper() const {
    return error_ == 0 ? value_ : std::nextafter(value_ + error_bound(), std::numeric_limits<double>::infinity());
  }
  /// A double that is at most the true value.
  [[nodiscard]] double lower() const {
    return error_ == 0 ? value_ : std::nextafter(value_ - error_bound(), -std::numeric_limits<double>::infinity());
  }

  friend Bounded_double operator-(const Bounded_double& a) { return {-a.value_, a.error_}; }
  friend Bounded_double operator+(const Bounded_double& a, const Bounded_double& b) {
    const double v = a.value_ + b.value_;
    return {v, a.error_ + b.error_ + HALF_ULP * std::fabs(v)};
  }
  friend Bounded_double operator-(const Bounded_double& a, const Bounded_double& b) {
    const double v = a.value_ - b.value_;
    return {v, a.error_ + b.error_ + HALF_ULP * std::fabs(v)};
  }
  friend Bounded_double operator*(const Bounded_double& a, const Bounded_double& b) {
    const double v = a.value_ * b.value_;
    if (v == 0 && (a.is_zero() || b.is_zero())) return {v, 0};
    return {v, a.error_ * (std::fabs(b.value_) + b.error_) + std::fabs(a.value_) * b.error_ + HALF_ULP * std::fabs(v) +
                   UNDERFLOW_SLACK};
  }
  friend Bounded_double operator/(const Bounded_double& a, const Bounded_double& b) {
    const double v = a.value_ / b.value_, least = std::fabs(b.value_) - b.error_ * (1 + BOUND_SLACK);
    if (a.is_zero() && least > 0) return {v, 0};
    if (!(least > 0)) return {v, std::numeric_limits<double>::infinity()};
    // a product of errors may be lost, too, and is divided by what may be as small
    return {v,
            (a.error_ + std::fabs(v) * b.error_ + UNDERFLOW_SLACK) / least + HALF_ULP * std::fabs(v) + UNDERFLOW_SLACK};
  }
  friend Bounded_double sqrt(const Bounded_double& a) {
    const double v = std::sqrt(a.value_);
    if (a.is_zero()) return {0.0, 0.0};
    if (!(a.value_ > 0)) return {0.0, std::sqrt(a.error_)};
    // |sqrt(x) - sqrt(a)| = |x - a| / (sqrt(x) + sqrt(a)) <= |x - a| / sqrt(a)
    return {v, a.error_ / v * (1 + BOUND_SLACK) + HALF_ULP * v};
  }
  friend Bounded_double abs(const Bounded_double& a) { return {std::fabs(a.value_), a.error_}; }
  /// |max(x, y) - max(a, b)| <= max(|x - a|, |y - b|): the smaller value may have the larger error.
  friend Bounded_double max BOOST_PREVENT_MACRO_SUBSTITUTION(const Bounded_double& a, const Bounded_double& b) {
    return {a.value_ < b.value_ ? b.value_ : a.value_, a.error_ < b.error_ ? b.error_ : a.error_};
  }
  friend bool operator<(const Bounded_double& a, const Bounded_double& b) { return a.value_ < b.value_; }
  friend bool operator>(const Bounded_double& a, const Bounded_double& b) { return a.value_ > b.value_; }
  friend bool operator<=(const Bounded_double& a, const Bounded_double& b) { return a.value_ <= b.value_; }
  friend bool operator>=(const Bounded_double& a, const Bounded_double& b) { return a.value_ >= b.value_; }
  friend bool operator==(const Bounded_double& a, const Bounded_double& b) { return a.value_ == b.value_; }
  friend bool operator!=(const Bounded_double& a, const Bounded_double& b) { return a.value_ != b.value_; }

 private:
  static constexpr double BOUND_SLACK = 0x1p-28;
  static constexpr double UNDERFLOW_SLACK = std::numeric_limits<double>::min();

  [[nodiscard]] bool is_zero() const { return value_ == 0 && error_ == 0; }

  double value_ = 0;
  double error_ = 0;
};

[[nodiscard]] inline bool certainly_less(const Bounded_double& x, const Bounded_double& y) {
  return x.upper() < y.lower();
}

/// x, known to lie between 0 and limit(): an error bound larger than x is cut to what that leaves possible.
template <class Limit> [[nodiscard]] Bounded_double limited(const Bounded_double& x, const Limit& limit) {
  const double value = x.value();
  if (x.error_bound() <= value || !(value >= 0)) return x;
  const double error = std::fmax(value, limit().upper() - value);
  if (!(error < x.error_bound())) return x;
  return Bounded_double(value, std::nextafter(error, std::numeric_limits<double>::infinity()));
}

}  // namespace CGAL::Bounding_arcs

#endif
