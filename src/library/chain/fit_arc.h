// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which arc, and which biarc, to put over a piece of a spiral segment (doc/arcs.md).  What is chosen here only decides
// how close the result is; how close it is, is bounded afterwards by arc_deviation.h.

#ifndef BOUNDING_ARCS_LIBRARY_CHAIN_FIT_ARC_H
#define BOUNDING_ARCS_LIBRARY_CHAIN_FIT_ARC_H

#include "Local_polynomial.h"

#include <cmath>
#include <optional>

namespace CGAL::Bounding_arcs::internal {

/// tan(angle / 2) from u to v, positive when v is to the left. \pre the angle is below half a turn
[[nodiscard]] inline double half_angle_tangent(const Xy<double>& u, const Xy<double>& v) {
  return cross(u, v) / (std::sqrt(dot(u, u) * dot(v, v)) + dot(u, v));
}

/// The bulge of the arc over `chord` whose largest distances to the piece q, one on each side, are equal.
/// q leaves the arc over its chord by (a + lambda b) times a constant, a = cross(chord, q), b = (chord - q).q, with
/// lambda the tangent of half the arc's angle; the extremes lie near (1 -+ 1/sqrt(3))/2.
[[nodiscard]] inline double balanced_bulge(const Local_polynomial& q, const Xy<double>& chord) {
  constexpr double FIRST = 0.21132486540518712;
  const Xy<double> p0 = q(FIRST), p1 = q(1 - FIRST);
  const double lambda = -(cross(chord, p0) + cross(chord, p1)) / (dot(chord - p0, p0) + dot(chord - p1, p1));
  return lambda / (1 + std::sqrt(1 + lambda * lambda));
}

/// Where on the piece q to join the two arcs of a biarc that touches `start` and `end` at the piece's ends: a parameter
/// u at which q is a point of the joint circle, from which the chord is seen under half the turn from start to end.
/// \return nothing where none was found
/// \pre q is a piece of a spiral segment, seen from its start
[[nodiscard]] inline std::optional<double> biarc_joint_parameter(const Local_polynomial& q, const Xy<double>& chord,
                                                                 const Xy<double>& start, const Xy<double>& end) {
  const double cosine = std::sqrt(dot(start, start) * dot(end, end)) + dot(start, end), sine = cross(start, end);
  // Newton's method on the mismatch of angles without its roots at both ends, which leaves it nearly linear with its
  // root near 1/2. A step past an end goes half-way there instead.
  constexpr double CLOSE = 0x1p-26;  // the step after one of this size would be below rounding
  constexpr int STEPS = 16;
  double u = 0.5;
  for (int i = 0; i < STEPS; ++i) {
    const Xy<double> p = q(u), d = q.derivative(u);
    const double mismatch = cross(p, chord) * cosine - dot(p, chord - p) * sine;
    const double slope = cross(d, chord) * cosine - dot(d, chord - 2.0 * p) * sine;
    const double step = mismatch / (slope - mismatch * (1 / u - 1 / (1 - u)));
    if (!(std::fabs(step) > CLOSE)) return u - (std::isnan(step) ? 0 : step);
    u = step >= u ? u / 2 : (-step >= 1 - u ? (u + 1) / 2 : u - step);
  }
  return std::nullopt;
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
