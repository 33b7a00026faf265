// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A curve piece as exact polynomials about each of its ends, seen from that end with the centres of curvature on the
// side of the normal: what the containment proofs evaluate circles and lines on.

#ifndef CGAL_BOUNDING_ARCS_2_VERIFY_CONTAINMENT_PIECE_H
#define CGAL_BOUNDING_ARCS_2_VERIFY_CONTAINMENT_PIECE_H

#include <CGAL/Bounding_arcs_2/frame/bezier_chord_shape.h>
#include <CGAL/Bounding_arcs_2/verify/sign_on_interval.h>

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::verify {

using Rational = CGAL::Exact_rational;
using Rational_polynomial = Power_polynomial<Rational>;

/// The piece from one end: q(s) = x(s), y(s) times scale / weight(s) is C - p_end in units of the chord shape, s from
/// 0 at this end to 1 at the other.
struct End_view {
  Rational_polynomial x, y;  ///< constant coefficient 0
  Rational_polynomial weight;
  Rational scale{1};
  Rational low{0}, high{1};  ///< where the curve is asked to be in the region: all of it, or not quite to its ends
  Xy<Rational> tangent;      ///< as in the chord shape, in the curve's direction
  Xy<Rational> inward;       ///< perp(tangent) times the turn: towards the centres of curvature
  Xy<Rational> chord;        ///< to the other end

  /// normal * q(s), over scale, times weight(s): a polynomial with exact zero coefficients where q touches.
  [[nodiscard]] Rational_polynomial along(const Xy<Rational>& v) const {
    Rational_polynomial p(x.size());
    for (std::size_t k = 0; k < p.size(); ++k) p[k] = v.x * x[k] + v.y * y[k];
    return p;
  }
};

/// p divided by s^n, n coefficients being exactly 0. \pre they are
[[nodiscard]] inline Rational_polynomial without_leading_zeros(const Rational_polynomial& p, std::size_t n) {
  return Rational_polynomial(p.begin() + static_cast<std::ptrdiff_t>(n), p.end());
}
[[nodiscard]] inline std::size_t leading_zeros(const Rational_polynomial& p) {
  std::size_t n = 0;
  while (n < p.size() && p[n] == 0) ++n;
  return n;
}
/// p divided by (1 - s) as often as that leaves no rest; where the curve ends in a cusp that is more than once.
/// Empty when p is 0.
[[nodiscard]] inline Rational_polynomial without_roots_at_one(Rational_polynomial p) {
  for (;;) {
    Rational sum(0);
    Rational_polynomial quotient;
    for (const Rational& c : p) {
      sum += c;
      quotient.push_back(sum);
    }
    if (p.empty() || sum != 0) return p;
    quotient.pop_back();
    p = std::move(quotient);
  }
}

/// A length, in units of the shape, that no point with s in [0, share] exceeds in distance from this end; infinite if
/// unknown.
[[nodiscard]] inline double reach(const End_view& v, const Rational& share) {
  constexpr double OUTWARD = 1 + 0x1p-30;
  const auto upper = [](const Rational& x) { return std::fabs(CGAL::to_double(x)) * OUTWARD; };
  double way = 0, weight = CGAL::to_double(v.weight[0]) / OUTWARD, power = 1;
  for (std::size_t k = 1; k < (std::max)(v.x.size(), v.weight.size()); ++k) {
    power *= upper(share);
    if (k < v.x.size()) way += power * std::hypot(upper(v.x[k]), upper(v.y[k]));
    if (k < v.weight.size()) weight -= power * upper(v.weight[k]);
  }
  const double length = way * upper(v.scale) / weight * OUTWARD;
  return weight > 0 && !std::isnan(length) ? length : std::numeric_limits<double>::infinity();
}

/// The two parts of the side of a circle of curvature k that touches the curve at this end, positive inside:
/// 2 n q - k |q|^2, times weight^2 / scale, = bend(s) - (k / |tangent|-normalised) square(s).
struct Contact_polynomials {
  Rational_polynomial bend;    ///< 2 weight (inward * xy)
  Rational_polynomial square;  ///< scale |xy|^2
};
[[nodiscard]] inline Contact_polynomials contact_polynomials(const End_view& v) {
  Rational_polynomial bend = product(v.weight, v.along(v.inward));
  for (Rational& c : bend) c *= 2;
  Rational_polynomial square = product(v.x, v.x);
  const Rational_polynomial yy = product(v.y, v.y);
  for (std::size_t k = 0; k < square.size(); ++k) square[k] = v.scale * (square[k] + yy[k]);
  const std::size_t n = (std::max)(bend.size(), square.size());
  bend.resize(n, Rational(0));
  square.resize(n, Rational(0));
  return {bend, square};
}

/// bend - k square, with the common powers of s taken out; k is curvature times |inward|.
template <class NT, class Convert>
[[nodiscard]] Power_polynomial<NT> contact_side(const Contact_polynomials& c, const NT& k, const Convert& convert) {
  const std::size_t n = (std::min)(leading_zeros(c.bend), leading_zeros(c.square));
  Power_polynomial<NT> p;
  for (std::size_t i = n; i < c.bend.size(); ++i) p.push_back(NT(convert(c.bend[i]) - k * convert(c.square[i])));
  return p.empty() ? Power_polynomial<NT>{NT(0)} : p;
}

[[nodiscard]] inline End_view start_view(const Relative_piece<Rational>& piece, const Chord_shape_2<Rational>& f) {
  End_view v;
  for (const Xy<Rational>& m : piece.m) {
    v.x.push_back(m.x);
    v.y.push_back(m.y);
  }
  v.x[0] = v.y[0] = 0;
  v.weight.assign(1, Rational(1));
  if (!piece.w.empty()) v.weight.assign(piece.w.begin(), piece.w.end());
  v.scale = piece.end_weight;
  v.tangent = f.tangent0;
  v.inward = Rational(f.turn) * perp(f.tangent0);
  v.chord = f.chord;
  return v;
}

[[nodiscard]] inline End_view end_view(const Relative_piece<Rational>& piece, const Chord_shape_2<Rational>& f) {
  const Coefficients<Xy<Rational>> e = about_end(piece, f.chord);
  End_view v;
  for (std::size_t k = 0; k < e.size(); ++k) {
    v.x.push_back(k == 0 ? Rational(0) : (k % 2 == 0 ? e[k].x : Rational(-e[k].x)));
    v.y.push_back(k == 0 ? Rational(0) : (k % 2 == 0 ? e[k].y : Rational(-e[k].y)));
  }
  v.weight.assign(1, Rational(1));
  if (!piece.w.empty()) {
    v.weight.assign(piece.w.begin(), piece.w.end());
    v.weight = on_interval(v.weight, Rational(1), Rational(0));
  }
  v.scale = piece.end_weight;
  v.tangent = f.tangent1;
  v.inward = Rational(f.turn) * perp(f.tangent1);
  v.chord = -f.chord;
  return v;
}

}  // namespace CGAL::Bounding_arcs::verify

#endif
