// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a number's 17 digits are x 10^q, q from 0 to 38, that product is one of a whole number of 53 bits by one of 127
// bits, divided by a power of two: it is made exactly, in 192 bits. That is so from 1e-21 to 2^53. All numbers nearer
// to x than half an ulp read back as x. In units of the 17th digit that is from 0.55 to 11.2: one number of 15 digits
// at most is as near, and the nearest one of 17 digits is always. The standard library, which takes twice as long, does
// the rest.

#include "number_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <optional>

namespace bounding_arcs_tool {
namespace {

__extension__ using Wide = unsigned __int128;

constexpr int DIGITS = 17, MOST_POWER = 38;  // 10^38 < 2^127
constexpr std::uint64_t TEN_TO_8 = 100'000'000, TEN_TO_16 = TEN_TO_8 * TEN_TO_8, TEN_TO_17 = 10 * TEN_TO_16;
constexpr double LEAST = 1e-21, MOST = 0x1p53;

constexpr std::array<Wide, MOST_POWER + 1> powers_of_ten() {
  std::array<Wide, MOST_POWER + 1> powers{1};
  for (std::size_t i = 1; i < powers.size(); ++i) powers[i] = 10 * powers[i - 1];
  return powers;
}
constexpr auto POWERS = powers_of_ten();

/// Which decimal exponent a double has, but for those next to a power of ten.
constexpr int LEAST_EXPONENT = -21;
constexpr double TENS[] = {1e-21, 1e-20, 1e-19, 1e-18, 1e-17, 1e-16, 1e-15, 1e-14, 1e-13, 1e-12, 1e-11, 1e-10, 1e-9,
                           1e-8,  1e-7,  1e-6,  1e-5,  1e-4,  1e-3,  1e-2,  1e-1,  1e0,   1e1,   1e2,   1e3,   1e4,
                           1e5,   1e6,   1e7,   1e8,   1e9,   1e10,  1e11,  1e12,  1e13,  1e14,  1e15,  1e16};

constexpr std::array<char, 200> pairs_of_digits() {
  std::array<char, 200> pairs{};
  for (std::size_t i = 0; i < 100; ++i) {
    pairs[2 * i] = static_cast<char>('0' + i / 10);
    pairs[2 * i + 1] = static_cast<char>('0' + i % 10);
  }
  return pairs;
}
constexpr auto PAIRS = pairs_of_digits();

/// A number below 2^64 and what is behind its point: in units of 2^-64, and whether there is still more.
struct Fixed_point {
  std::uint64_t whole, fraction;
  bool has_more;
};

// mantissa 10^power / 2^shift, the shift from 0 to 127.
Fixed_point scaled(std::uint64_t mantissa, int power, int shift) {
  const Wide ten = POWERS[static_cast<std::size_t>(power)];
  const Wide lower = Wide(mantissa) * static_cast<std::uint64_t>(ten);
  const Wide upper = Wide(mantissa) * static_cast<std::uint64_t>(ten >> 64) + (lower >> 64);
  const auto last = static_cast<std::uint64_t>(lower);
  if (shift < 64) {
    const Wide both = upper << 64 | last;
    return {static_cast<std::uint64_t>(both >> shift), shift == 0 ? 0 : last << (64 - shift), false};
  }
  const int rest = shift - 64;
  return {static_cast<std::uint64_t>(upper >> rest), static_cast<std::uint64_t>((upper << 64 | last) >> rest),
          (last & ((std::uint64_t(1) << rest) - 1)) != 0};
}

/// digits 10^(exponent - 16), with 17 digits.
struct Decimal {
  std::uint64_t digits;
  int exponent;
};

// 10^power / 2^(shift + 1) in units of 2^-unit, cut off.
std::uint64_t half_ulp_in(int unit, int power, int shift) {
  const int by = shift + 1 - unit, up = by < 0 ? -by : 0;
  return static_cast<std::uint64_t>(POWERS[static_cast<std::size_t>(power)] << up >> (by + up));
}

// The fewest digits that read back as x, for x within LEAST and MOST; nothing where that needs more bits, where two
// numbers are as near, or where the double below x is nearer than the one above.
std::optional<Decimal> decimal(double x) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &x, sizeof bits);
  constexpr int MANTISSA_BITS = 52, BIAS = 1023;
  constexpr std::uint64_t ONE = std::uint64_t(1) << MANTISSA_BITS;
  const int binary = static_cast<int>(bits >> MANTISSA_BITS) - BIAS;  // 2^binary <= x
  const std::uint64_t mantissa = (bits & (ONE - 1)) | ONE;
  if (mantissa == ONE) return std::nullopt;
  constexpr int LOG = 78913, LOG_SHIFT = 18;   // log10(2) 2^18 rounded down, with the same floors while |binary| < 1650
  int exponent = (binary * LOG) >> LOG_SHIFT;  // that of x, or one less
  exponent += x >= TENS[exponent + 1 - LEAST_EXPONENT];
  const int shift = MANTISSA_BITS - binary;
  Fixed_point d = scaled(mantissa, DIGITS - 1 - exponent, shift);
  if (d.whole < TEN_TO_16) {  // 10^exponent is a little larger than its double, which x is
    --exponent;
    d = scaled(mantissa, DIGITS - 1 - exponent, shift);
  }
  // In units of 2^-56: how far multiples of 100 and of 10 are, and half an ulp. Cut off, each is less than 1 too small.
  constexpr int UNIT = 56;
  constexpr std::uint64_t HUNDRED = std::uint64_t(100) << UNIT, TEN = HUNDRED / 10, CUT_OFF = 2;
  const std::uint64_t of_100 = d.whole % 100, of_10 = of_100 % 10, behind_point = d.fraction >> (64 - UNIT);
  const std::uint64_t over_100 = of_100 << UNIT | behind_point, over_10 = of_10 << UNIT | behind_point;
  const std::uint64_t to_100 = (std::min)(over_100, HUNDRED - over_100), to_10 = (std::min)(over_10, TEN - over_10);
  const std::uint64_t half_ulp = half_ulp_in(UNIT, DIGITS - 1 - exponent, shift);
  const auto is_open = [&](std::uint64_t way) { return way - half_ulp + CUT_OFF <= 2 * CUT_OFF; };
  const bool is_halfway = !d.has_more && d.fraction << 1 == 0 && (d.fraction != 0 || of_10 == 5);
  if (is_open(to_100) || is_open(to_10) || is_halfway) return std::nullopt;
  const std::uint64_t nearest_100 = d.whole - of_100 + (to_100 == over_100 ? 0 : 100),
                      nearest_10 = d.whole - of_10 + (to_10 == over_10 ? 0 : 10),
                      nearest = d.whole + (d.fraction >> 63);
  const std::uint64_t of_16 = to_10 < half_ulp ? nearest_10 : nearest;
  const std::uint64_t digits = to_100 < half_ulp ? nearest_100 : of_16;
  return digits == TEN_TO_17 ? Decimal{TEN_TO_16, exponent + 1} : Decimal{digits, exponent};
}

void write_pair(char* to, std::uint32_t x) { std::memcpy(to, &PAIRS[2 * std::size_t(x)], 2); }

void write_eight(char* to, std::uint32_t x) {
  const std::uint32_t upper = x / 10000, lower = x % 10000;
  write_pair(to, upper / 100);
  write_pair(to + 2, upper % 100);
  write_pair(to + 4, lower / 100);
  write_pair(to + 6, lower % 100);
}

// Writes d as a fraction, or with an exponent, as write_number tells. Copies are of fixed sizes, which go beyond what
// is written.
char* write_decimal(char* to, const Decimal& d) {
  constexpr std::size_t ALL = 16;
  char digits[DIGITS + ALL] = {};
  digits[0] = static_cast<char>('0' + d.digits / TEN_TO_16);
  const std::uint64_t rest = d.digits % TEN_TO_16;
  write_eight(digits + 1, static_cast<std::uint32_t>(rest / TEN_TO_8));
  write_eight(digits + 9, static_cast<std::uint32_t>(rest % TEN_TO_8));
  int size = DIGITS - static_cast<int>(digits[DIGITS - 1] == '0');  // without a branch: half of all have a 0 there
  while (size > 1 && digits[size - 1] == '0') --size;
  if (d.exponent >= -4 && d.exponent < 0) {
    std::memcpy(to, "0.0000", 6);
    to += 1 - d.exponent;
    *to = digits[0];
    std::memcpy(to + 1, digits + 1, ALL);
    return to + size;
  }
  const int whole = d.exponent < 0 ? 1 : d.exponent + 1;  // digits before the point, at most 16
  std::memcpy(to, digits, ALL);
  if (size > whole) {
    to[whole] = '.';
    std::memcpy(to + whole + 1, digits + whole, ALL);
  }
  to += size > whole ? size + 1 : whole;
  if (d.exponent < 0) {
    std::memcpy(to, "e-", 2);
    write_pair(to + 2, static_cast<std::uint32_t>(-d.exponent));
    to += 4;
  }
  return to;
}

}  // namespace

char* write_number(char* to, double x) {
  const double size = x < 0 ? -x : x;
  if (size == 0 || size == 1) {  // ends of parameters
    if (std::signbit(x)) *to++ = '-';
    *to++ = size == 0 ? '0' : '1';
    return to;
  }
  if (size >= LEAST && size < MOST)
    if (const std::optional<Decimal> found = decimal(size)) {
      *to = '-';
      to += x < 0;  // no branch that would be wrong half of the time
      return write_decimal(to, *found);
    }
  constexpr double LEAST_FRACTION = 1e-4, MOST_WHOLE = 1e16;
  const bool has_exponent = size < LEAST_FRACTION || size >= MOST_WHOLE;
  const auto form = has_exponent ? std::chars_format::scientific : std::chars_format::fixed;
  return std::to_chars(to, to + NUMBER_ROOM, x, form).ptr;
}

void add_number(std::string& text, double x) {
  char digits[NUMBER_ROOM];
  text.append(digits, write_number(digits, x));
}

std::string number(double x) {
  std::string text;
  add_number(text, x);
  return text;
}

std::string place_text(const CGAL::Bounding_arcs::Xy<double>& p) {
  constexpr int FEW = 9;  // told apart beside a drawing, and short
  const auto few = [](double x) {
    char text[NUMBER_ROOM];
    return std::string(text, std::to_chars(text, text + NUMBER_ROOM, x, std::chars_format::general, FEW).ptr);
  };
  return "(" + few(p.x) + ", " + few(p.y) + ")";
}

std::string short_number(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "%.4g", x);
  return std::isfinite(x) ? text : "null";
}

}  // namespace bounding_arcs_tool
