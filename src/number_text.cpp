// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a number's 17 digits are x 10^q, q from 0 to 38, that product is one of a whole number of 53 bits by one of 127
// bits, divided by a power of two: it is made exactly, in 192 bits, and rounded once. That is so from 1e-21 to 2^53.
// The standard library, which takes three times as long, does the rest.

#include "number_text.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>

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

// x within LEAST and MOST.
Decimal decimal(double x) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &x, sizeof bits);
  constexpr int MANTISSA_BITS = 52, BIAS = 1023;
  constexpr std::uint64_t ONE = std::uint64_t(1) << MANTISSA_BITS;
  const int binary = static_cast<int>(bits >> MANTISSA_BITS) - BIAS;  // 2^binary <= x
  const std::uint64_t mantissa = (bits & (ONE - 1)) | ONE;
  constexpr int LOG = 78913, LOG_SHIFT = 18;   // log10(2) 2^18 rounded down, with the same floors while |binary| < 1650
  int exponent = (binary * LOG) >> LOG_SHIFT;  // that of x, or one less
  exponent += x >= TENS[exponent + 1 - LEAST_EXPONENT];
  Fixed_point d = scaled(mantissa, DIGITS - 1 - exponent, MANTISSA_BITS - binary);
  if (d.whole < TEN_TO_16) {  // 10^exponent is a little larger than its double, which x is
    --exponent;
    d = scaled(mantissa, DIGITS - 1 - exponent, MANTISSA_BITS - binary);
  }
  constexpr std::uint64_t HALF = std::uint64_t(1) << 63;
  const bool is_above = d.fraction > HALF || (d.fraction == HALF && (d.has_more || d.whole % 2 == 1));
  d.whole += is_above;
  return d.whole == TEN_TO_17 ? Decimal{TEN_TO_16, exponent + 1} : Decimal{d.whole, exponent};
}

// The eight digits of x < 10^8, a byte each, the first one lowest: halves, quarters and eighths of them side by side,
// each divided by 100 or 10 as a product with a reciprocal that is exact for what is less than 10^4 and 100.
std::uint64_t eight_digits(std::uint64_t x) {
  const std::uint64_t halves = x / 10000 | (x % 10000) << 32;
  const std::uint64_t hundreds = (halves * 10486 >> 20) & 0x7f'0000'007f;
  const std::uint64_t quarters = hundreds | (halves - 100 * hundreds) << 16;
  const std::uint64_t tens = (quarters * 103 >> 10) & 0xf'000f'000f'000f;
  return tens | (quarters - 10 * tens) << 8;
}
// How many bytes at the end are zero.
int zeros_behind(std::uint64_t digits) { return digits == 0 ? 8 : __builtin_clzll(digits) / 8; }

// Sixteen characters, the first one lowest; compilers make two stores of it.
void write_sixteen(char* to, Wide text) {
  const auto first = static_cast<std::uint64_t>(text), second = static_cast<std::uint64_t>(text >> 64);
  for (int i = 0; i < 8; ++i) to[i] = static_cast<char>(first >> 8 * i);
  for (int i = 0; i < 8; ++i) to[8 + i] = static_cast<char>(second >> 8 * i);
}

// Writes d as a fraction, or with an exponent, as %g does. Digits are put together in registers and written all, beyond
// the end, too: no length is looked at, and nothing is read that has just been written in other parts.
char* write_decimal(char* to, const Decimal& d) {
  constexpr std::uint64_t ZEROS = 0x3030'3030'3030'3030;
  const std::uint64_t first = d.digits / TEN_TO_16, rest = d.digits % TEN_TO_16;
  const std::uint64_t upper = eight_digits(rest / TEN_TO_8), lower = eight_digits(rest % TEN_TO_8);
  const int size = DIGITS - (lower != 0 ? zeros_behind(lower) : 8 + zeros_behind(upper));
  const Wide text = Wide(lower + ZEROS) << 72 | Wide(upper + ZEROS) << 8 | ('0' + first);  // all but the last
  const char last = static_cast<char>('0' + (lower >> 56));
  if (d.exponent >= -4 && d.exponent < 0) {
    std::memcpy(to, "0.0000", 6);
    to += 1 - d.exponent;
    write_sixteen(to, text);
    to[DIGITS - 1] = last;
    return to + size;
  }
  const int whole = d.exponent < 0 ? 1 : d.exponent + 1;  // digits before the point, at most 16
  write_sixteen(to, text);
  if (size > whole) {
    to[whole] = '.';
    write_sixteen(to + whole + 1, whole < DIGITS - 1 ? text >> 8 * whole : 0);
    to[DIGITS] = last;
    to += size + 1;
  } else {
    to += whole;
  }
  if (d.exponent < 0) {
    to[0] = 'e';
    to[1] = '-';
    to[2] = static_cast<char>('0' - d.exponent / 10);
    to[3] = static_cast<char>('0' - d.exponent % 10);
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
  if (!(size >= LEAST && size < MOST))
    return std::to_chars(to, to + NUMBER_ROOM, x, std::chars_format::general, DIGITS).ptr;
  *to = '-';
  to += x < 0;  // no branch that would be wrong half of the time
  return write_decimal(to, decimal(size));
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

}  // namespace bounding_arcs_tool
