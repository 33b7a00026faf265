// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Containment in BCA: for each of the two circles the side of the curve is a polynomial with a double root where the
// circle touches and a simple one at the other end; what is left after dividing them out must keep one sign.
// The two circles meet in the end points only, so a curve that crosses neither stays in the lune between their arcs.

#ifndef BOUNDING_ARCS_LIBRARY_VERIFY_PROVE_BCA_H
#define BOUNDING_ARCS_LIBRARY_VERIFY_PROVE_BCA_H

#include <CGAL/Bounding_arcs_2/frame/Chord_frame_2.h>
#include <CGAL/Bounding_arcs_2/frame/bezier_chord_shape.h>
#include <CGAL/Bounding_arcs_2/polynomial/proportional_numbers.h>
#include <CGAL/Bounding_arcs_2/region/Contact_circle_2.h>
#include <CGAL/Bounding_arcs_2/verify/verify_region.h>
#include "Weighted_piece.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Fraction_traits.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::verify {

// Curve pieces over integers, for containment proofs.

using Rational = CGAL::Exact_rational;
using Integer = CGAL::Fraction_traits<Rational>::Numerator_type;
using Integer_polynomial = Bernstein_polynomial<Integer>;

/// The piece from one of its ends, its parameter from 0 at the tight end to 1 at the other:
/// scale (x, y) / weight = C - p_end in units of the chord shape.
struct End_view {
  Integer_polynomial x, y;  ///< 0 at this end
  Integer_polynomial weight;
  Rational scale;
  Xy<Rational> tangent;  ///< as in the chord shape, in the curve's direction
  Xy<Integer> inward;    ///< `stretch` perp(tangent) times the turn: towards the centers of curvature
  Integer stretch;
  /// The side of a circle of curvature k that touches at this end, 2 inward q - k |inward| |q|^2, positive inside,
  /// times weight^2 / scale is bend - k |inward| scale square.
  Integer_polynomial bend, square;

  /// v * (x, y)
  [[nodiscard]] Integer_polynomial along(const Xy<Integer>& v) const { return v.x * x + v.y * y; }
};

/// A curve piece as polynomials over integers, seen from each of its ends: what the containment proofs evaluate circles
/// and lines on. Denominators are cleared once, by positive factors that change no sign.
struct Containment_piece {
  End_view tight, flat;
  Xy<Integer> chord;  ///< from the tight end to the flat one, in any length
};

/// How many coefficients from the start, or from the end, are exactly 0 in both of two polynomials of one degree.
[[nodiscard]] inline std::size_t common_zeros(const Integer_polynomial& p, const Integer_polynomial& q, bool at_start) {
  const auto &a = p.scaled_coefficients(), &b = q.scaled_coefficients();
  const auto at = [&](std::size_t i) { return at_start ? i : a.size() - 1 - i; };
  std::size_t n = 0;
  while (n < a.size() && a[at(n)] == 0 && b[at(n)] == 0) ++n;
  return n;
}
/// p divided by powers of the parameter and of its complement, whose coefficients are 0; 0 where nothing is left.
template <class NT>
[[nodiscard]] Bernstein_polynomial<NT> without_roots(const Bernstein_polynomial<NT>& p, std::size_t at_start,
                                                     std::size_t at_end) {
  const auto& c = p.scaled_coefficients();
  if (at_start + at_end >= c.size()) return {};
  return Bernstein_polynomial<NT>::from_scaled(
      {c.begin() + static_cast<std::ptrdiff_t>(at_start), c.end() - static_cast<std::ptrdiff_t>(at_end)});
}

/// The parameters for which the curve is asked to be in the region: all, or not quite to its ends.
struct Parameter_range {
  Rational low{0}, high{1};
};

/// The polynomial over the range as over [0, 1], times what clears denominators.
[[nodiscard]] inline Integer_polynomial restricted(const Integer_polynomial& p, const Parameter_range& range) {
  const std::vector<Integer> ends =
      cleared<Rational>({range.low, Rational(1 - range.low), range.high, Rational(1 - range.high)}).numbers;
  return p.restricted(ends[0], ends[1], ends[2], ends[3]);
}
/// Whether p >= 0 in the range, its roots at 0 and 1 left out.
[[nodiscard]] inline Proof prove_nonnegative_but_at_ends(const Integer_polynomial& p, const Parameter_range& range) {
  Integer_polynomial rest = without_roots(p, common_zeros(p, p, true), common_zeros(p, p, false));
  if (range.low != 0 || range.high != 1) rest = restricted(rest, range);
  return prove_nonnegative(rest);
}

/// An upper bound of the distance from an end of all points with parameters in the range; infinite if unknown.
[[nodiscard]] inline double reach(const End_view& v, const Parameter_range& range) {
  const auto part = [&](const Integer_polynomial& p) {
    return restricted(p.elevated(v.x.degree()), range).scaled_coefficients();
  };
  const std::vector<Integer> x = part(v.x), y = part(v.y), weight = part(v.weight);
  double r = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!(weight[i] > 0)) return INFINITE;
    const Rational factor = v.scale / Rational(weight[i]);
    r = (std::max)(r, length_range(Xy<Rational>(factor * Xy<Rational>{Rational(x[i]), Rational(y[i])})).upper);
  }
  return r;
}

/// The frame of a shape in enclosures, with the piece's start in the origin and in units of the shape.
[[nodiscard]] inline Chord_frame_2<Mpfr_interval> enclosed_frame(Chord_shape_2<Rational> shape, mpfr_prec_t bits) {
  shape.unit = 1;
  const auto number = [bits](const Rational& x) { return Mpfr_interval(x, bits); };
  return shape.template over<Mpfr_interval>(number).at_origin();
}

/// A piece, its shape and the parameters that are asked for, in intervals of one precision.
class Piece_in_intervals {
 public:
  using Polynomial = Bernstein_polynomial<Mpfr_interval>;

  Piece_in_intervals(const Containment_piece& piece, const Chord_shape_2<Rational>& f, const Parameter_range& range,
                     mpfr_prec_t bits)
      : piece_(piece), f_(f), range_(range), bits_(bits), scale_(piece.tight.scale, bits), x_(interval(piece.tight.x)),
        y_(interval(piece.tight.y)), weight_(interval(piece.tight.weight)) {
    if (!f.tight_first) tight_end_ = {interval(f.chord.x), interval(f.chord.y)};
  }

 protected:
  [[nodiscard]] Mpfr_interval interval(const Rational& x) const { return Mpfr_interval(x, bits_); }
  [[nodiscard]] Polynomial interval(const Integer_polynomial& p) const {
    std::vector<Mpfr_interval> c;
    for (const Integer& x : p.scaled_coefficients()) c.push_back(interval(Rational(x)));
    return Polynomial::from_scaled(std::move(c));
  }
  [[nodiscard]] Proof prove_between(const Polynomial& p, const Rational& low, const Rational& high) const {
    return prove_nonnegative(
        p.restricted(interval(low), interval(Rational(1 - low)), interval(high), interval(Rational(1 - high))));
  }
  /// -1 or +1, or 0 where that is open.
  [[nodiscard]] int sign_at(const Polynomial& p, const Rational& s) const {
    return p.homogeneous_value(interval(s), interval(Rational(1 - s))).certain_sign();
  }
  /// Positive where the curve has passed the line across a direction through a point.
  [[nodiscard]] Polynomial passed(const Xy<Mpfr_interval>& direction, const Xy<Mpfr_interval>& p) const {
    return scale_ * (direction.x * x_ + direction.y * y_) - dot(direction, p - tight_end_) * weight_;
  }

  const Containment_piece& piece_;
  const Chord_shape_2<Rational>& f_;
  const Parameter_range& range_;
  mpfr_prec_t bits_;
  Mpfr_interval scale_;
  Polynomial x_, y_, weight_;  // from the tight end
  Xy<Mpfr_interval> tight_end_;
};

[[nodiscard]] inline Containment_piece containment_piece(const internal::Relative_piece<Rational>& piece,
                                                         const Chord_shape_2<Rational>& f) {
  std::vector<Rational> numbers(2);
  for (std::size_t k = 1; k < piece.m.size(); ++k) numbers.insert(numbers.end(), {piece.m[k].x, piece.m[k].y});
  const internal::Cleared_numbers<Integer> m = cleared(numbers),
                                           w = cleared<Rational>({piece.w.begin(), piece.w.end()});
  std::vector<Integer> x, y;
  for (std::size_t k = 0; k < m.numbers.size(); k += 2) {
    x.push_back(m.numbers[k]);
    y.push_back(m.numbers[k + 1]);
  }
  const auto polynomial = [&](const std::vector<Integer>& taylor) {  // in the direction from the tight end
    std::vector<Integer> c = from_taylor(taylor).scaled_coefficients();
    if (!f.tight_first) std::reverse(c.begin(), c.end());
    return Integer_polynomial::from_scaled(std::move(c));
  };
  End_view start, end;
  start.x = polynomial(x);
  start.y = polynomial(y);
  start.weight = end.weight = polynomial(w.numbers.empty() ? std::vector<Integer>{Integer(1)} : w.numbers);
  start.scale = piece.end_weight * Rational(w.denominator) / Rational(m.denominator);
  const auto at_end = [&](const Integer_polynomial& p) {
    return f.tight_first ? p.scaled_coefficients().back() : p.scaled_coefficients().front();
  };
  const Xy<Integer> way{at_end(start.x), at_end(start.y)};
  end.x = at_end(start.weight) * start.x - way.x * start.weight;
  end.y = at_end(start.weight) * start.y - way.y * start.weight;
  end.scale = start.scale / Rational(at_end(start.weight));
  start.tangent = f.tangent0;
  end.tangent = f.tangent1;
  for (End_view* v : {&start, &end}) {
    const Xy<Rational> normal = Rational(f.turn) * perp(v->tangent);
    const internal::Cleared_numbers<Integer> n = cleared<Rational>({normal.x, normal.y});
    v->inward = {n.numbers[0], n.numbers[1]};
    v->stretch = n.denominator;
    v->bend = Integer(2) * v->weight * v->along(v->inward);
    v->square = v->x * v->x + v->y * v->y;
    const int degree = (std::max)(v->bend.degree(), v->square.degree());
    v->bend = v->bend.elevated(degree);
    v->square = v->square.elevated(degree);
  }
  if (f.tight_first) return {std::move(start), std::move(end), way};
  return {std::move(end), std::move(start), -way};
}

/// The curve keeps to the side given (+1 inside) of the circle that touches it at the tight or flat end and passes
/// through the other one, where bend - k square is 0.
[[nodiscard]] inline Proof prove_chord_circle(const Containment_piece& piece, bool at_tight, int side,
                                              const Parameter_range& range) {
  const End_view& v = at_tight ? piece.tight : piece.flat;
  const auto &bend = v.bend.scaled_coefficients(), &square = v.square.scaled_coefficients();
  const Integer &a = at_tight ? square.back() : square.front(), &b = at_tight ? bend.back() : bend.front();
  return prove_nonnegative_but_at_ends(Integer(side) * (a * v.bend - b * v.square), range);
}

/// The piece, straight by the shape's turn 0, lies on its chord when every vector is parallel to it and it leaves
/// neither end.
[[nodiscard]] inline Proof prove_on_chord(const Containment_piece& piece, const Parameter_range& range) {
  const auto is_zero = [](const Integer_polynomial& p) { return internal::sign_variations(p).first == 0; };
  if (!is_zero(piece.tight.along(perp(piece.chord)))) return Proof::DISPROVED;
  if (piece.chord == Xy<Integer>{} && !(is_zero(piece.tight.x) && is_zero(piece.tight.y))) return Proof::DISPROVED;
  const Proof ahead = prove_nonnegative_but_at_ends(piece.tight.along(piece.chord), range);
  return ahead == Proof::PROVEN ? prove_nonnegative_but_at_ends(piece.flat.along(-piece.chord), range) : ahead;
}

/// The piece lies in the disc over the chord: what it has come and what it has to go make no sharp angle.
[[nodiscard]] inline Proof prove_disc(const Containment_piece& piece, const Parameter_range& range) {
  const End_view &from = piece.tight, &to = piece.flat;
  return prove_nonnegative_but_at_ends(Integer(-1) * (from.x * to.x + from.y * to.y), range);
}

/// Outside the circle at the flat end and inside the one at the tight end.
[[nodiscard]] inline Proof prove_bca(const Containment_piece& piece, const Chord_shape_2<Rational>& f,
                                     const Parameter_range& range) {
  if (!f.runs_ahead) return prove_disc(piece, range);
  if (f.turn == 0) return prove_on_chord(piece, range);
  const Proof outer = prove_chord_circle(piece, true, +1, range);
  return outer == Proof::PROVEN ? prove_chord_circle(piece, false, -1, range) : outer;
}

/// The curve keeps to the left of a circle or a line through its ends, or with side -1 to the right.
[[nodiscard]] inline Proof prove_side(const Containment_piece& piece, const Chord_shape_2<Rational>& f,
                                      const Contact_circle_2<Rational>& circle, int side,
                                      const Parameter_range& range) {
  const End_view& v = piece.tight;
  const Xy<Rational> tight_end = f.tight_first ? Xy<Rational>{} : f.chord, n = circle.normal_at(tight_end);
  // side(q) of Contact_circle_2 for q = tight_end + scale (x, y) / weight, times weight^2 and what clears denominators
  const std::vector<Integer> c =
      cleared<Rational>({circle.side(tight_end), Rational(2 * v.scale * n.x), Rational(2 * v.scale * n.y),
                         Rational(circle.curvature * v.scale * v.scale)})
          .numbers;
  return prove_nonnegative_but_at_ends(
      Integer(side) *
          (c[0] * (v.weight * v.weight) + v.weight * (c[1] * v.x + c[2] * v.y) - c[3] * (v.x * v.x + v.y * v.y)),
      range);
}

/// Between the two arcs, over the chord, of one's own construction: of two circles through the same points what is
/// inside of the one and outside of the other is between their arcs.
[[nodiscard]] inline Proof prove_between_arcs(const internal::Proven_construction& construction,
                                              const Containment_piece& piece, Chord_shape_2<Rational> f,
                                              const Parameter_range& range) {
  f.unit = 1;
  const auto region = construction.exact(f.at_origin());
  const auto is_over_chord = [&](const Boundary_chain_2<Rational>& side) {
    return side.size() == 1 && side[0].from == Xy<Rational>{} && side[0].to == f.chord;
  };
  if (!is_over_chord(region.inner) || !is_over_chord(region.outer)) return Proof::UNDECIDED;
  if (f.turn == 0 && f.runs_ahead) return prove_on_chord(piece, range);
  const int turn = f.turn < 0 ? -1 : 1;
  const Proof outer = prove_side(piece, f, region.outer[0].support, turn, range);
  return outer == Proof::PROVEN ? prove_side(piece, f, region.inner[0].support, -turn, range) : outer;
}

// Shapes of pieces that were cut a little past a vertex.

// Past a vertex by a few spacings of parameters the curvature exceeds its end value, by about the square of that
// spacing over the piece's length as a share of what it differs from the chord circle's; more where it changes quickly.
// Each share is tried in turn while the region stays thin enough. The first adds no more than 2^-44 of itself to a
// region's thickness.
inline constexpr double SLIVER_SLACKS[] = {0x1p-44, 0x1p-24, 0x1p-10, 0x1p-4};

/// The shape with the tight end's curvature raised and the flat end's lowered, each by a share of how far it is from
/// that of the circle over the chord: a region that holds the curve although an end was cut past a vertex.
[[nodiscard]] inline Chord_shape_2<Rational> with_curvature_bounds(Chord_shape_2<Rational> f, double share) {
  const Rational cc = dot(f.chord, f.chord);
  if (!f.infinite0) {
    f.curvature0 += Rational(share) * f.kneser0 / cc;
    f.kneser0 *= Rational(1 + share);
  }
  if (!f.infinite1) {
    f.curvature1 -= Rational(share) * f.kneser1 / cc;
    f.kneser1 *= Rational(1 + share);
  }
  return f;
}

}  // namespace CGAL::Bounding_arcs::verify

#endif
