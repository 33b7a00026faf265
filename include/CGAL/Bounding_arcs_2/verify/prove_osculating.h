// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Containment in spiral fat arcs and bilens.  Each boundary is two pieces with a joint.  The piece on an osculating
// circle is proven in rational arithmetic (the triple root divides out exactly); the other piece and the joint hold
// square roots and are proven in MPFR intervals of rising precision:
//   a parameter s splits the curve: on one part it keeps to its side of the second piece's circle or line, on the other
//   it has not yet passed the normal line at the joint, beyond which that second piece lies.
// So the curve, which starts between the two boundaries, crosses neither.

#ifndef CGAL_BOUNDING_ARCS_2_VERIFY_PROVE_OSCULATING_H
#define CGAL_BOUNDING_ARCS_2_VERIFY_PROVE_OSCULATING_H

#include <CGAL/Bounding_arcs_2/region/Bilens.h>
#include <CGAL/Bounding_arcs_2/region/Spiral_fat_arc.h>
#include <CGAL/Bounding_arcs_2/verify/prove_bca.h>

#include <algorithm>
#include <cstddef>
#include <optional>

namespace CGAL::Bounding_arcs::verify {

using Interval_polynomial = Power_polynomial<Mpfr_interval>;

/// Two views of a strict spiral piece and, in intervals of one precision, its boundary as the construction makes it,
/// with the piece's start at the origin and lengths in units of the shape.
class Osculating_proof {
 public:
  template <class Construction>
  Osculating_proof(const Construction& construction, const End_view& tight, const End_view& flat,
                   const Chord_shape_2<Rational>& f, mpfr_prec_t precision)
      : tight_(tight), flat_(flat), f_(f), precision_(precision) {
    Chord_shape_2<Rational> shape = f;
    shape.unit = 1;
    Chord_frame_2<Mpfr_interval> frame;
    frame.shape = convert_shape<Mpfr_interval>(shape, [&](const Rational& x) { return interval(x); });
    frame.p1 = frame.shape.chord;
    boundary_ = construction.boundary(frame);
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
    Proof proof =
        !infinite ? prove_osculating(tight_, k_tight, -1) : (segments ? prove_chord() : prove_chord_circle(flat_, -1));
    if (proof == Proof::PROVEN && !infinite) proof = prove_inner_joint(segments);
    // outer: the flat end's osculating circle, and before it a contact circle or the tangent at the tight end
    if (proof == Proof::PROVEN) proof = prove_osculating(flat_, k_flat, +1);
    if (proof == Proof::PROVEN) proof = segments ? prove_tangent() : prove_outer_joint();
    return proof;
  }

 private:
  using Piece = Boundary_piece_2<Mpfr_interval>;

  [[nodiscard]] Mpfr_interval interval(const Rational& x) const { return Mpfr_interval(x, precision_); }
  // Of a chain of two, the piece at the tight or flat end, and the joint.
  [[nodiscard]] const Piece& piece_at(const Boundary_chain_2<Mpfr_interval>& chain, bool tight) const {
    return chain[tight == f_.tight_first ? 0 : 1];
  }
  [[nodiscard]] static const Xy<Mpfr_interval>& joint(const Boundary_chain_2<Mpfr_interval>& chain) {
    return chain[0].to;
  }
  [[nodiscard]] Xy<Mpfr_interval> from_tight_end(const Xy<Mpfr_interval>& p) const { return p - tight_end_; }

  // curvature of the shape: K = curvature c / n^3, so curvature |inward| is 2 curvature / n^2 in the shape's units
  [[nodiscard]] Proof prove_osculating(const End_view& v, const Rational& curvature, int side) const {
    const Rational k = Rational(f_.turn) * 2 * curvature / dot(v.tangent, v.tangent);
    const Rational_polynomial p = contact_side(contact_polynomials(v), k, [](const Rational& x) { return x; });
    return prove_sign(without_leading_zeros(p, (std::min)(leading_zeros(p), p.size() - 1)), side, v.low, v.high);
  }
  // On the outer side of the chord, the roots at its ends divided out.
  [[nodiscard]] Proof prove_chord() const {
    const Rational_polynomial p = tight_.along(Rational(f_.tight_first ? f_.turn : -f_.turn) * perp(tight_.chord));
    return prove_sign(without_roots_at_one(without_leading_zeros(p, leading_zeros(p))), -1, tight_.low, tight_.high);
  }
  // On the inner side of the tight end's tangent.
  [[nodiscard]] Proof prove_tangent() const {
    const Rational_polynomial p = tight_.along(tight_.inward);
    return prove_sign(without_leading_zeros(p, leading_zeros(p)), +1, tight_.low, tight_.high);
  }

  // The side of the contact circle of a piece that touches the curve at this end.
  [[nodiscard]] Interval_polynomial contact(const End_view& v, const Piece& piece) const {
    const Mpfr_interval length = sqrt(interval(dot(v.tangent, v.tangent)));
    const Mpfr_interval k =
        Mpfr_interval(f_.turn) * piece.support.curvature * length;  // the support's normal has length 1
    return contact_side(contact_polynomials(v), k, [&](const Rational& x) { return interval(x); });
  }

  [[nodiscard]] Proof prove_inner_joint(bool is_segment) const {
    const Piece& second = piece_at(boundary_.inner, false);
    const Xy<Mpfr_interval> j = joint(boundary_.inner);
    if (!is_segment) return prove_joint(contact(flat_, second), false, -1, passed(second, j));
    // the segment's line through the flat end: cross of its direction, seen from the tight end, with the curve
    const Xy<Mpfr_interval> line = f_.tight_first ? second.to - second.from : second.from - second.to;
    Interval_polynomial beyond;
    std::size_t first = 1;  // where C' vanishes at the flat end the line is met more than once there
    while (first + 1 < flat_.x.size() && flat_.x[first] == 0 && flat_.y[first] == 0) ++first;
    for (std::size_t k = first; k < flat_.x.size(); ++k)
      beyond.push_back(Mpfr_interval(f_.tight_first ? f_.turn : -f_.turn) *
                       (line.x * interval(flat_.y[k]) - line.y * interval(flat_.x[k])));
    return prove_joint(beyond, false, -1, passed(line, j));
  }
  [[nodiscard]] Proof prove_outer_joint() const {
    const Piece& first = piece_at(boundary_.outer, true);
    return prove_joint(contact(tight_, first), true, +1, passed(first, joint(boundary_.outer)));
  }

  // Positive where the curve has passed the normal line at the joint: of a circle, or in a direction.
  [[nodiscard]] Interval_polynomial passed(const Piece& circle, const Xy<Mpfr_interval>& j) const {
    const Xy<Mpfr_interval> n = circle.support.normal_at(j);
    const Xy<Mpfr_interval> tangent{n.y, -n.x};
    return passed(f_.tight_first ? tangent : -tangent, j);
  }
  [[nodiscard]] Interval_polynomial passed(const Xy<Mpfr_interval>& direction, const Xy<Mpfr_interval>& j) const {
    const Mpfr_interval level = dot(direction, from_tight_end(j)), scale = interval(tight_.scale);
    Interval_polynomial p;
    for (std::size_t i = 0; i < (std::max)(tight_.x.size(), tight_.weight.size()); ++i) {
      Mpfr_interval c(0);
      if (i < tight_.x.size()) c = scale * (direction.x * interval(tight_.x[i]) + direction.y * interval(tight_.y[i]));
      if (i < tight_.weight.size()) c = c - level * interval(tight_.weight[i]);
      p.push_back(c);
    }
    return p;
  }

  // A piece that ends at a joint, at the tight end or, its polynomial then in 1 - s, at the flat end: on the joint's
  // one side the curve keeps to the piece's side, on the other it lies beyond the normal line at the joint, where the
  // piece is not.
  [[nodiscard]] Proof prove_joint(const Interval_polynomial& piece, bool at_tight, int side,
                                  const Interval_polynomial& passed) const {
    const std::optional<Rational> s = parameter_between(piece, at_tight, side, passed);
    if (!s) return Proof::UNDECIDED;
    const Mpfr_interval split = interval(*s), rest = interval(Rational(1 - *s)), low = interval(tight_.low),
                        high = interval(tight_.high);
    const Proof kept =
        at_tight ? prove_sign(piece, side, low, split) : prove_sign(piece, side, interval(flat_.low), rest);
    if (kept != Proof::PROVEN) return kept;
    return at_tight ? prove_sign(passed, +1, split, high) : prove_sign(passed, -1, low, split);
  }

  // A parameter from the tight end at which the curve is on the piece's side and the normal line at the joint lies
  // between it and the piece.  Found by halving: where the piece comes first the curve passes the normal before it
  // leaves the piece's circle, where it comes last it enters before it passes.
  [[nodiscard]] std::optional<Rational> parameter_between(const Interval_polynomial& piece, bool at_tight, int side,
                                                          const Interval_polynomial& passed) const {
    Rational low = tight_.low, high = tight_.high;
    for (mpfr_prec_t i = 0; i < precision_; ++i) {
      const Rational s = (low + high) / 2;
      const bool on_side = value_at(piece, interval(at_tight ? s : Rational(1 - s))).certain_sign() == side;
      const bool beyond = value_at(passed, interval(s)).certain_sign() == (at_tight ? 1 : -1);
      if (on_side && beyond) return s;
      if (at_tight ? !beyond : !on_side) low = s;
      else high = s;
    }
    return std::nullopt;
  }

  const End_view& tight_;
  const End_view& flat_;
  const Chord_shape_2<Rational>& f_;
  mpfr_prec_t precision_;
  Region_boundary_2<Mpfr_interval> boundary_;
  Xy<Mpfr_interval> tight_end_;
};

}  // namespace CGAL::Bounding_arcs::verify

#endif
