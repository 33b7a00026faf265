// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The first pass of root isolation: Descartes' rule of signs and bisection in interval arithmetic.
// Invariant: every root in (0,1), but those next to an end, lies in a cell or in an undecided span.

#ifndef BOUNDING_ARCS_LIBRARY_POLYNOMIAL_INTERVAL_ISOLATION_H
#define BOUNDING_ARCS_LIBRARY_POLYNOMIAL_INTERVAL_ISOLATION_H

#include <CGAL/Bounding_arcs_2/number/Bracket.h>
#include <CGAL/Bounding_arcs_2/number/Double_double.h>
#include <CGAL/Bounding_arcs_2/polynomial/Bernstein_polynomial.h>
#include <CGAL/Bounding_arcs_2/polynomial/Exact_isolation.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

using Unprotected_interval = Interval_nt<false>;

// The enclosure [hi + lo - err, hi + lo + err]; in upward rounding.
inline Unprotected_interval enclosure(const Double_double& x) {
  return Unprotected_interval(x.hi) + Unprotected_interval(x.lo) + Unprotected_interval(-x.err, x.err);
}

inline int certain_sign(const Unprotected_interval& x) { return x.inf() > 0 ? 1 : x.sup() < 0 ? -1 : 0; }
inline bool is_certainly_zero(const Unprotected_interval& x) { return x.inf() == 0 && x.sup() == 0; }

inline Sign_variations sign_variation_bounds(const Bernstein_polynomial<Unprotected_interval>& p) {
  Sign_variations v;
  for (const Unprotected_interval& c : p.scaled_coefficients())
    if (!is_certainly_zero(c)) v.append(certain_sign(c));
  return v;
}

/// Proves cells free of roots or with one root in interval arithmetic, and lists those it cannot decide.
class Interval_isolation {
 public:
  using Polynomial = Bernstein_polynomial<Unprotected_interval>;
  std::vector<Root_cell> cells;
  std::vector<Bracket> undecided;  // parts of [0, 1]
  bool is_nonzero = false;         // proven not to vanish identically

  // In upward rounding.
  explicit Interval_isolation(Polynomial p) {
    const auto& c = p.scaled_coefficients();
    is_nonzero = std::any_of(c.begin(), c.end(), [](const Unprotected_interval& x) { return certain_sign(x) != 0; });
    if (is_nonzero) stack_.push_back({std::move(p), 0, 1, 0, 0});
    else undecided.push_back({0, 1});
    while (!stack_.empty()) {
      Cell cell = std::move(stack_.back());
      stack_.pop_back();
      process(cell);
    }
  }

 private:
  // A cell is cut at most to this width: its ends then are doubles with room for the uneven cuts.
  static constexpr double LEAST_WIDTH = 0x1p-40;
  static constexpr int MOST_UNDECIDED_LEVELS = 8, MOST_UNEVEN_CUTS = 2;
  static constexpr double UNEVEN_CUTS[] = {15.0 / 32, 19.0 / 32};

  struct Cell {
    Polynomial p;
    double lo, hi;
    int undecided_levels, uneven_cuts;
  };

  void process(Cell& cell) {
    const Sign_variations v = sign_variation_bounds(cell.p);
    if (v.most() == 0 || cell.hi <= END_WIDTH || cell.lo >= 1 - END_WIDTH) return;
    if (v.fewest == 1 && v.most() == 1) {
      cells.push_back({cell.lo, cell.hi, v.first});
      return;
    }
    const bool goes_on = v.fewest > 1 || (ends_are_certain(cell.p) && ++cell.undecided_levels <= MOST_UNDECIDED_LEVELS);
    if (!goes_on || !cut(cell)) undecided.push_back({cell.lo, cell.hi});
  }

  static bool ends_are_certain(const Polynomial& p) {
    const Unprotected_interval &a = p.scaled_coefficients().front(), &b = p.scaled_coefficients().back();
    return (certain_sign(a) != 0 || is_certainly_zero(a)) && (certain_sign(b) != 0 || is_certainly_zero(b));
  }

  // Cuts the cell where the polynomial is proven not to vanish, in the middle unless a root seems to lie there.
  // All ends are multiples of 2^-52, so that every operation on them is exact.
  bool cut(const Cell& cell) {
    if (cell.hi - cell.lo <= LEAST_WIDTH) return false;
    if (push(cell, cell.p.halves(), 0.5, cell.uneven_cuts)) return true;
    if (cell.uneven_cuts == MOST_UNEVEN_CUTS) return false;
    for (const double ratio : UNEVEN_CUTS) {
      const Unprotected_interval zero(0), one(1), t(ratio), s(1 - ratio);
      if (push(cell, {cell.p.restricted(zero, one, t, s), cell.p.restricted(t, s, one, zero)}, ratio,
               cell.uneven_cuts + 1))
        return true;
    }
    return false;
  }

  bool push(const Cell& cell, std::pair<Polynomial, Polynomial> parts, double ratio, int uneven_cuts) {
    if (certain_sign(parts.second.scaled_coefficients().front()) == 0) return false;
    const double at = cell.lo + (cell.hi - cell.lo) * ratio;
    stack_.push_back({std::move(parts.first), cell.lo, at, cell.undecided_levels, uneven_cuts});
    stack_.push_back({std::move(parts.second), at, cell.hi, cell.undecided_levels, uneven_cuts});
    return true;
  }

  std::vector<Cell> stack_;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
