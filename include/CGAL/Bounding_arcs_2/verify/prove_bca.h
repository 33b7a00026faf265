// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Containment in BCA: for each of the two circles the side of the curve is a polynomial with a double root where the
// circle touches and a simple one at the other end; what is left after dividing them out must keep one sign.
// The two circles meet in the end points only, so a curve that crosses neither stays in the lune between their arcs.

#ifndef CGAL_BOUNDING_ARCS_2_VERIFY_PROVE_BCA_H
#define CGAL_BOUNDING_ARCS_2_VERIFY_PROVE_BCA_H

#include <CGAL/Bounding_arcs_2/verify/Containment_piece.h>

namespace CGAL::Bounding_arcs::verify {

/// The side of the circle that touches at this view's end and passes through the other end, over all its roots at the
/// ends: |chord|^2 2 inward q - 2 (inward chord) |q|^2. Empty when it vanishes identically: the curve is the arc
/// itself.
[[nodiscard]] inline Rational_polynomial chord_circle_side(const End_view& v) {
  const Contact_polynomials c = contact_polynomials(v);
  const Rational k = 2 * dot(v.inward, v.chord) / dot(v.chord, v.chord);  // = curvature |inward|
  const Rational_polynomial side = contact_side(c, k, [](const Rational& x) { return x; });
  return without_roots_at_one(without_leading_zeros(side, leading_zeros(side)));
}

/// The curve keeps to the side given (+1 inside) of its chord circle: strictly, or it runs on the circle.
[[nodiscard]] inline Proof prove_chord_circle(const End_view& v, int side) {
  const Rational_polynomial p = chord_circle_side(v);
  return p.empty() ? Proof::PROVEN : prove_sign(p, side, v.low, v.high);
}

/// The piece, straight by the shape's turn 0, lies on its chord when every vector is parallel to it and it leaves
/// neither end.
[[nodiscard]] inline Proof prove_on_chord(const End_view& v) {
  for (const Rational& c : v.along(perp(v.chord)))
    if (c != 0) return Proof::DISPROVED;
  const Rational_polynomial way = v.along(v.chord);
  const std::size_t n = leading_zeros(way);
  if (n == way.size())
    return leading_zeros(v.x) == n && leading_zeros(v.y) == n ? Proof::PROVEN : Proof::DISPROVED;  // a point
  Rational_polynomial rest;
  for (std::size_t k = 0; k < (std::max)(way.size(), v.weight.size()); ++k)
    rest.push_back(Rational((k < v.weight.size() ? Rational(dot(v.chord, v.chord) * v.weight[k]) : Rational(0)) -
                            (k < way.size() ? Rational(v.scale * way[k]) : Rational(0))));
  const Proof ahead = prove_sign(without_leading_zeros(way, n), +1, v.low, v.high);
  return ahead == Proof::PROVEN ? prove_sign(without_roots_at_one(rest), +1, v.low, v.high) : ahead;
}

/// The piece lies in the disc over the chord: q * (chord - q) >= 0.
[[nodiscard]] inline Proof prove_disc(const End_view& v) {
  const Rational_polynomial x = product(v.x, v.x), y = product(v.y, v.y), way = product(v.weight, v.along(v.chord));
  Rational_polynomial p((std::max)(x.size(), way.size()), Rational(0));
  for (std::size_t k = 0; k < way.size(); ++k) p[k] += way[k];
  for (std::size_t k = 0; k < x.size(); ++k) p[k] -= v.scale * (x[k] + y[k]);
  const Rational_polynomial rest = without_roots_at_one(without_leading_zeros(p, leading_zeros(p)));
  return rest.empty() ? Proof::PROVEN : prove_sign(rest, +1, v.low, v.high);
}

/// Outside the circle at the flat end and inside the one at the tight end.
[[nodiscard]] inline Proof prove_bca(const End_view& tight, const End_view& flat, const Chord_shape_2<Rational>& f) {
  if (!f.runs_ahead) return prove_disc(tight);
  if (f.turn == 0) return prove_on_chord(tight);
  const Proof outer = prove_chord_circle(tight, +1);
  return outer == Proof::PROVEN ? prove_chord_circle(flat, -1) : outer;
}

}  // namespace CGAL::Bounding_arcs::verify

#endif
