// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Containment in spiral fat arcs and bilens.  Each boundary is two pieces with a joint.  The piece on an osculating
// circle is proven over integers (the triple root divides out exactly); the other piece and the joint hold
// square roots and are proven in MPFR intervals of rising precision:
//   a parameter s splits the curve: on one part it keeps to its side of the second piece's circle or line, on the other
//   it has not yet passed the normal line at the joint, beyond which that second piece lies.
// So the curve, which starts between the two boundaries, crosses neither.

#ifndef BOUNDING_ARCS_LIBRARY_VERIFY_OSCULATING_PROOF_H
#define BOUNDING_ARCS_LIBRARY_VERIFY_OSCULATING_PROOF_H

#include <CGAL/Bounding_arcs_2/number/Mpfr_interval.h>
#include <CGAL/Bounding_arcs_2/region/Contact_circle_2.h>
#include <CGAL/Bounding_arcs_2/verify/verify_region.h>
#include "prove_bca.h"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::verify {

using Interval_polynomial = Bernstein_polynomial<Mpfr_interval>;

/// A strict spiral piece and, in intervals of one precision, its boundary as the construction makes it, with the
/// piece's start at the origin and lengths in units of the shape.
class Osculating_proof {
 public:
  Osculating_proof(const internal::Proven_construction& construction, const Containment_piece& piece,
                   const Chord_shape_2<Rational>& f, const Parameter_range& range, mpfr_prec_t precision)
      : piece_(piece), tight_(piece.tight), flat_(piece.flat), f_(f), range_(range), precision_(precision) {
    const Chord_frame_2<Mpfr_interval> frame = enclosed_frame(f, precision);
    boundary_ = construction.enclosed(frame);
    tight_end_ = f.tight_first ? frame.p0 : frame.p1;
  }

  /// What the construction came out as: BCA where its own is not defined.
  [[nodiscard]] Region_form form() const { return boundary_.form; }

  /// Neither boundary is crossed. \pre form() is SPIRAL_FAT_ARC or BILENS
  [[nodiscard]] Proof contained() const {
    const bool segments = form() == Region_form::SPIRAL_FAT_ARC,
               infinite = f_.tight_first ? f_.infinite0 : f_.infinite1;
    const Rational k_tight = f_.tight_first ? f_.curvature0 : f_.curvature1;
    const Rational k_flat = f_.tight_first ? f_.curvature1 : f_.curvature0;
    // inner: the tight end's osculating circle and what follows it; where that circle is a point, the one piece left
    Proof proof = !infinite ? prove_osculating(tight_, k_tight, -1)
                            : (segments ? prove_chord() : prove_chord_circle(piece_, false, -1, range_));
    if (proof == Proof::PROVEN && !infinite) proof = prove_inner_joint(segments);
    // outer: the flat end's osculating circle, and before it a contact circle or the tangent at the tight end
    if (proof == Proof::PROVEN) proof = prove_osculating(flat_, k_flat, +1);
    if (proof == Proof::PROVEN) proof = segments ? prove_tangent() : prove_outer_joint();
    return proof;
  }

 private:
  using Piece = Boundary_piece_2<Mpfr_interval>;

  [[nodiscard]] Mpfr_interval interval(const Rational& x) const { return Mpfr_interval(x, precision_); }
  [[nodiscard]] Interval_polynomial interval(const Integer_polynomial& p) const {
    std::vector<Mpfr_interval> c;
    for (const Integer& x : p.scaled_coefficients()) c.push_back(interval(Rational(x)));
    return Interval_polynomial::from_scaled(std::move(c));
  }
  // The piece at the tight or flat end of a chain of two, and the joint.
  [[nodiscard]] const Piece& piece_at(const Boundary_chain_2<Mpfr_interval>& chain, bool tight) const {
    return chain[tight == f_.tight_first ? 0 : 1];
  }
  [[nodiscard]] static const Xy<Mpfr_interval>& joint(const Boundary_chain_2<Mpfr_interval>& chain) {
    return chain[0].to;
  }
  // of lines from the tight end to the flat one: left where the curve turns left on the way
  [[nodiscard]] int turn() const { return f_.tight_first ? f_.turn : -f_.turn; }

  // curvature of the shape: K = curvature c / n^3, so curvature |tangent| is 2 curvature / n^2 in the shape's units
  [[nodiscard]] Proof prove_osculating(const End_view& v, const Rational& curvature, int side) const {
    const std::vector<Integer> k = cleared<Rational>({dot(v.tangent, v.tangent), Rational(f_.turn) * 2 * curvature *
                                                                                     Rational(v.stretch) * v.scale})
                                       .numbers;
    return prove_nonnegative_but_at_ends(Integer(side) * (k[0] * v.bend - k[1] * v.square), range_);
  }
  // Proves that the piece is on the outer side of the chord.
  [[nodiscard]] Proof prove_chord() const {
    return prove_nonnegative_but_at_ends(Integer(-turn()) * tight_.along(perp(piece_.chord)), range_);
  }
  // Proves that the piece is on the inner side of the tight end's tangent.
  [[nodiscard]] Proof prove_tangent() const {
    return prove_nonnegative_but_at_ends(tight_.along(tight_.inward), range_);
  }

  // The side of the contact circle of a piece that touches the curve at this end.
  [[nodiscard]] Interval_polynomial contact(const End_view& v, const Piece& piece, bool at_tight) const {
    const Xy<Mpfr_interval> inward{interval(Rational(v.inward.x)), interval(Rational(v.inward.y))};
    const Mpfr_interval k = Mpfr_interval(f_.turn) * piece.support.curvature * sqrt(dot(inward, inward)) *
                            interval(v.scale);  // the support's normal has length 1
    const std::size_t n = common_zeros(v.bend, v.square, at_tight);
    return without_roots(interval(v.bend) - k * interval(v.square), at_tight ? n : 0, at_tight ? 0 : n);
  }

  [[nodiscard]] Proof prove_inner_joint(bool is_segment) const {
    const Piece& second = piece_at(boundary_.inner, false);
    const Xy<Mpfr_interval> j = joint(boundary_.inner);
    if (!is_segment) return prove_joint(contact(flat_, second, false), false, -1, passed(second, j));
    // the segment's line through the flat end: cross of its direction, seen from the tight end, with the curve
    const Xy<Mpfr_interval> line = f_.tight_first ? second.to - second.from : second.from - second.to;
    const Interval_polynomial beyond =
        Mpfr_interval(turn()) * (line.x * interval(flat_.y) - line.y * interval(flat_.x));
    return prove_joint(without_roots(beyond, 0, common_zeros(flat_.x, flat_.y, false)), false, -1, passed(line, j));
  }
  [[nodiscard]] Proof prove_outer_joint() const {
    const Piece& first = piece_at(boundary_.outer, true);
    return prove_joint(contact(tight_, first, true), true, +1, passed(first, joint(boundary_.outer)));
  }

  // Positive where the curve has passed the normal line at the joint: of a circle, or in a direction.
  [[nodiscard]] Interval_polynomial passed(const Piece& circle, const Xy<Mpfr_interval>& j) const {
    const Xy<Mpfr_interval> n = circle.support.normal_at(j);
    const Xy<Mpfr_interval> tangent{n.y, -n.x};
    return passed(f_.tight_first ? tangent : -tangent, j);
  }
  [[nodiscard]] Interval_polynomial passed(const Xy<Mpfr_interval>& direction, const Xy<Mpfr_interval>& j) const {
    const Mpfr_interval level = dot(direction, j - tight_end_);
    return interval(tight_.scale) * (direction.x * interval(tight_.x) + direction.y * interval(tight_.y)) -
           level * interval(tight_.weight);
  }

  // A piece that ends at a joint, at the tight or at the flat end: on the joint's one side the curve keeps to the
  // piece's side, on the other it lies beyond the normal line at the joint, where the piece is not.
  [[nodiscard]] Proof prove_joint(const Interval_polynomial& piece, bool at_tight, int side,
                                  const Interval_polynomial& passed) const {
    const Interval_polynomial on_side = Mpfr_interval(side) * piece, beyond = Mpfr_interval(at_tight ? 1 : -1) * passed;
    const std::optional<Rational> s = parameter_between(on_side, beyond, at_tight);
    if (!s) return Proof::UNDECIDED;
    const Proof kept = prove_between(on_side, at_tight ? range_.low : *s, at_tight ? *s : range_.high);
    return kept == Proof::PROVEN ? prove_between(beyond, at_tight ? *s : range_.low, at_tight ? range_.high : *s)
                                 : kept;
  }
  [[nodiscard]] Proof prove_between(const Interval_polynomial& p, const Rational& low, const Rational& high) const {
    return prove_nonnegative(
        p.restricted(interval(low), interval(Rational(1 - low)), interval(high), interval(Rational(1 - high))));
  }

  // A parameter at which the curve is on the piece's side and the normal line at the joint lies between it and the
  // piece.  Found by halving: where the piece comes first the curve passes the normal before it leaves the piece's
  // circle, where it comes last it enters before it passes.
  [[nodiscard]] std::optional<Rational> parameter_between(const Interval_polynomial& on_side,
                                                          const Interval_polynomial& beyond, bool at_tight) const {
    Rational low = range_.low, high = range_.high;
    for (mpfr_prec_t i = 0; i < precision_; ++i) {
      const Rational s = (low + high) / 2;
      const Mpfr_interval t = interval(s), rest = interval(Rational(1 - s));
      const bool is_on_side = on_side.homogeneous_value(t, rest).certain_sign() > 0;
      const bool is_beyond = beyond.homogeneous_value(t, rest).certain_sign() > 0;
      if (is_on_side && is_beyond) return s;
      if (at_tight ? !is_beyond : !is_on_side) low = s;
      else high = s;
    }
    return std::nullopt;
  }

  const Containment_piece& piece_;
  const End_view& tight_;
  const End_view& flat_;
  const Chord_shape_2<Rational>& f_;
  const Parameter_range& range_;
  mpfr_prec_t precision_;
  Region_boundary_2<Mpfr_interval> boundary_;
  Xy<Mpfr_interval> tight_end_;
};

}  // namespace CGAL::Bounding_arcs::verify

#endif
