// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The chord shape of a piece of a polynomial or rational Bezier curve from its Taylor coefficients, with the leading
// terms that cancel never formed.  With V_k = C^(k) h^k / k! of a polynomial piece: T0 = V_1, D = sum V_k, T1 = sum k
// V_k. A rational curve N / w has M_k = w_0 N_k - w_k N_0 instead of V_k, for C - C(t) = sum M_k s^k / (w_0 w(s)).

#ifndef CGAL_BOUNDING_ARCS_2_FRAME_BEZIER_CHORD_SHAPE_H
#define CGAL_BOUNDING_ARCS_2_FRAME_BEZIER_CHORD_SHAPE_H

#include <CGAL/Bounding_arcs_2/frame/Chord_frame_2.h>
#include <CGAL/Bounding_arcs_2/frame/Taylor_table.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

/// How C' behaves at the ends of a piece: the order of the first derivative that does not vanish, 1 where C' != 0.
/// Where it is more than 1 its bend order is that of the first derivative that has another direction, 0 where none has:
/// facts of the exact curve, as rounded derivatives cannot tell which of their crosses are 0.
struct End_orders {
  std::int16_t start = 1, end = 1;
  std::int16_t start_bend = 0, end_bend = 0;
};

/// What a construction reads of the chord shape besides the BCA part.
struct Shape_parts {
  bool curvature = true;        ///< end curvatures and Kneser differences
  bool control_points = false;  ///< the control points of the piece, and their weights
};

namespace internal {
/// Taylor vectors M_k about the start, weights relative to the end, and the length of one unit.
template <class NT> struct Relative_piece {
  Coefficients<Xy<NT>> m;  // m[0] unused
  Coefficients<NT> w;      // empty for a polynomial
  NT end_weight{1};        // w(t + h)
  NT unit{1};
};

template <class NT>
[[nodiscard]] Relative_piece<NT> relative_piece(const Taylor_table<NT>& table, const NT& t0, const NT& t1) {
  Taylor_coefficients<NT> taylor = table.expand(t0, t1);
  if (!table.is_rational()) return {std::move(taylor.numerator), {}, NT(1), NT(table.unit())};
  Relative_piece<NT> piece{{Xy<NT>{}}, {}, NT(0), NT(1)};
  for (const NT& w : taylor.weight) {
    piece.w.push_back(w);
    piece.end_weight = piece.end_weight + w;
  }
  const NT w0 = piece.w[0];
  for (std::size_t k = 1; k < taylor.numerator.size(); ++k)
    piece.m.push_back(w0 * taylor.numerator[k] - piece.w[k] * taylor.numerator[0]);
  piece.unit = NT(table.unit()) / NT(w0 * piece.end_weight);
  return piece;
}

// E_k = U_k - (w^e_k / w(t+h)) D with U_k = sum_j binomial(j, k) M_j: up to sign and one common factor the Taylor
// vectors about the end of the piece.  E_1 is the end's tangent vector in the same units as the chord.
template <class NT> [[nodiscard]] Coefficients<Xy<NT>> about_end(const Relative_piece<NT>& piece, const Xy<NT>& chord) {
  const std::size_t n = piece.m.size();
  Coefficients<Xy<NT>> e(n);
  for (std::size_t k = 1; k < n; ++k) {
    double binomial = 1;
    NT weight{0};
    for (std::size_t j = k; j < n; ++j) {
      e[k] = e[k] + NT(binomial) * piece.m[j];
      if (!piece.w.empty()) weight = weight + NT(binomial) * piece.w[j];
      binomial = binomial * static_cast<double>(j + 1) / static_cast<double>(j + 1 - k);
    }
    if (!piece.w.empty()) e[k] = e[k] - NT(weight / piece.end_weight) * chord;
  }
  return e;
}

// Sets the control points of the piece relative to its start, and their weights, by conversion from Taylor to Bernstein
// coefficients.
template <class NT> void set_control_points(const Relative_piece<NT>& piece, Chord_shape_2<NT>& f) {
  const std::size_t degree = piece.m.size() - 1;
  f.control_points.assign(1, {});
  if (!piece.w.empty()) f.weights.assign(1, piece.w[0]);
  for (std::size_t i = 1; i <= degree; ++i) {
    Xy<NT> point;
    NT ratio{1}, weight = piece.w.empty() ? NT(1) : piece.w[0];  // binomial(i, k) / binomial(degree, k)
    for (std::size_t k = 1; k <= i; ++k) {
      ratio = NT(ratio * NT(static_cast<double>(i - k + 1)) / NT(static_cast<double>(degree - k + 1)));
      point = point + ratio * piece.m[k];
      if (!piece.w.empty()) weight = weight + ratio * piece.w[k];
    }
    f.control_points.push_back(NT(piece.end_weight / weight) * point);
    if (!piece.w.empty()) f.weights.push_back(weight);
  }
}

// The curvature term of an end whose first nonzero Taylor vector is v[m], m > 1, for a tangent vector of m |v[m]|:
// kappa ~ cross(v_m, v_j) s^(j - 2m) with v_j, the bend, the first vector not parallel to v_m.
template <class NT>
[[nodiscard]] NT singular_curvature(const Coefficients<Xy<NT>>& v, std::size_t m, std::size_t bend) {
  if (bend != 2 * m) return NT(0);  // none, or infinite
  return NT(static_cast<double>(m * m * m)) * cross(v[m], v[bend]);
}
[[nodiscard]] inline bool is_infinite_curvature(int order, int bend) { return bend != 0 && bend < 2 * order; }

// A, B and A - B as sums over the Taylor vectors; all second-order terms of A - B are gone.
template <class NT> void sum_crosses(const Coefficients<Xy<NT>>& m, Chord_shape_2<NT>& f) {
  for (std::size_t k = 2; k < m.size(); ++k) {
    const NT c = cross(m[1], m[k]);
    f.cross0 = f.cross0 + c;
    f.cross1 = f.cross1 + NT(static_cast<double>(k - 1)) * c;
    if (k > 2) f.cross_change = f.cross_change - NT(static_cast<double>(k - 2)) * c;
    for (std::size_t j = 2; j < k; ++j) {
      const NT inner = NT(static_cast<double>(k - j)) * cross(m[j], m[k]);
      f.cross1 = f.cross1 + inner;
      f.cross_change = f.cross_change - inner;
    }
  }
}

// K_i and the two Kneser differences of an ordinary piece.
template <class NT>
void end_curvatures(const Relative_piece<NT>& piece, const Coefficients<Xy<NT>>& e, Chord_shape_2<NT>& f) {
  const Coefficients<Xy<NT>>& m = piece.m;
  NT tail0{0}, tail1{0};
  for (std::size_t k = 3; k < m.size(); ++k) {
    tail0 = tail0 + cross(m[1], m[k]);
    const NT c = cross(e[1], e[k]);
    tail1 = tail1 + NT(k % 2 == 1 ? 1 : -1) * c;
  }
  const NT bend0 = m.size() > 2 ? cross(m[1], m[2]) : NT(0), bend1 = m.size() > 2 ? cross(e[1], e[2]) : NT(0);
  Xy<NT> past0{}, past1{};  // chord - T0, chord - T1
  for (std::size_t k = 2; k < m.size(); ++k) {
    past0 = past0 + m[k];
    past1 = past1 - NT(static_cast<double>(k - 1)) * m[k];
  }
  NT stretch0 = dot(past0, NT(2) * m[1] + past0);  // r |D|^2 - |T0|^2, r the ratio of the end weights
  NT ratio0{1}, ratio1{1};
  NT end_change{0};
  if (!piece.w.empty()) {
    NT change{0}, slope{0};
    for (std::size_t k = 1; k < piece.w.size(); ++k) {
      change = change + piece.w[k];
      slope = slope + NT(static_cast<double>(k)) * piece.w[k];
    }
    ratio0 = NT(piece.w[0] / piece.end_weight);
    ratio1 = NT(piece.end_weight / piece.w[0]);
    stretch0 = stretch0 - NT(change / piece.end_weight) * dot(f.chord, f.chord);
    past1 = past1 + NT(slope / piece.end_weight) * f.chord;
    end_change = NT(change / piece.w[0]) * dot(e[1], e[1]);  // (1 - ratio1) |T1|^2 = -this
  }
  const NT stretch1 = dot(past1, NT(2) * e[1] + past1) - end_change;  // |D|^2 - ratio1 |T1|^2
  f.curvature0 = ratio0 * bend0;
  f.curvature1 = bend1;
  f.kneser0 = bend0 * stretch0 - dot(m[1], m[1]) * tail0;
  f.kneser1 = NT(0) - bend1 * stretch1 - ratio1 * dot(e[1], e[1]) * tail1;
}
}  // namespace internal

/// The chord shape of the piece [t0, t1] of the curve behind `table`.
/// \param parts what to fill in; curvatures and Kneser differences stay 0 where they are not asked for (BCA)
/// \param orders ends where C' vanishes: there the tangent is the one-sided limit and the curvature may be infinite
/// \guarantee exact over a field; over double no difference of nearly equal numbers but what lies in the slope of the
///   curvature itself (orders 1)
/// \source A, B, A - B and the Kneser differences: expansions of the chord frame in Taylor vectors, doc/numerics.md
template <class NT>
[[nodiscard]] Chord_shape_2<NT> bezier_chord_shape(const Taylor_table<NT>& table, const NT& t0, const NT& t1,
                                                   const Shape_parts& parts, const End_orders& orders = {}) {
  const internal::Relative_piece<NT> piece = internal::relative_piece(table, t0, t1);
  Chord_shape_2<NT> f;
  f.unit = piece.unit;
  f.tangent0 = piece.m[1];
  f.chord = piece.m[1];
  for (std::size_t k = 2; k < piece.m.size(); ++k) {
    f.chord = f.chord + piece.m[k];
    f.tangent_change = f.tangent_change + NT(static_cast<double>(k)) * piece.m[k];
  }
  if (!piece.w.empty()) {
    NT slope{0};
    for (std::size_t k = 1; k < piece.w.size(); ++k) slope = slope + NT(static_cast<double>(k)) * piece.w[k];
    f.tangent_change = f.tangent_change - NT(slope / piece.end_weight) * f.chord;
  }
  f.tangent1 = f.tangent0 + f.tangent_change;
  const bool ordinary = orders.start == 1 && orders.end == 1;
  if (parts.control_points) internal::set_control_points(piece, f);
  if (ordinary && !parts.curvature) {
    internal::sum_crosses(piece.m, f);
    internal::orient(f);
    return f;
  }
  const internal::Coefficients<Xy<NT>> e = internal::about_end(piece, f.chord);
  internal::sum_crosses(piece.m, f);
  internal::end_curvatures(piece, e, f);
  if (ordinary) {
    internal::orient(f);
    return f;
  }
  // A singular end: no leading terms cancel there, so plain differences keep their digits.
  const auto m0 = static_cast<std::size_t>(orders.start), m1 = static_cast<std::size_t>(orders.end);
  if (m0 > 1 && m0 < piece.m.size()) {
    f.tangent0 = NT(static_cast<double>(m0)) * piece.m[m0];
    f.curvature0 = internal::singular_curvature(piece.m, m0, static_cast<std::size_t>(orders.start_bend));
    f.infinite0 = internal::is_infinite_curvature(orders.start, orders.start_bend);
    if (!piece.w.empty()) f.curvature0 = f.curvature0 * NT(piece.w[0] / piece.end_weight);
  }
  if (m1 > 1 && m1 < piece.m.size()) {
    const NT sign(m1 % 2 == 1 ? 1 : -1);
    f.tangent1 = NT(sign * NT(static_cast<double>(m1))) * e[m1];
    f.curvature1 = sign * internal::singular_curvature(e, m1, static_cast<std::size_t>(orders.end_bend));
    f.infinite1 = internal::is_infinite_curvature(orders.end, orders.end_bend);
  }
  f.tangent_change = f.tangent1 - f.tangent0;
  f.cross0 = cross(f.tangent0, f.chord);
  f.cross1 = cross(f.chord, f.tangent1);
  f.cross_change = f.cross0 - f.cross1;
  const NT cc = dot(f.chord, f.chord);
  f.kneser0 = f.infinite0 ? NT(0) : NT(f.curvature0 * cc - f.cross0 * dot(f.tangent0, f.tangent0));
  f.kneser1 = f.infinite1 ? NT(0) : NT(f.cross1 * dot(f.tangent1, f.tangent1) - f.curvature1 * cc);
  internal::orient(f);
  return f;
}

}  // namespace CGAL::Bounding_arcs

#endif
