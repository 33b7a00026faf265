// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far a curve piece is from a circular arc over its chord: a certified upper bound, from one polynomial that is
// sampled densely and bounded between the samples by its derivatives (doc/arcs.md).

#ifndef BOUNDING_ARCS_LIBRARY_CHAIN_ARC_DEVIATION_H
#define BOUNDING_ARCS_LIBRARY_CHAIN_ARC_DEVIATION_H

#include <CGAL/Bounding_arcs_2/frame/Taylor_table.h>
#include <CGAL/Bounding_arcs_2/number/strict_math.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL::Bounding_arcs::internal {

// A curve piece as a polynomial (or quotient of polynomials) of one parameter u in [0, 1], seen from a point of its
// own: what fitting and bounding an arc works on, in double.

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

// Samples of the deviation: the bound exceeds the largest by about (pi / CELLS)^2 / 8 of it. Half as many cost 2%.
inline constexpr std::size_t CELLS = 32;

[[nodiscard]] inline double size_of(const Xy<double>& v) { return std::fabs(v.x) + std::fabs(v.y); }
[[nodiscard]] inline double size_of(double x) { return std::fabs(x); }

/// The sum of all sizes, a bound of a polynomial's values on [0, 1] from its coefficients.
template <class T> [[nodiscard]] double total_size(const Coefficients<T>& coefficients) {
  double sum = 0;
  for (const T& c : coefficients) sum += size_of(c);
  return sum;
}

/// The arc from the origin to `chord` with tan(angle / 4) = bulge, positive for a left turn; q is on its circle iff
///   side(q) = (1 - bulge^2) cross(chord, q) + 2 bulge (chord - q).q = 0.
struct Local_arc {
  Xy<double> chord;
  double bulge;

  /// A vector along the concentric circle through q.
  [[nodiscard]] Xy<double> tangent(const Xy<double>& q) const {
    return (1 - bulge * bulge) * chord + (2 * bulge) * perp(2.0 * q - chord);
  }
};

/// The coefficients of side(q(u)) w(u)^2, of degree 2 n for a piece of degree n.
[[nodiscard]] inline boost::container::small_vector<double, 16> side_polynomial(const Local_polynomial& q,
                                                                                const Local_arc& arc) {
  const std::size_t n = q.m.size();
  boost::container::small_vector<double, 16> f(2 * n - 1, 0.0);
  const double twice = 2 * arc.bulge;
  const Xy<double> linear = (1 - arc.bulge * arc.bulge) * perp(arc.chord) + twice * arc.chord;
  for (std::size_t i = 0; i < n; ++i) {
    const double a = dot(linear, q.m[i]);
    if (q.w.empty()) f[i] += a;
    else
      for (std::size_t j = 0; j < n; ++j) f[i + j] += a * q.w[j];
    f[2 * i] -= twice * dot(q.m[i], q.m[i]);
    for (std::size_t j = 0; j < i; ++j) f[i + j] -= 2 * twice * dot(q.m[i], q.m[j]);
  }
  return f;
}

/// A bound of a polynomial's second derivative on [0, 1]: its larger end value, and what bends away from the line
/// between.
template <class Numbers> [[nodiscard]] double second_derivative_bound(const Numbers& f) {
  double at_start = f.size() > 2 ? 2 * f[2] : 0, at_end = at_start, fourth = 0;
  for (std::size_t k = 3; k < f.size(); ++k) {
    const double x = static_cast<double>(k * (k - 1));
    at_end += x * f[k];
    if (k > 3) fourth += x * static_cast<double>((k - 2) * (k - 3)) * std::fabs(f[k]);
  }
  return (std::max)(std::fabs(at_start), std::fabs(at_end)) + fourth / 8;
}

/// Where samples are taken; a table, as its entries would be made anew for every coefficient.
struct Sample_places {
  double u[CELLS + 1] = {};
  constexpr Sample_places() {
    for (std::size_t i = 0; i <= CELLS; ++i) u[i] = static_cast<double>(i) / CELLS;
  }
};
inline constexpr Sample_places SAMPLE_PLACES;

template <class Numbers> void sample(const Numbers& f, std::array<double, CELLS + 1>& value) {
  value.fill(f.back());
  for (std::size_t k = f.size() - 1; k-- > 0;) {
    const double coefficient = f[k];
    for (std::size_t i = 0; i <= CELLS; ++i) value[i] = value[i] * SAMPLE_PLACES.u[i] + coefficient;
  }
}

/// Bounds along a piece: the largest |side(q(u))| from above, the weight from below. A weight that is not above 0 tells
/// nothing.
struct Side_bounds {
  double side, weight;
};

/// In real arithmetic on the given numbers, but for the samples of the weight, whose rounding is counted here.
[[nodiscard]] inline Side_bounds side_bounds(const Local_polynomial& q, const Local_arc& arc) {
  const auto f = side_polynomial(q, arc);
  std::array<double, CELLS + 1> value;
  sample(f, value);
  const double rest = second_derivative_bound(f) / (8.0 * CELLS * CELLS);
  Side_bounds bounds{0, 1};
  if (!q.is_rational()) {
    for (const double v : value) bounds.side = (std::max)(bounds.side, std::fabs(v));
    bounds.side += rest;
    return bounds;
  }
  std::array<double, CELLS + 1> weight;
  sample(q.w, weight);
  const double weight_rest = second_derivative_bound(q.w) / (8.0 * CELLS * CELLS) +
                             2 * static_cast<double>(q.w.size()) * HALF_ULP * total_size(q.w);
  bounds.weight = *std::min_element(weight.begin(), weight.end()) - weight_rest;
  for (std::size_t i = 0; i < CELLS; ++i) {
    const double w = (std::min)(weight[i], weight[i + 1]) - weight_rest;
    bounds.side = (std::max)(bounds.side, ((std::max)(std::fabs(value[i]), std::fabs(value[i + 1])) + rest) / (w * w));
  }
  return bounds;
}

/// Whether the foot on the arc's circle moves forwards all the time that q moves from u = 0 to 1.
/// \pre q is a piece of a spiral segment: monotone in x and y, its tangent turning one way from `start` to `end`
[[nodiscard]] inline bool foot_moves_forwards(const Local_polynomial& q, const Local_arc& arc, const Xy<double>& start,
                                              const Xy<double>& end, int cells = 1) {
  Xy<double> p = q.m[0], tangent = start;
  for (int i = 1; i <= cells; ++i) {
    const Xy<double> next = q(i / static_cast<double>(cells));
    const Xy<double> next_tangent = i == cells ? end : q.derivative(i / static_cast<double>(cells));
    for (const Xy<double>& corner : {p, Xy<double>{p.x, next.y}, Xy<double>{next.x, p.y}, next}) {
      const Xy<double> along = arc.tangent(corner);
      constexpr double MARGIN = 0x1p-20;  // far above rounding; a hundred times more would refuse no arc of use
      for (const Xy<double>& t : {tangent, next_tangent})
        if (!(dot(along, t) > MARGIN * size_of(along) * size_of(t))) {
          constexpr int FINE = 16;
          return cells < FINE && foot_moves_forwards(q, arc, start, end, FINE);
        }
    }
    p = next;
    tangent = next_tangent;
  }
  return true;
}

/// What rounding of all that arc_deviation computes adds to |side| / (c (1 + bulge^2)), with c the chord.
/// \param reach the sum of |coefficients| of the piece's numerator, \param weights that of its weight, \param n their
///   number, \param least a lower bound of the weight \param inverse 1 / c
[[nodiscard]] inline double side_rounding(double reach, double inverse, std::size_t n, double weights = 1,
                                          double least = 1) {
  // doc/arcs.md: side w^2 is a sum of terms of at most (2 c weights + reach) reach (1 + bulge^2) in all.
  const double roundings = 8 * static_cast<double>(n) + 32;
  return roundings * HALF_ULP * reach * (2 * weights + reach * inverse) / (least * least);
}

/// An upper bound of the largest distance from the circle of an arc, from that of |side| and its rounding.
inline double distance_from_side(double side, double inverse_chord, double bulge, double rounding) {
  const double scale = inverse_chord / (1 + bulge * bulge), height = side * scale + rounding;
  const double bend = 8 * std::fabs(bulge) * height * scale;
  // height / (1 - bend / 2), with 1 + bend for 1 / (1 - bend / 2)
  return bend < 1 ? height * (1 + bend) * (1 + 16 * HALF_ULP) : std::numeric_limits<double>::infinity();
}

/// An upper bound of the Frechet distance, and so the Hausdorff distance, between the piece q and the arc, both as
/// given in exact numbers; infinity where none was found.
/// \pre as foot_moves_forwards; the feet of q(0) and q(1) are the ends of the arc
/// \guarantee certified, rounding of this function included
/// \source derivation in doc/arcs.md
[[nodiscard]] inline double arc_deviation(const Local_polynomial& q, const Local_arc& arc, const Xy<double>& start,
                                          const Xy<double>& end) {
  const double c = std::sqrt(dot(arc.chord, arc.chord));
  if (!(c > 0) || !foot_moves_forwards(q, arc, start, end)) return std::numeric_limits<double>::infinity();
  const Side_bounds bounds = side_bounds(q, arc);
  if (!(bounds.weight > 0)) return std::numeric_limits<double>::infinity();
  const double inverse = 1 / c, weights = q.is_rational() ? total_size(q.w) : 1;
  return distance_from_side(bounds.side, inverse, arc.bulge,
                            side_rounding(total_size(q.m), inverse, q.m.size(), weights, bounds.weight));
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
