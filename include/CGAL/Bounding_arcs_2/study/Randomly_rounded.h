// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A number that is computed several times at once, each time with other roundings: the spread of what comes out
// estimates how many digits are right, without any exact number.  Vignes 1974 (CESTAC).

#ifndef CGAL_BOUNDING_ARCS_2_STUDY_RANDOMLY_ROUNDED_H
#define CGAL_BOUNDING_ARCS_2_STUDY_RANDOMLY_ROUNDED_H

#include <CGAL/Bounding_arcs_2/number/strict_math.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

namespace CGAL::Bounding_arcs {

/// RUNS doubles, each operation on each of them rounded up or down by chance: an exact result stays what it is. Chance
/// is a hash of the operands, so that the same program gives the same numbers, on any thread.
/// \code
/// const Randomly_rounded third = Randomly_rounded(1) / 3, nothing = third * 3 - 1;
/// std::cout << third.digits() << " and " << nothing.digits() << " digits\n";  // 15 and 0
/// \endcode
/// \guarantee heuristic: an estimate from a sample, and rounding errors are no chance
/// \source Vignes, New methods for evaluating the validity of mathematical software, 1974; there three runs
class Randomly_rounded {
 public:
  static constexpr std::size_t RUNS = 8;

  Randomly_rounded(double x = 0) { runs_.fill(x); }  // NOLINT: a number type converts from double

  /// The mean of the runs.
  explicit operator double() const {
    double sum = 0;
    for (const double x : runs_) sum += x / RUNS;
    return sum;
  }
  /// With 95% confidence the mean is so far from the true value, if the runs were independent and their mean unbiased.
  [[nodiscard]] double estimated_error() const {
    constexpr double STUDENT = 2.365;  // the two-sided 95% quantile of 7 degrees of freedom
    const auto mean = static_cast<double>(*this);
    double sum = 0;
    for (const double x : runs_) sum += (x - mean) * (x - mean) / (RUNS - 1);
    return STUDENT * std::sqrt(sum / RUNS);
  }
  /// Decimal digits of the mean that are estimated to be right, 0 to 15.
  [[nodiscard]] double digits() const {
    constexpr double MOST = 15;
    const double error = estimated_error(), mean = std::fabs(static_cast<double>(*this));
    return error == 0 ? MOST : std::fmax(0, std::fmin(MOST, std::log10(mean / error)));
  }

  friend Randomly_rounded operator-(const Randomly_rounded& a) {
    return each(a, a, [](double x, double, std::uint64_t) { return -x; });
  }
  friend Randomly_rounded operator+(const Randomly_rounded& a, const Randomly_rounded& b) {
    return each(a, b, [](double x, double y, std::uint64_t run) {
      const double s = x + y, v = s - x;
      return rounded(s, (x - (s - v)) + (y - v), chance(x, y, run));
    });
  }
  friend Randomly_rounded operator-(const Randomly_rounded& a, const Randomly_rounded& b) { return a + -b; }
  friend Randomly_rounded operator*(const Randomly_rounded& a, const Randomly_rounded& b) {
    return each(a, b, [](double x, double y, std::uint64_t run) {
      const double p = x * y;
      return rounded(p, std::fma(x, y, -p), chance(x, y, run + RUNS));
    });
  }
  friend Randomly_rounded operator/(const Randomly_rounded& a, const Randomly_rounded& b) {
    return each(a, b, [](double x, double y, std::uint64_t run) {
      const double q = x / y, rest = std::fma(-q, y, x);
      return rounded(q, y < 0 ? -rest : rest, chance(x, y, run + 2 * RUNS));
    });
  }
  friend Randomly_rounded sqrt(const Randomly_rounded& a) {
    return each(a, a, [](double x, double, std::uint64_t run) {
      const double r = std::sqrt(x);
      return rounded(r, std::fma(-r, r, x), chance(x, x, run + 3 * RUNS));
    });
  }
  friend Randomly_rounded abs(const Randomly_rounded& a) { return a < 0 ? -a : a; }
  friend bool operator<(const Randomly_rounded& a, const Randomly_rounded& b) {
    return static_cast<double>(a) < static_cast<double>(b);
  }
  friend bool operator>(const Randomly_rounded& a, const Randomly_rounded& b) { return b < a; }
  friend bool operator==(const Randomly_rounded& a, const Randomly_rounded& b) {
    return static_cast<double>(a) == static_cast<double>(b);
  }
  friend bool operator!=(const Randomly_rounded& a, const Randomly_rounded& b) { return !(a == b); }

 private:
  template <class Operation>
  [[nodiscard]] static Randomly_rounded each(const Randomly_rounded& a, const Randomly_rounded& b,
                                             const Operation& operation) {
    Randomly_rounded r;
    for (std::size_t i = 0; i < RUNS; ++i) r.runs_[i] = operation(a.runs_[i], b.runs_[i], i);
    return r;
  }
  // The nearest double of a result that is `rest` above it, or its neighbour on the other side of the result.
  [[nodiscard]] static double rounded(double nearest, double rest, bool is_other) {
    if (!is_other || rest == 0 || !std::isfinite(nearest) || std::isnan(rest)) return nearest;
    return std::nextafter(nearest, std::copysign(std::numeric_limits<double>::infinity(), rest));
  }
  // The mixing of splitmix64 (Steele, Lea, Flood 2014).
  [[nodiscard]] static bool chance(double x, double y, std::uint64_t run) {
    std::uint64_t a, b;
    std::memcpy(&a, &x, sizeof a);
    std::memcpy(&b, &y, sizeof b);
    std::uint64_t z = a + 0x9e3779b97f4a7c15 * (run + 1) + (b << 21 | b >> 43);
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9;
    z = (z ^ z >> 27) * 0x94d049bb133111eb;
    return ((z ^ z >> 31) & 1) != 0;
  }

  std::array<double, RUNS> runs_;
};

}  // namespace CGAL::Bounding_arcs

#endif
