// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Circular arcs as rational quadratic Bezier curves.  With b the bulge and D the chord, the tangents at the ends meet
// at the middle of the chord less b / (1 - b^2) perp(D), and the weights are 1 + b^2, 1 - b^2, 1 + b^2: all are
// rational.

#ifndef CGAL_BOUNDING_ARCS_2_ARC_ARC_BEZIERS_H
#define CGAL_BOUNDING_ARCS_2_ARC_ARC_BEZIERS_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/number/Xy.h>

#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

namespace internal {
/// The point of an arc that comes after its share with the bulge `part`, and the bulge of the rest, over a field.
///
/// The chord to that point is the whole one turned by the difference of the angles between chords and tangents,
/// 2 atan part - 2 atan bulge, and shorter as their sines are.
template <class NT> struct Arc_cut {
  Xy<NT> point;
  NT rest;
};
/// \pre 0 < part / bulge < 1
template <class NT>
[[nodiscard]] Arc_cut<NT> cut_arc(const Xy<NT>& from, const Xy<NT>& to, const NT& bulge, const NT& part) {
  const NT one(1), m = one - bulge * bulge, p = one + bulge * bulge, k = one - part * part, q = one + part * part;
  const NT share = part * p / (bulge * q);  // of sines, 2 x / (1 + x^2)
  const NT cosine = (k * m + NT(4) * part * bulge) / (p * q), sine = NT(2) * (part * m - bulge * k) / (p * q);
  const Xy<NT> chord = to - from;
  return {from + share * (cosine * chord + sine * perp(chord)), NT((bulge - part) / (one + bulge * part))};
}
}  // namespace internal

/// The arc `from` -> `to` that turns by 4 atan(bulge), to the left for a positive bulge, as one curve for at most a
/// quarter of a circle, else two; of degree 1 for a bulge of 0.
/// \pre |bulge| <= 1
/// \guarantee exact over a field, with the ends themselves; over double rounded by some ulp
template <class NT>
[[nodiscard]] std::vector<Bezier_curve_2<NT>> arc_beziers(const Xy<NT>& from, const Xy<NT>& to, const NT& bulge) {
  constexpr double QUARTER = 0.41421356237309515;  // no less than tan(pi / 8), which is irrational
  std::vector<Bezier_curve_2<NT>> curves;
  if (bulge == NT(0)) {
    curves.push_back(Bezier_curve_2<NT>({from, to}));
    return curves;
  }
  const auto add = [&](const Xy<NT>& p, const Xy<NT>& q, const NT& b) {
    const NT outer = NT(1) + b * b, inner = NT(1) - b * b;
    const Xy<NT> chord = q - p, corner = NT(NT(1) / NT(2)) * (p + q) - NT(b / inner) * perp(chord);
    curves.push_back(Bezier_curve_2<NT>({p, corner, q}, {NT(1), NT(inner / outer), NT(1)}));
  };
  if (!(NT(QUARTER) < bulge) && !(bulge < NT(-QUARTER))) {
    add(from, to, bulge);
  } else {
    const NT half(bulge < NT(0) ? -0.375 : 0.375);  // near half of half a circle; less than any bulge that comes here
    const internal::Arc_cut<NT> cut = internal::cut_arc<NT>(from, to, bulge, half);
    add(from, cut.point, half);
    add(cut.point, to, cut.rest);
  }
  return curves;
}

}  // namespace CGAL::Bounding_arcs

#endif
