// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Roots of polynomials over exact rings, where intervals and double-doubles do not tell them.

#ifndef CGAL_BOUNDING_ARCS_2_POLYNOMIAL_EXACT_ISOLATION_H
#define CGAL_BOUNDING_ARCS_2_POLYNOMIAL_EXACT_ISOLATION_H

#include <CGAL/Bounding_arcs_2/polynomial/Bernstein_polynomial.h>

#include <CGAL/number_utils.h>

#include <boost/container/small_vector.hpp>

#include <cmath>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

namespace internal {
/// A list with room for the cuts of most curves without an allocation.
template <class T> using Short_list = boost::container::small_vector<T, 8>;
}  // namespace internal

}  // namespace CGAL::Bounding_arcs

namespace CGAL::Bounding_arcs::internal {

// Roots that round to a double at most END_WIDTH away from 0 or 1 count as these ends. It is the spacing of doubles
// below 1, so that 1 - t is as sharp a parameter as t. Ten times wider would lose breaks at the finest real detail.
inline constexpr double END_WIDTH = 0x1p-53;

/// The roots of a polynomial in (0,1).
struct Unit_roots {
  bool is_zero = false;      ///< the polynomial vanishes identically; then `roots` is empty
  Short_list<double> roots;  ///< strictly increasing, each the double nearest to a root
};

/// An open interval with exactly one root and the sign just right of its lower end.
struct Root_cell {
  double lo, hi;
  int lower_sign;
};

/// Cells with a root each, and roots that are doubles.
struct Isolated_roots {
  std::vector<Root_cell> cells;
  Short_list<double> roots;
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

/// The roots and signs of an exact polynomial.
template <class Ring> class Exact_isolation {
 public:
  using Polynomial = Bernstein_polynomial<Ring>;

  explicit Exact_isolation(Polynomial p) : p_(std::move(p)) {}

  [[nodiscard]] bool is_zero() const { return sign_variations(p_).first == 0; }
  /// The sign at hi + lo in [0,1].
  [[nodiscard]] int sign(double hi, double lo) const {
    const Integer_parameter<Ring> t(hi, lo, integer_scale(hi, lo));
    return static_cast<int>(CGAL::sign(p_.homogeneous_value(t.t, t.s)));
  }
  /// Adds the roots between lo and hi.
  void isolate(double lo, double hi, Isolated_roots& found) const {
    isolate(restricted_exactly(p_, lo, hi), lo, hi, found);
  }

 private:
  // q is the exact polynomial over [lo, hi], up to a positive factor. Between neighbouring doubles, which is where
  // multiple roots end, two or more variations on one side of the middle stand for one root.
  void isolate(const Polynomial& q, double lo, double hi, Isolated_roots& found) const {
    const Sign_variations v = sign_variations(q);
    if (v.most() == 0 || hi <= END_WIDTH || lo >= 1 - END_WIDTH) return;
    if (v.most() == 1) {
      found.cells.push_back({lo, hi, v.first});
      return;
    }
    const double middle = lo + (hi - lo) / 2;
    const bool are_neighbours = std::nextafter(lo, 1.0) == hi;
    const bool is_half = are_neighbours || middle - lo == hi - middle;
    const auto [left, right] =
        is_half ? q.halves() : std::pair(restricted_exactly(p_, lo, middle), restricted_exactly(p_, middle, hi));
    if (CGAL::is_zero(right.scaled_coefficients().front())) found.roots.push_back(middle);
    if (!are_neighbours) {
      isolate(left, lo, middle, found);
      isolate(right, middle, hi, found);
      return;
    }
    if (sign_variations(left).most() > 0) found.roots.push_back(lo);
    if (sign_variations(right).most() > 0) found.roots.push_back(hi);
  }

  Polynomial p_;
};

/// An Exact_isolation over any ring.
struct Root_oracle {
  std::function<bool()> is_zero;
  std::function<int(double hi, double lo)> sign;
  std::function<void(double lo, double hi, Isolated_roots&)> isolate;

  template <class Ring> explicit Root_oracle(Bernstein_polynomial<Ring> polynomial) {
    const auto p = std::make_shared<const Exact_isolation<Ring>>(std::move(polynomial));
    is_zero = [p] { return p->is_zero(); };
    sign = [p](double hi, double lo) { return p->sign(hi, lo); };
    isolate = [p](double lo, double hi, Isolated_roots& found) { p->isolate(lo, hi, found); };
  }
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
