// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Words as sets of 64 bits, by what every processor has: std::bitset looks bytes up one by one on those of before 2008,
// for which code is made where nothing else is said.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_INTERNAL_BITS_H
#define CGAL_BOUNDING_ARCS_2_TREE_INTERNAL_BITS_H

#include <CGAL/Bounding_arcs_2/number/strict_math.h>

#include <cstddef>
#include <cstdint>
#include <cstring>

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

}  // namespace CGAL::Bounding_arcs::internal

#endif
