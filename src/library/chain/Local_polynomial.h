// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A curve piece as a polynomial (or quotient of polynomials) of one parameter u in [0, 1], seen from a point of its
// own: what fitting and bounding an arc works on, in double.

#ifndef BOUNDING_ARCS_LIBRARY_CHAIN_LOCAL_POLYNOMIAL_H
#define BOUNDING_ARCS_LIBRARY_CHAIN_LOCAL_POLYNOMIAL_H

#include <CGAL/Bounding_arcs_2/frame/Taylor_table.h>

#include <cmath>
#include <cstddef>

namespace CGAL::Bounding_arcs::internal {

/// q(u) = sum m_k u^k / sum w_k u^k, or without weights sum m_k u^k.  With weights w_0 = 1.
struct Local_polynomial {
  Coefficients<Xy<double>> m;
  Coefficients<double> w;

  [[nodiscard]] bool is_rational() const { return !w.empty(); }

  [[nodiscard]] Xy<double> operator()(double u) const {
    const Xy<double> p = horner(m, u);
    return w.empty() ? p : (1 / horner(w, u)) * p;
  }

  [[nodiscard]] Xy<double> derivative(double u) const {
    const Xy<double> d = slope(m, u);
    if (w.empty()) return d;
    const double weight = horner(w, u);
    return (1 / weight) * (d - (slope(w, u) / weight) * horner(m, u));
  }

  /// The piece [u0, u0 + h], seen from its own start.
  [[nodiscard]] Local_polynomial piece(double u0, double h) const {
    Local_polynomial p{shifted(m, u0, h), shifted(w, u0, h)};
    p.start_at_origin();
    return p;
  }

  /// Moves q(0) to the origin and makes w_0 = 1.
  void start_at_origin() {
    if (!w.empty()) {
      const double scale = 1 / w[0];
      const Xy<double> start = scale * m[0];
      for (std::size_t k = 0; k < m.size(); ++k) {
        m[k] = scale * (m[k] - w[k] * start);
        w[k] = scale * w[k];
      }
    }
    m[0] = {};
  }

  /// Returns the piece seen from the point that lies at `origin`.
  [[nodiscard]] Local_polynomial seen_from(const Xy<double>& origin) const {
    Local_polynomial p = *this;
    if (w.empty()) p.m[0] = p.m[0] - origin;
    else
      for (std::size_t k = 0; k < m.size(); ++k) p.m[k] = p.m[k] - w[k] * origin;
    return p;
  }

 private:
  template <class T> static T horner(const Coefficients<T>& c, double u) {
    T v = c.back();
    for (std::size_t k = c.size() - 1; k-- > 0;) v = c[k] + u * v;
    return v;
  }
  template <class T> static T slope(const Coefficients<T>& c, double u) {
    T v = static_cast<double>(c.size() - 1) * c.back();
    for (std::size_t k = c.size() - 1; k-- > 1;) v = static_cast<double>(k) * c[k] + u * v;
    return v;
  }
  // Synthetic division: the coefficients about u0, for a parameter that runs h times as fast.
  template <class T> static Coefficients<T> shifted(const Coefficients<T>& c, double u0, double h) {
    Coefficients<T> s = c;
    for (std::size_t i = 0; i + 1 < s.size(); ++i)
      for (std::size_t k = s.size() - 1; k-- > i;) s[k] = s[k] + u0 * s[k + 1];
    double power = 1;
    for (std::size_t k = 0; k < s.size(); ++k, power *= h) s[k] = power * s[k];
    return s;
  }
};

/// The piece [t0, t1] of the curve behind `table`, in units of table.unit().
[[nodiscard]] inline Local_polynomial local_polynomial(const Taylor_table<double>& table, double t0, double t1) {
  const Taylor_coefficients<double> taylor = table.expand(t0, t1);
  Local_polynomial p{taylor.numerator, taylor.weight};
  p.start_at_origin();
  return p;
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
