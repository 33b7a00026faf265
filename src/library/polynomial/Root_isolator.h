// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// All distinct roots of a polynomial in (0,1), each as the nearest double, by Descartes' rule of signs and bisection.
//   interval arithmetic   proves cells free of roots or with exactly one; what it cannot decide goes to
//   exact arithmetic      the same rule on the exact coefficients restricted to the undecided cell;
//   double-double numbers with error bounds round each root, exact signs where the bound does not decide.
// Invariant: a root reported is correctly rounded, so that a root shared by two polynomials is the same double.

#ifndef BOUNDING_ARCS_LIBRARY_POLYNOMIAL_ROOT_ISOLATOR_H
#define BOUNDING_ARCS_LIBRARY_POLYNOMIAL_ROOT_ISOLATOR_H

#include <CGAL/Bounding_arcs_2/number/Double_double.h>
#include <CGAL/Bounding_arcs_2/polynomial/Bernstein_polynomial.h>
#include <CGAL/Bounding_arcs_2/polynomial/Exact_isolation.h>
#include "Interval_isolation.h"

#include <CGAL/FPU.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// A polynomial in three number types, each made when it is first asked for.
struct Layered_polynomial {
  std::function<Bernstein_polynomial<Unprotected_interval>()> enclosure;
  std::function<Bernstein_polynomial<Double_double>()> fine;
  std::function<Root_oracle()> exact;
};

/// Isolates and rounds the roots of one polynomial.
class Root_isolator {
 public:
  explicit Root_isolator(const Layered_polynomial& p) : p_(p) {}

  // In rounding to nearest.
  Unit_roots operator()() {
    const Interval_isolation proven = isolate_in_intervals();
    if (!proven.is_nonzero && exact().is_zero()) return {true, {}};
    Isolated_roots found{proven.cells, {}};
    for (const auto& [lo, hi] : proven.undecided) exact().isolate(lo, hi, found);
    Short_list<double>& roots = found.roots;
    for (const Root_cell& cell : found.cells) roots.push_back(rounded_root(cell));
    std::sort(roots.begin(), roots.end());
    roots.erase(std::unique(roots.begin(), roots.end()), roots.end());
    const auto is_end = [](double t) { return t <= END_WIDTH || t >= 1 - END_WIDTH; };
    roots.erase(std::remove_if(roots.begin(), roots.end(), is_end), roots.end());
    return {false, std::move(roots)};
  }

 private:
  // Newton's method proposes at most so many doubles for a root before bisection takes over, each after at most so
  // many steps; it settles in about six from a proven cell, later ones only gain when the proof failed by one double.
  static constexpr int MOST_PROPOSALS = 5, MOST_NEWTON_STEPS = 40;
  // A step this much smaller than t leaves an error below one spacing of doubles after the double-double step.
  static constexpr double LAST_STEP = 0x1p-26;

  const Bernstein_polynomial<Double_double>& fine() {
    if (!fine_) fine_ = p_.fine();
    return *fine_;
  }
  const Root_oracle& exact() {
    if (!exact_) exact_ = p_.exact();
    return *exact_;
  }
  Interval_isolation isolate_in_intervals() {
    const Protect_FPU_rounding<true> upward;
    return Interval_isolation(p_.enclosure());
  }

  // The sign at hi + lo, lo at most half the spacing of doubles at hi.
  int sign_at(double hi, double lo = 0) {
    if (const std::optional<int> s = fine()(Double_double(hi, lo, 0)).sign()) return *s;
    return exact().sign(hi, lo);
  }

  // The double nearest to the one root in the cell: a proposal is taken when the signs half-way to its neighbours
  // prove it. A root half-way between doubles rounds to the even one, as the sums below do.
  double rounded_root(Root_cell cell) {
    double guess = newton(cell);
    for (int attempt = 0; std::nextafter(cell.lo, 1.0) < cell.hi; ++attempt) {
      if (cell.hi <= END_WIDTH) return END_WIDTH;
      guess = inside(attempt < MOST_PROPOSALS ? corrected(guess) : cell.lo + (cell.hi - cell.lo) / 2, cell);
      const double below = std::nextafter(guess, 0.0), above = std::nextafter(guess, 1.0);
      const int s = cell.lower_sign * sign_at(guess, (below - guess) / 2);
      if (s == 0) return guess + (below - guess) / 2;
      if (s < 0) {
        cell.hi = guess;
        continue;
      }
      const int r = cell.lower_sign * sign_at(guess, (above - guess) / 2);
      if (r == 0) return guess + (above - guess) / 2;
      if (r < 0) return guess;
      cell.lo = guess;
    }
    const double half = (cell.hi - cell.lo) / 2;
    const int s = cell.lower_sign * sign_at(cell.lo, half);
    return s == 0 ? cell.lo + half : s < 0 ? cell.lo : cell.hi;
  }

  // A double strictly between the ends, which are no neighbours; none smaller than what counts as the end 0.
  static double inside(double t, const Root_cell& cell) {
    return std::max({std::nextafter(cell.lo, 1.0), END_WIDTH, std::min(std::nextafter(cell.hi, 0.0), t)});
  }

  // A guess by Newton's method in doubles, kept in a shrinking bracket.
  double newton(Root_cell bracket) {
    prepare_doubles();
    double t = bracket.lo + (bracket.hi - bracket.lo) / 2;
    for (int step = 0; step < MOST_NEWTON_STEPS; ++step) {
      const double value = rounded_(t), change = value / slope_(t), next = t - change;
      (value * bracket.lower_sign > 0 ? bracket.lo : bracket.hi) = t;
      const bool is_inside = bracket.lo < next && next < bracket.hi;
      t = is_inside ? next : bracket.lo + (bracket.hi - bracket.lo) / 2;
      if (is_inside && std::abs(change) <= LAST_STEP * t) break;
    }
    return t;
  }

  // One step of Newton's method with the value in double-double numbers, good to nearly the square of the error.
  double corrected(double t) {
    const double next = t - fine()(Double_double(t)).hi / slope_(t);
    return std::isfinite(next) ? next : t;
  }

  void prepare_doubles() {
    if (has_doubles_) return;
    std::vector<double> c;
    for (const Double_double& x : fine().scaled_coefficients()) c.push_back(x.hi);
    rounded_ = Bernstein_polynomial<double>::from_scaled(std::move(c));
    slope_ = rounded_.derivative();
    has_doubles_ = true;
  }

  const Layered_polynomial& p_;
  std::optional<Bernstein_polynomial<Double_double>> fine_;
  std::optional<Root_oracle> exact_;
  Bernstein_polynomial<double> rounded_, slope_;
  bool has_doubles_ = false;
};

/// The roots in (0,1) of a polynomial, whose enclosure is asked for in upward rounding.
[[nodiscard]] inline Unit_roots isolate_roots(const Layered_polynomial& p) {
  const Protect_FPU_rounding<true> nearest(CGAL_FE_TONEAREST);
  return Root_isolator(p)();
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
