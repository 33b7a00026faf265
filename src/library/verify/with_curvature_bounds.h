// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shapes of pieces that were cut a little past a vertex.

#ifndef BOUNDING_ARCS_LIBRARY_VERIFY_WITH_CURVATURE_BOUNDS_H
#define BOUNDING_ARCS_LIBRARY_VERIFY_WITH_CURVATURE_BOUNDS_H

#include <CGAL/Bounding_arcs_2/frame/Chord_frame_2.h>
#include "prove_bca.h"

namespace CGAL::Bounding_arcs::verify {

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
