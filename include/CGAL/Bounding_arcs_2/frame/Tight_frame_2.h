// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The chord frame seen from its tight end, as if the curve turned left: the eight cases (mirrored, reversed, tight end
// first or last) become one, and spiral fat arcs and bilens are each written once.  Boundaries in the plane are made
// with region/Tight_axes.h.  Needs square roots.

#ifndef CGAL_BOUNDING_ARCS_2_FRAME_TIGHT_FRAME_2_H
#define CGAL_BOUNDING_ARCS_2_FRAME_TIGHT_FRAME_2_H

#include <CGAL/Bounding_arcs_2/frame/Chord_frame_2.h>
#include <CGAL/Bounding_arcs_2/number/Bounded_double.h>
#include <CGAL/Bounding_arcs_2/number/Double_double.h>
#include <CGAL/Bounding_arcs_2/number/number_types.h>

namespace CGAL::Bounding_arcs {

/// Scalars of the frame with the tight end first and a left turn; lengths are lengths of the plane.
template <class NT> struct Tight_frame_2 {
  NT chord{0};
  NT sin_tight{0}, cos_tight{0}, sin_flat{0}, cos_flat{0};  ///< of the chord-tangent angles at the two ends
  NT sin_delta{0}, cos_delta{0}, sin_mean{0}, cos_mean{0};  ///< of half the difference and half the sum of them
  NT sin_difference{0};                                     ///< of the difference of them, 2 sin_delta cos_delta
  NT k_tight{0}, k_flat{0};                                 ///< curvature times half the chord, unsigned for a spiral
  NT a{0}, b{0};                                            ///< k_tight - sin_tight, sin_flat - k_flat
  bool infinite = false;                                    ///< the tight end's curvature is infinite; a, k_tight are 0
  bool usable = false;                                      ///< a, b > 0 and a b >= sin^2 delta: the constructions hold

  /// K of the circle that touches the curve at the flat end and the tight end's osculating circle:
  /// sin alpha1 - sin^2 delta / a, as a sum; at most sin alpha1, which bounds it where rounding takes a and b.
  [[nodiscard]] NT contact_flat() const {
    if (infinite) return sin_flat;
    const NT k = NT(k_flat + b * (NT(1) - sin_delta / a * (sin_delta / b)));
    return limited(k, [&] { return sin_flat; });
  }
};

template <class NT> [[nodiscard]] Tight_frame_2<NT> tight_frame(const Chord_shape_2<NT>& f) {
  Tight_frame_2<NT> t;
  if (!f.proper) return t;
  const Chord_angles_2<NT> g = f.angles();
  const NT turn = NT(f.turn), swap = NT(f.tight_first ? f.turn : -f.turn);
  const NT bulge_tight = turn * (f.tight_first ? g.bulge0 : g.bulge1);
  const NT bulge_flat = turn * (f.tight_first ? g.bulge1 : g.bulge0);
  const NT square_tight = NT(1) + bulge_tight * bulge_tight, square_flat = NT(1) + bulge_flat * bulge_flat;
  const NT cosines = NT(1) / square_root(NT(square_tight * square_flat));  // cos(alpha0/2) cos(alpha1/2)
  t.chord = g.chord * f.unit;
  t.sin_tight = NT(2) * bulge_tight / square_tight;
  t.cos_tight = (NT(1) - bulge_tight * bulge_tight) / square_tight;
  t.sin_flat = NT(2) * bulge_flat / square_flat;
  t.cos_flat = (NT(1) - bulge_flat * bulge_flat) / square_flat;
  t.sin_delta = swap * g.bulge_change * cosines;
  t.sin_difference = swap * f.sine_change / (g.length0 * g.length1 * dot(f.chord, f.chord));
  t.cos_delta = (NT(1) + bulge_tight * bulge_flat) * cosines;
  t.sin_mean = (bulge_tight + bulge_flat) * cosines;
  t.cos_mean = (NT(1) - bulge_tight * bulge_flat) * cosines;
  const NT cube0 = dot(f.tangent0, f.tangent0) * g.length0, cube1 = dot(f.tangent1, f.tangent1) * g.length1;
  const NT k0 = turn * f.curvature0 * g.chord / cube0, k1 = turn * f.curvature1 * g.chord / cube1;
  const NT kneser0 = swap * f.kneser0 / (cube0 * g.chord), kneser1 = swap * f.kneser1 / (cube1 * g.chord);
  t.k_tight = f.tight_first ? k0 : k1;
  t.k_flat = f.tight_first ? k1 : k0;
  t.a = f.tight_first ? kneser0 : kneser1;
  t.b = f.tight_first ? kneser1 : kneser0;
  t.infinite = f.tight_first ? f.infinite0 : f.infinite1;
  // by value; for enclosures that leave it open the comparison throws
  t.usable = t.sin_delta > NT(0) && t.b > NT(0) &&
             (t.infinite || (t.a > NT(0) && !(NT(1) < NT(t.sin_delta / t.a * (t.sin_delta / t.b)))));
  return t;
}

}  // namespace CGAL::Bounding_arcs

#endif
