// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Containment in BCA: for each of the two circles the side of the curve is a polynomial with a double root where the
// circle touches and a simple one at the other end; what is left after dividing them out must keep one sign.
// The two circles meet in the end points only, so a curve that crosses neither stays in the lune between their arcs.

#ifndef CGAL_BOUNDING_ARCS_2_VERIFY_INTERNAL_PROVE_BCA_H
#define CGAL_BOUNDING_ARCS_2_VERIFY_INTERNAL_PROVE_BCA_H

#include <CGAL/Bounding_arcs_2/verify/internal/Containment_piece.h>

namespace CGAL::Bounding_arcs::verify {

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
  const auto is_zero = [](const Integer_polynomial& p) { return sign_variations(p).first == 0; };
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

}  // namespace CGAL::Bounding_arcs::verify

#endif
