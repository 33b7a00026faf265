// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The conditions under which control points, knots and weights make a B-spline curve, and the unwrapping of periodic
// knots. Every function throws std::invalid_argument with the index at which a condition fails.

#ifndef CGAL_BOUNDING_ARCS_2_CURVE_INTERNAL_B_SPLINE_CHECKS_H
#define CGAL_BOUNDING_ARCS_2_CURVE_INTERNAL_B_SPLINE_CHECKS_H

#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/number/half_ulp.h>
#include <CGAL/Bounding_arcs_2/number/strict_math.h>

#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

[[noreturn]] inline void throw_invalid(const std::string& what) { throw std::invalid_argument(what); }

inline void check_b_spline_counts(int degree, std::size_t points, bool periodic) {
  if (degree < 1) throw_invalid(expected("degree", "at least 1", degree));
  const std::size_t least = periodic ? 2 : static_cast<std::size_t>(degree) + 1;
  if (points < least)
    throw_invalid(expected("control points",
                           "at least " + text_of(least) + " of a " +
                               (periodic ? "periodic B-spline" : "B-spline of degree " + text_of(degree)),
                           points));
}

template <class NT> void check_b_spline_weights(std::size_t points, const std::vector<NT>& weights) {
  if (!weights.empty() && weights.size() != points)
    throw_invalid(expected("weights", text_of(points) + ", one a control point", weights.size()));
  for (std::size_t i = 0; i < weights.size(); ++i)
    if (!(weights[i] > NT(0)))
      throw_invalid(expected("weight " + text_of(i), "a number above 0", text_of(weights[i], "another one")));
}

template <class NT> void check_knot_order(const std::vector<NT>& knots) {
  for (std::size_t i = 1; i < knots.size(); ++i)
    if (!(knots[i - 1] <= knots[i]))
      throw_invalid(expected("knot " + text_of(i), "no less than knot " + text_of(i - 1), text_of(knots[i], "less")));
}

// Runs of equal knots: those with low < knot < high may be as long as `inside`, others as long as `elsewhere`. Knot i
// was given as number given(i).
template <class NT, class Given>
void check_multiplicities(const std::vector<NT>& knots, const NT& low, const NT& high, std::size_t inside,
                          std::size_t elsewhere, const Given& given) {
  for (std::size_t i = 0, run = 0; i < knots.size(); ++i) {
    run = i > 0 && knots[i] == knots[i - 1] ? run + 1 : 1;
    const bool is_inside = low < knots[i] && knots[i] < high;
    const std::size_t most = is_inside ? inside : elsewhere;
    if (run > most)
      throw_invalid(expected(
          "knot " + text_of(given(i)),
          "at most " + text_of(most) + " equal ones" + (most == inside ? ", as the curve falls apart with more" : ""),
          run));
  }
}

template <class NT> void check_b_spline_knots(int degree, std::size_t points, const std::vector<NT>& knots) {
  const std::size_t d = static_cast<std::size_t>(degree);
  if (knots.size() != points + d + 1)
    throw_invalid(expected("knots", text_of(points + d + 1) + " (control points + degree + 1)", knots.size()));
  check_knot_order(knots);
  if (!(knots[d] < knots[points]))
    throw_invalid(expected("knots", "knot " + text_of(d) + " below knot " + text_of(points), "an empty domain"));
  check_multiplicities(knots, knots[d], knots[points], d, d + 1, [](std::size_t i) { return i; });
}

// Unwrapped knots that repeat as reals are rounded to double one by one: each of four numbers is off by at most
// u max|t|, and three subtractions of numbers below 2 max|t| add at most 2u max|t| each.
// Tenfold, knots that were meant to differ by that little pass as periodic; a tenth, decimal files are refused.
constexpr double UNWRAPPED_KNOT_SLACK = 10 * HALF_ULP;

// Throws unless knots[i + n] - knots[i] is the period for every i, within the slack.
template <class NT> void check_repetition(std::size_t n, std::size_t d, const std::vector<NT>& knots) {
  const NT period = knots[d + n] - knots[d];
  const NT low = -knots.front();
  const NT& high = knots.back();
  const NT slack = NT(UNWRAPPED_KNOT_SLACK) * (low < high ? high : low);
  for (std::size_t i = 0; i + n < knots.size(); ++i) {
    const NT difference = (knots[i + n] - knots[i]) - period;
    if (!(-slack <= difference && difference <= slack))
      throw_invalid(expected("knots", "knots " + text_of(i) + " and " + text_of(i + n) + " one period apart",
                             text_of(knots[i + n] - knots[i], "another distance")));
  }
}

// The n + 2 degree + 1 unwrapped knots from one period (n + 1) or from the unwrapped form. The outer ones are
// differences to the ends of the period, so that knots equal to an end stay equal to it in rounded arithmetic too.
template <class NT> std::vector<NT> unwrapped_knots(int degree, std::size_t n, std::vector<NT> knots) {
  const std::size_t d = static_cast<std::size_t>(degree);
  if (knots.size() != n + 1 && knots.size() != n + 2 * d + 1)
    throw_invalid(expected("knots",
                           text_of(n + 1) + " (control points + 1, one period) or " + text_of(n + 2 * d + 1) +
                               " (control points + 2 degree + 1)",
                           knots.size()));
  check_knot_order(knots);
  const bool is_unwrapped = knots.size() != n + 1;
  const std::size_t start = is_unwrapped ? d : 0;
  if (!(knots[start] < knots[start + n])) throw_invalid(expected("knots", "a period above 0", "an empty domain"));
  if (is_unwrapped) check_repetition(n, d, knots);
  std::vector<NT> all(n + 2 * d + 1, NT(0));
  for (std::size_t i = 0; i <= n; ++i) all[d + i] = knots[start + i];
  for (std::size_t j = 1; j <= d; ++j) {
    all[d - j] = NT(all[d] - (all[d + n] - all[d + n - j]));
    all[d + n + j] = NT(all[d + n] + (all[d + j] - all[d]));
  }
  check_multiplicities(all, all.front(), all.back(), d, d,
                       [&](std::size_t i) { return is_unwrapped ? i : (i + (n - d % n)) % n; });
  return all;
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
