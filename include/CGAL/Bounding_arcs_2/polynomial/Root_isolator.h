// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// All distinct roots of a polynomial in (0,1), each as the nearest double, by Descartes' rule of signs and bisection.
//   interval arithmetic   proves cells free of roots or with exactly one; what it cannot decide goes to
//   exact arithmetic      the same rule on the exact coefficients restricted to the undecided cell;
//   double-double numbers with error bounds round each root, exact signs where the bound does not decide.
// Invariant: a root reported is correctly rounded, so that a root shared by two polynomials is the same double.

#ifndef CGAL_BOUNDING_ARCS_2_POLYNOMIAL_ROOT_ISOLATOR_H
#define CGAL_BOUNDING_ARCS_2_POLYNOMIAL_ROOT_ISOLATOR_H

#include <CGAL/Bounding_arcs_2/number/Double_double.h>
#include <CGAL/Bounding_arcs_2/polynomial/Bernstein_polynomial.h>
#include <CGAL/Bounding_arcs_2/polynomial/Interval_isolation.h>

#include <CGAL/FPU.h>
#include <CGAL/number_utils.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

/// A list with room for the cuts of most curves without an allocation.
template <class T> using Short_list = boost::container::small_vector<T, 8>;

/// The roots of a polynomial in (0,1).
struct Unit_roots {
  bool is_zero = false;      ///< the polynomial vanishes identically; then `roots` is empty
  Short_list<double> roots;  ///< strictly increasing, each the double nearest to a root
};

/// A parameter and its complement to 1, both multiplied by the same power of two that makes them integers.
template <class Ring> struct Integer_parameter {
  Ring t, s;

  // t = hi + lo in [0,1]
  Integer_parameter(double hi, double lo, double scale) : t(Ring(hi * scale) + Ring(lo * scale)), s(Ring(scale) - t) {}
};

// The least power of two that makes both numbers of [-1,1] integers.
inline double integer_scale(double a, double b) {
  double scale = 1;
  while (a * scale != std::floor(a * scale) || b * scale != std::floor(b * scale)) scale *= 2;
  return scale;
}

template <class Ring>
Bernstein_polynomial<Ring> restricted_exactly(const Bernstein_polynomial<Ring>& p, double lo, double hi) {
  if (lo == 0 && hi == 1) return p;
  const double scale = integer_scale(lo, hi);
  const Integer_parameter<Ring> a(lo, 0, scale), b(hi, 0, scale);
  return p.restricted(a.t, a.s, b.t, b.s);
}

/// Isolates and rounds the roots of one polynomial.
template <class Polynomial> class Root_isolator {
  using Ring = typename Polynomial::Ring;
  using Exact_polynomial = Bernstein_polynomial<Ring>;

 public:
  explicit Root_isolator(Polynomial& p) : p_(p) {}

  // In rounding to nearest.
  Unit_roots operator()() {
    const Interval_isolation proven = isolate_in_intervals();
    if (!proven.is_nonzero && sign_variations(p_.exact()).first == 0) return {true, {}};
    cells_ = proven.cells;
    for (const auto& [lo, hi] : proven.undecided) isolate_exactly(restricted_exactly(p_.exact(), lo, hi), lo, hi);
    for (const Root_cell& cell : cells_) roots_.push_back(rounded_root(cell));
    std::sort(roots_.begin(), roots_.end());
    roots_.erase(std::unique(roots_.begin(), roots_.end()), roots_.end());
    const auto is_end = [](double t) { return t <= END_WIDTH || t >= 1 - END_WIDTH; };
    roots_.erase(std::remove_if(roots_.begin(), roots_.end(), is_end), roots_.end());
    return {false, std::move(roots_)};
  }

 private:
  // Newton's method proposes at most so many doubles for a root before bisection takes over, each after at most so
  // many steps; it settles in about six from a proven cell, later ones only gain when the proof failed by one double.
  static constexpr int MOST_PROPOSALS = 5, MOST_NEWTON_STEPS = 40;
  // A step this much smaller than t leaves an error below one spacing of doubles after the double-double step.
  static constexpr double LAST_STEP = 0x1p-26;

  Interval_isolation isolate_in_intervals() {
    const Protect_FPU_rounding<true> upward;
    return Interval_isolation(p_.enclosure());
  }

  // q is the exact polynomial over [lo, hi], up to a positive factor. Between neighbouring doubles, which is where
  // multiple roots end, two or more variations on one side of the middle stand for one root.
  void isolate_exactly(const Exact_polynomial& q, double lo, double hi) {
    const Sign_variations v = sign_variations(q);
    if (v.most() == 0 || hi <= END_WIDTH || lo >= 1 - END_WIDTH) return;
    if (v.most() == 1) {
      cells_.push_back({lo, hi, v.first});
      return;
    }
    const double middle = lo + (hi - lo) / 2;
    const bool are_neighbours = std::nextafter(lo, 1.0) == hi;
    const bool is_half = are_neighbours || middle - lo == hi - middle;
    const auto [left, right] =
        is_half ? q.halves()
                : std::pair(restricted_exactly(p_.exact(), lo, middle), restricted_exactly(p_.exact(), middle, hi));
    if (CGAL::is_zero(right.scaled_coefficients().front())) roots_.push_back(middle);
    if (!are_neighbours) {
      isolate_exactly(left, lo, middle);
      isolate_exactly(right, middle, hi);
      return;
    }
    if (sign_variations(left).most() > 0) roots_.push_back(lo);
    if (sign_variations(right).most() > 0) roots_.push_back(hi);
  }

  // The sign at hi + lo, lo at most half the spacing of doubles at hi.
  int sign_at(double hi, double lo = 0) {
    if (const std::optional<int> s = p_.fine()(Double_double(hi, lo, 0)).sign()) return *s;
    const Integer_parameter<Ring> t(hi, lo, integer_scale(hi, lo));
    return static_cast<int>(CGAL::sign(p_.exact().homogeneous_value(t.t, t.s)));
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
    const double next = t - p_.fine()(Double_double(t)).hi / slope_(t);
    return std::isfinite(next) ? next : t;
  }

  void prepare_doubles() {
    if (has_doubles_) return;
    std::vector<double> c;
    for (const Double_double& x : p_.fine().scaled_coefficients()) c.push_back(x.hi);
    rounded_ = Bernstein_polynomial<double>::from_scaled(std::move(c));
    slope_ = rounded_.derivative();
    has_doubles_ = true;
  }

  Polynomial& p_;
  std::vector<Root_cell> cells_;
  Short_list<double> roots_;
  Bernstein_polynomial<double> rounded_, slope_;
  bool has_doubles_ = false;
};

// The roots in (0,1) of a polynomial given in three number types, the last two only asked for when needed: enclosure()
// over intervals, called in upward rounding, fine() over Double_double and exact() over a ring with exact signs.
template <class Polynomial> Unit_roots isolate_layered_roots(Polynomial& p) {
  const Protect_FPU_rounding<true> nearest(CGAL_FE_TONEAREST);
  return Root_isolator<Polynomial>(p)();
}

}  // namespace CGAL::Bounding_arcs

#endif
