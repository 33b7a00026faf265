// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What proofs have in common: a curve piece relative to a point, as polynomials in the Bernstein basis over exact
// numbers or double-doubles, conversions of these, and proofs of polynomials' signs over them and over intervals.

#ifndef BOUNDING_ARCS_LIBRARY_VERIFY_WEIGHTED_PIECE_H
#define BOUNDING_ARCS_LIBRARY_VERIFY_WEIGHTED_PIECE_H

#include <CGAL/Bounding_arcs_2/frame/bezier_chord_shape.h>
#include <CGAL/Bounding_arcs_2/number/Bracket.h>
#include <CGAL/Bounding_arcs_2/number/Double_double.h>
#include <CGAL/Bounding_arcs_2/number/Mpfr_interval.h>
#include <CGAL/Bounding_arcs_2/number/stable_norm.h>
#include <CGAL/Bounding_arcs_2/polynomial/Bernstein_polynomial.h>
#include <CGAL/Bounding_arcs_2/verify/outside_bound.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::verify {

using internal::number_from;

inline constexpr double INFINITE = std::numeric_limits<double>::infinity();
[[nodiscard]] inline Bracket range_of(const Double_double& x) {
  const double spread = (std::fabs(x.lo) + x.err) * Double_double::INFLATION;
  if (!std::isfinite(x.hi) || !std::isfinite(spread)) return {-INFINITE, INFINITE};
  if (spread == 0) return {x.hi, x.hi};
  return {std::nextafter(x.hi - spread, -INFINITE), std::nextafter(x.hi + spread, INFINITE)};
}
template <class Exact> [[nodiscard]] Bracket range_of(const Exact& x) {
  const std::pair<double, double> range = CGAL::to_interval(x);
  return {range.first, range.second};
}

/// Room for the few roundings of a formula in doubles whose result is to be an upper or lower bound.
inline constexpr double ROUND_UP = 1 + 0x1p-48, ROUND_DOWN = 1 - 0x1p-48;

/// The most that the number can be.
[[nodiscard]] inline double most_of(const Bracket& r) { return (std::max)(std::fabs(r.lower), std::fabs(r.upper)); }
/// A vector's length, between doubles.
template <class NT> [[nodiscard]] Bracket length_range(const Xy<NT>& v) {
  const auto least = [](const Bracket& r) { return r.lower > 0 ? r.lower : (r.upper < 0 ? -r.upper : 0.0); };
  const Bracket x = range_of(v.x), y = range_of(v.y);
  return {stable_norm(Xy<double>{least(x), least(y)}) * ROUND_DOWN,
          stable_norm(Xy<double>{most_of(x), most_of(y)}) * ROUND_UP};
}

// Proofs that a polynomial is nowhere negative on [0, 1], from the signs of its Bernstein coefficients.

/// What came of a proof.
enum class Proof { PROVEN, DISPROVED, UNDECIDED };

/// -1, 0 or +1, or nothing where errors leave it open.
template <class Exact> [[nodiscard]] std::optional<int> certain_sign(const Exact& x) {
  return static_cast<int>(CGAL::sign(x));
}
[[nodiscard]] inline std::optional<int> certain_sign(const Double_double& x) { return x.sign(); }
[[nodiscard]] inline std::optional<int> certain_sign(const Mpfr_interval& x) {
  const int sign = x.certain_sign();
  return sign != 0 ? std::optional<int>(sign) : std::nullopt;
}

/// Whether p >= 0 on all of [0, 1].
/// \param depth how often to halve before giving up: a sign that needs finer parts than that is as good as a root
template <class NT> [[nodiscard]] Proof prove_nonnegative(const Bernstein_polynomial<NT>& p, int depth = 30) {
  const auto& c = p.scaled_coefficients();
  const auto is_nonnegative = [](const NT& x) { return certain_sign(x).value_or(-1) >= 0; };
  if (certain_sign(c.front()) == -1 || certain_sign(c.back()) == -1) return Proof::DISPROVED;
  if (std::all_of(c.begin(), c.end(), is_nonnegative)) return Proof::PROVEN;
  if (depth == 0 || !is_nonnegative(c.front()) || !is_nonnegative(c.back())) return Proof::UNDECIDED;
  const auto halves = p.halves();
  const Proof head = prove_nonnegative(halves.first, depth - 1);
  return head == Proof::PROVEN ? prove_nonnegative(halves.second, depth - 1) : head;
}

/// The piece [t0, t1] of a curve minus a point: (x, y) / weight over [0, 1] in units of the curve's table, weight > 0.
/// All three have one formal degree.
template <class NT> struct Weighted_piece {
  using Polynomial = Bernstein_polynomial<NT>;
  Polynomial x, y, weight;

  /// The linear function direction * q + constant of the piece's points q, times weight.
  [[nodiscard]] Polynomial linear(const Xy<NT>& direction, const NT& constant) const {
    return direction.x * x + direction.y * y + constant * weight;
  }
  /// The part over [from, to].
  [[nodiscard]] Weighted_piece part(const NT& from, const NT& to) const {
    return {part(x, from, to), part(y, from, to), part(weight, from, to)};
  }
  [[nodiscard]] static Polynomial part(const Polynomial& p, const NT& from, const NT& to) {
    return p.restricted(from, NT(NT(1) - from), to, NT(NT(1) - to));
  }
};

/// A double that is at least the distance of every point of the piece from p: the convex hull of control points bounds
/// it.
template <class NT> [[nodiscard]] double farthest_from(const Xy<NT>& p, const Weighted_piece<NT>& piece) {
  double r = 0;
  for (std::size_t i = 0; i < piece.weight.scaled_coefficients().size(); ++i) {
    const NT& w = piece.weight.scaled_coefficients()[i];
    const Xy<NT> q{piece.x.scaled_coefficients()[i], piece.y.scaled_coefficients()[i]};
    if (!(range_of(w).lower > 0)) return INFINITE;
    r = (std::max)(r, length_range(Xy<NT>(q - w * p)).upper / range_of(w).lower * ROUND_UP);
  }
  return r;
}

/// sum a_k s^k in the scaled Bernstein basis: a_k s^k = a_k s^k (s + (1 - s))^(n - k).
template <class NT> [[nodiscard]] Bernstein_polynomial<NT> from_taylor(const std::vector<NT>& a) {
  const std::size_t n = a.size() - 1;
  std::vector<NT> c(n + 1, NT(0));
  for (std::size_t k = 0; k <= n; ++k) {
    double binomial = 1;  // of n - k over i - k
    for (std::size_t i = k; i <= n; ++i) {
      c[i] = NT(c[i] + NT(binomial) * a[k]);
      binomial = binomial * static_cast<double>(n - i) / static_cast<double>(i - k + 1);
    }
  }
  return Bernstein_polynomial<NT>::from_scaled(std::move(c));
}

/// C(t0) - origin in units of the table.
template <class NT> [[nodiscard]] Xy<NT> point_from(const internal::Proven_piece& piece, const Xy<NT>& origin) {
  const Taylor_table<NT>& table = piece.table<NT>();
  Xy<NT> q = NT(1 / table.unit()) * (piece.first<NT>() - origin);
  if (piece.t0 == 0) return q;
  const internal::Relative_piece<NT> before = internal::relative_piece(table, NT(0), NT(piece.t0));
  Xy<NT> chord;
  for (std::size_t k = 1; k < before.m.size(); ++k) chord = chord + before.m[k];
  if (!before.w.empty()) chord = NT(NT(1) / NT(before.w[0] * before.end_weight)) * chord;
  return q + chord;
}

/// \param start C(t0) minus the point that the piece is relative to, in units of the table
template <class NT>
[[nodiscard]] Weighted_piece<NT> weighted_piece(const internal::Proven_piece& proven, const Xy<NT>& start) {
  const internal::Relative_piece<NT> piece = internal::relative_piece(proven.table<NT>(), NT(proven.t0), NT(proven.t1));
  const std::size_t n = piece.m.size();
  std::vector<NT> x(n, NT(0)), y(n, NT(0)), weight(n, NT(0));
  for (std::size_t k = 1; k < n; ++k) {
    x[k] = piece.m[k].x;
    y[k] = piece.m[k].y;
  }
  weight[0] = NT(1);  // a rational piece is C(t0) + m / (w0 w)
  for (std::size_t k = 0; k < piece.w.size(); ++k) weight[k] = NT(piece.w[0] * piece.w[k]);
  const Bernstein_polynomial<NT> w = from_taylor(weight);
  return {from_taylor(x) + start.x * w, from_taylor(y) + start.y * w, w};
}

}  // namespace CGAL::Bounding_arcs::verify

#endif
