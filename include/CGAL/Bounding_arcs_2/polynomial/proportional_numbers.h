// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers up to a common positive factor, which moves no root: as integers, or as double-doubles of moderate size.

#ifndef CGAL_BOUNDING_ARCS_2_POLYNOMIAL_PROPORTIONAL_NUMBERS_H
#define CGAL_BOUNDING_ARCS_2_POLYNOMIAL_PROPORTIONAL_NUMBERS_H

#include <CGAL/Bounding_arcs_2/number/Double_double.h>

#include <CGAL/Fraction_traits.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

namespace internal {
/// Integers and the least common denominator of the fractions that they are the numerators of.
template <class Integer> struct Cleared_numbers {
  std::vector<Integer> numbers;
  Integer denominator{1};
};
}  // namespace internal

template <class Fraction, class Integer = typename Fraction_traits<Fraction>::Numerator_type>
[[nodiscard]] internal::Cleared_numbers<Integer> cleared(const std::vector<Fraction>& fractions) {
  internal::Cleared_numbers<Integer> r;
  std::vector<Integer> denominators;
  for (const Fraction& x : fractions) {
    Integer numerator, denominator;
    typename Fraction_traits<Fraction>::Decompose()(x, numerator, denominator);
    r.numbers.push_back(numerator);
    denominators.push_back(denominator);
    if (denominator != r.denominator)
      r.denominator *= CGAL::integral_division(denominator, Integer(CGAL::gcd(r.denominator, denominator)));
  }
  for (std::size_t i = 0; i < fractions.size(); ++i)
    if (denominators[i] != r.denominator) r.numbers[i] *= CGAL::integral_division(r.denominator, denominators[i]);
  return r;
}

namespace internal {
/// Integers proportional to given rationals, by a positive factor; other exact numbers stay what they are.
template <class Exact, class IsFraction = typename Fraction_traits<Exact>::Is_fraction> struct Proportional_integers {
  using Ring = Exact;
  static std::vector<Ring> make(std::vector<Exact> a) { return a; }
};
/// Fractions over their common denominator.
template <class Exact> struct Proportional_integers<Exact, Tag_true> {
  using Ring = typename Fraction_traits<Exact>::Numerator_type;
  static std::vector<Ring> make(const std::vector<Exact>& a) { return cleared(a).numbers; }
};

// x 2^-exponent, with the slack for what underflow takes.
inline Double_double scaled_down(const Double_double& x, int exponent) {
  const double hi = std::ldexp(x.hi, -exponent), lo = std::ldexp(x.lo, -exponent);
  const bool is_exact = std::ldexp(hi, exponent) == x.hi && std::ldexp(lo, exponent) == x.lo;
  return {hi, lo, is_exact ? 0 : Double_double::UNDERFLOW_SLACK};
}

// Scales numbers, not all zero, by a common power of two to a largest one about 1.
inline void normalize(std::vector<Double_double>& a) {
  double largest = 0;
  for (const Double_double& x : a) largest = std::max(largest, std::abs(x.hi));
  if (largest == 0) return;
  const int exponent = std::ilogb(largest) + 1;
  for (Double_double& x : a) x = scaled_down(x, exponent);
}

// Scales exact numbers so, too, also those outside the range of doubles.
template <class Exact> std::vector<Double_double> normalized(std::vector<Exact> a) {
  const auto largest = [&a] {
    double m = 0;
    for (const Exact& x : a) {
      const std::pair<double, double> i = CGAL::to_interval(x);
      m = std::max({m, std::abs(i.first), std::abs(i.second)});
    }
    return m;
  };
  if (std::all_of(a.begin(), a.end(), [](const Exact& x) { return CGAL::is_zero(x); }))
    return std::vector<Double_double>(a.size());
  constexpr double STEP = 0x1p900;
  double m = largest();
  while (m < 1 / STEP || m > STEP) {
    const Exact factor(m > STEP ? 1 / STEP : STEP);
    for (Exact& x : a) x = Exact(x * factor);
    m = largest();
  }
  const Exact factor(std::ldexp(1.0, -std::ilogb(m) - 1));
  std::vector<Double_double> r;
  r.reserve(a.size());
  for (const Exact& x : a) r.push_back(to_double_double(Exact(x * factor)));
  return r;
}
}  // namespace internal

}  // namespace CGAL::Bounding_arcs

#endif
