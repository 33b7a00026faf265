// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The curve phi(t) = psi(s) in [0,1]^2, phi and psi fractions: where two pieces of one curve run together, one of whose
// parameters is phi(t) and psi(s).  Cut where phi or psi turns back, it is monotone in boxes, and known by its ends:
//
//   +-----+-------+   an arc comes in through the left or the lower side of a box and leaves through the upper or the
//   |    /|       |   right one (or with both exchanged, where one of phi and psi falls); arcs do not meet, so that
//   |---/-|--/----|   those that come in and those that leave, in order along the sides, belong to each other.
//   +-----+-------+   A corner that is both is an isolated point.

#ifndef BOUNDING_ARCS_LIBRARY_QUERY_LEVEL_ARCS_H
#define BOUNDING_ARCS_LIBRARY_QUERY_LEVEL_ARCS_H

#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/query/Intersections_2.h>
#include "../polynomial/Real_root.h"
#include "Fibre.h"

#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// phi = a/b and psi = c/d with h = a d - b c, up to a constant factor.
struct Level_functions {
  Univariate a, b, c, d;
};

/// Such functions for h, which is of rank two as a matrix of coefficients: two columns that are no multiples of each
/// other are a and b, and all columns are their combinations.
/// \throws std::logic_error when it is not, which common factors of two curves cannot be
[[nodiscard]] inline Level_functions level_functions(const Bivariate& h) {
  const auto at = [&h](int i, int j) { return coefficient(coefficient(h, j), i); };
  const auto minor = [&at](int i0, int i1, int j0, int j1) {
    return Integer(Integer(at(i0, j0) * at(i1, j1)) - Integer(at(i1, j0) * at(i0, j1)));
  };
  const int rows = CGAL::degree(h, 0) + 1, columns = h.degree() + 1;
  for (int j0 = 0; j0 < columns; ++j0)
    for (int j1 = j0 + 1; j1 < columns; ++j1)
      for (int i0 = 0; i0 < rows; ++i0)
        for (int i1 = i0 + 1; i1 < rows; ++i1) {
          const Integer determinant = minor(i0, i1, j0, j1);
          if (determinant == Integer(0)) continue;
          std::vector<Integer> c, d;
          for (int j = 0; j < columns; ++j) {
            d.push_back(minor(i0, i1, j, j1));
            c.push_back(Integer(-minor(i0, i1, j0, j)));
          }
          const Level_functions r{coefficient(h, j0), coefficient(h, j1), polynomial(c), polynomial(d)};
          if (crossed(r.a, r.b, r.c, r.d) == h * Univariate(determinant)) return r;
          throw std::logic_error(
              expected("common component of two curves", "parameters that tell each other", "independent ones"));
        }
  throw std::logic_error(expected("common component of two curves", "a curve", "one point"));
}

/// One parameter cut at 0, at 1 and where the function a/b has its extremes.
class Monotone_parts {
 public:
  Monotone_parts(const Univariate& a, const Univariate& b)
      : slope_(CGAL::differentiate(a) * b - a * CGAL::differentiate(b)), cuts_(odd_part(slope_)) {
    const auto with = [this](int num) {
      const Univariate factor = polynomial<Integer>({Integer(-num), Integer(1)});
      if (sign_at_dyadic(cuts_, Integer(num), 0) != 0) cuts_ = cuts_ * factor;
    };
    with(0);
    with(1);
    roots_ = Unit_isolation(cuts_).roots();
  }
  /// The polynomial with all cuts as its roots in [0,1].
  [[nodiscard]] const Univariate& cuts() const { return cuts_; }
  [[nodiscard]] std::size_t size() const { return roots_.size() - 1; }
  [[nodiscard]] Real_root& cut(std::size_t i) { return roots_[i]; }

  /// Whether the function rises or falls, at its infinite values from one end of the line to the other: +1 or -1.
  [[nodiscard]] int direction(std::size_t part) {
    Real_root &low = roots_[part], &high = roots_[part + 1];
    while (low.upper() >= high.lower()) {
      low.refine();
      high.refine();
    }
    // Roots of even multiplicity are few; one place between is none of them.
    for (int n = 1;; ++n)
      if (const int s = sign_at(low.upper() + (high.lower() - low.upper()) / Exact_rational(n + 1))) return s;
  }
  /// 2 i at the cut i, and 2 i + 1 between the cuts i and i + 1.
  [[nodiscard]] int place(Real_root& t) {
    for (std::size_t i = 0;; ++i) {
      const int s = t.compare(roots_[i]);
      if (s <= 0) return static_cast<int>(2 * i) + s;
    }
  }

 private:
  [[nodiscard]] int sign_at(const Exact_rational& t) const { return static_cast<int>(CGAL::sign(value_at(slope_, t))); }
  Univariate slope_, cuts_;
  std::vector<Real_root> roots_;
};

/// A point of the curve with the places of its parameters among the cuts.
struct Level_point {
  Real_root t, s;
  int t_place, s_place;
};
struct Level_arc {
  Level_point from, to;
};

class Level_arcs {
 public:
  explicit Level_arcs(const Level_functions& f)
      : h_(primitive_part(crossed(f.a, f.b, f.c, f.d))), t_(f.a, f.b), s_(f.c, f.d) {
    add_points();
    for (std::size_t i = 0; i < t_.size(); ++i)
      for (std::size_t j = 0; j < s_.size(); ++j) trace(static_cast<int>(2 * i), static_cast<int>(2 * j));
  }
  /// Returns the arcs, each from the lower to the higher t.
  [[nodiscard]] std::vector<Level_arc>& arcs() { return arcs_; }
  /// Returns the points that are on no arc.
  [[nodiscard]] std::vector<Level_point> isolated() {
    std::vector<Level_point> r;
    for (std::size_t i = 0; i < points_.size(); ++i)
      if (!is_on_arc_[i]) r.push_back(points_[i]);
    return r;
  }

 private:
  // All points whose t or s is a cut.
  void add_points() {
    const Bivariate h_by_t = CGAL::swap(h_, 0, 1);
    for (auto& [t, s] : solutions(t_.cuts(), h_)) {
      const int t_place = t_.place(t), s_place = s_.place(s);
      points_.push_back({t, s, t_place, s_place});
    }
    for (auto& [s, t] : solutions(s_.cuts(), h_by_t)) {
      const int t_place = t_.place(t), s_place = s_.place(s);
      if (t_place % 2 != 0) points_.push_back({t, s, t_place, s_place});
    }
    is_on_arc_.assign(points_.size(), false);
  }
  static std::vector<std::pair<Real_root, Real_root>> solutions(const Univariate& m, const Bivariate& h) {
    std::vector<std::pair<Real_root, Real_root>> r;
    for (const Fibre& fibre : common_fibres(m, h, Bivariate(Univariate(Integer(0))))) {
      const Univariate all = CGAL::resultant(CGAL::swap(fibre.h, 0, 1), CGAL::swap(Bivariate(fibre.m), 0, 1));
      const std::vector<Real_root> candidates = unit_roots(all);
      for (const Real_root& t : Unit_isolation(fibre.m).roots())
        for (Fibre_root& s : Fibre_isolation(t, fibre.h).roots()) r.emplace_back(t, matching(s, candidates));
    }
    return r;
  }
  // The one of the candidates that is the root.
  static Real_root matching(Fibre_root& s, std::vector<Real_root> candidates) {
    for (;; s.refine()) {
      if (s.is_dyadic()) return s.dyadic();
      std::vector<Real_root> left;
      for (Real_root& c : candidates) {
        if (c.upper() < s.lower() || s.upper() < c.lower()) continue;
        c.refine();
        left.push_back(c);
      }
      if (left.size() == 1) return left.front();
      candidates = std::move(left);
    }
  }

  // The points on the sides of a box with the lower left corner at these places, in order along each of two sides.
  void trace(int t, int s) {
    const bool rises =
        t_.direction(static_cast<std::size_t>(t / 2)) * s_.direction(static_cast<std::size_t>(s / 2)) > 0;
    const int entry = rises ? s : s + 2, exit = rises ? s + 2 : s;
    const auto in = along(t, entry, {t, s}, rises), out = along(t + 2, exit, {t, s}, rises);
    if (in.size() != out.size()) throw std::logic_error(expected("overlap of two pieces", "two ends", "one"));
    for (std::size_t k = 0; k < in.size(); ++k) {
      if (in[k] == out[k]) continue;
      is_on_arc_[in[k]] = is_on_arc_[out[k]] = true;
      arcs_.push_back({points_[in[k]], points_[out[k]]});
    }
  }
  struct Box {
    int t, s;
  };
  // First the left side towards the entry, then that side to the right; or the exit to the right, then the right side.
  std::vector<std::size_t> along(int t_side, int s_side, const Box& box, bool rises) {
    std::vector<std::size_t> on;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Level_point& p = points_[i];
      const bool is_in_box =
          box.t <= p.t_place && p.t_place <= box.t + 2 && box.s <= p.s_place && p.s_place <= box.s + 2;
      if (is_in_box && (p.t_place == t_side || p.s_place == s_side)) on.push_back(i);
    }
    // On such a pair of sides, t never falls, and s goes one way only.
    std::sort(on.begin(), on.end(), [&](std::size_t i, std::size_t j) {
      if (const int c = points_[i].t.compare(points_[j].t)) return c < 0;
      const int c = points_[i].s.compare(points_[j].s);
      return rises ? c > 0 : c < 0;
    });
    return on;
  }

  Bivariate h_;
  Monotone_parts t_, s_;
  std::vector<Level_point> points_;
  std::vector<bool> is_on_arc_;
  std::vector<Level_arc> arcs_;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
