// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parameters of halves.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_SPIRAL_GRID_H
#define CGAL_BOUNDING_ARCS_2_TREE_SPIRAL_GRID_H

#include <CGAL/Bounding_arcs_2/number/strict_math.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

// Words as sets of 64 bits, by what every processor has: std::bitset looks bytes up one by one on those of before 2008,
// for which code is made where nothing else is said.

namespace CGAL::Bounding_arcs::internal {

/// How many bits are set: sums of 2, 4, 8 and at last all of them.
[[nodiscard]] inline std::size_t count_ones(std::uint64_t word) {
  word -= word >> 1 & 0x5555'5555'5555'5555;
  word = (word & 0x3333'3333'3333'3333) + (word >> 2 & 0x3333'3333'3333'3333);
  word = (word + (word >> 4)) & 0x0f0f'0f0f'0f0f'0f0f;
  return static_cast<std::size_t>(word * 0x0101'0101'0101'0101 >> 56);
}
/// Zeros below the lowest set bit; 64 of 0.
[[nodiscard]] inline int count_zeros(std::uint64_t word) {
  if (word == 0) return 64;
#ifdef __GNUC__
  return __builtin_ctzll(word);
#else
  int n = 0;
  for (int step = 32; step > 0; step /= 2)
    if ((word & (~std::uint64_t(0) >> (64 - step))) == 0) {
      word >>= step;
      n += step;
    }
  return n;
#endif
}

constexpr int MANTISSA_BITS = 52, EXPONENT_BIAS = 1023;
/// The exponent of a positive normal number, 1024 of infinity.
[[nodiscard]] inline int exponent_of(double x) {
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  return static_cast<int>(bits >> MANTISSA_BITS) - EXPONENT_BIAS;
}
/// 2^-n for 0 <= n < 1023.
[[nodiscard]] inline double halved(int n) {
  const std::uint64_t bits = static_cast<std::uint64_t>(EXPONENT_BIAS - n) << MANTISSA_BITS;
  double x;
  std::memcpy(&x, &bits, sizeof x);
  return x;
}

/// The parameters at which a spiral segment is halved: piece `place` of the 2^level equal ones.
/// Invariant: a parameter is the same double on every level, and the ends are the segment's own.
class Spiral_grid {
 public:
  static constexpr int MAX_LEVEL = 52;  ///< places are doubles without rounding

  Spiral_grid(double first, double last) : first_(first), last_(last), length_(last - first) {
    // so that the last parameter is reached although the difference was rounded
    if (first + length_ < last) length_ = std::nextafter(length_, std::numeric_limits<double>::infinity());
  }

  /// The number of halvings that the parameters have room for: pieces two ulps long have different ends whatever the
  /// rounding, and half-way points between them.
  [[nodiscard]] int levels() const {
    const double ulp = std::numeric_limits<double>::epsilon() * (std::max)(std::fabs(first_), std::fabs(last_));
    return length_ >= 4 * ulp ? (std::min)(MAX_LEVEL, exponent_of(length_ / ulp) - 1) : 0;
  }
  [[nodiscard]] double first() const { return first_; }
  [[nodiscard]] double last() const { return last_; }
  /// The length of a level's pieces.
  [[nodiscard]] double step(int level) const { return length_ * halved(level); }
  /// Where piece `place` of a level begins, and the one before it ends.
  [[nodiscard]] double parameter(int level, std::uint64_t place) const {
    return (std::min)(first_ + static_cast<double>(place) * step(level), last_);
  }

 private:
  double first_, last_, length_;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
