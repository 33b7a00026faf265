// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A piece of a spiral segment in hand: two samples of the curve, and the fat arc (region/Fat_arc_2.h) between them.
// Made from ends and tangents in plain doubles: what they miss is some ulp of the coordinates, which counts in the
// radius, while brackets cannot be narrower.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_SPIRAL_PIECE_2_H
#define CGAL_BOUNDING_ARCS_2_TREE_SPIRAL_PIECE_2_H

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>
#include <CGAL/Bounding_arcs_2/region/Fat_arc_2.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace CGAL::Bounding_arcs {

/// A point of a spiral segment with what regions and Newton's steps need of it.
struct Spiral_sample {
  double t = 0;
  Xy<double> point;
  Xy<double> tangent;          ///< unit vector in the direction of growing t
  double tangent_error = 0;    ///< bounds the sine of its angle to the true direction
  double most_curvature = 0;   ///< at least |curvature| there, infinite where that may be
  double least_curvature = 0;  ///< at most |curvature| there
};

/// A piece of a spiral segment of an index between two samples.
struct Spiral_piece_2 {
  std::uint32_t segment = 0;
  Spiral_sample first, last;
};

/// \param error how far points of the piece may be from the exact curve
/// \guarantee certified
///
/// The chord's direction errs by 2 e / L + 4 u, a tangent's by its own bound, a half angle's tangent by as much as the
/// angle does, since it is at most 1, and for rounding by 8 u.  What the radius is made of: L/4 |b0 - b1| and half the
/// chord times the larger of these; the ends moved by e; arcs and their mean bulge, rounded, by 4 u L.
[[nodiscard]] inline Fat_arc_2 fat_arc(const Spiral_piece_2& piece, double error) {
  const Xy<double> from = piece.first.point, to = piece.last.point, chord = to - from;
  const double length = euclidean_norm(chord);
  const double angle_error =
      2 * error / length + (std::max)(piece.first.tangent_error, piece.last.tangent_error) + 12 * ARC_HALF_ULP;
  // of a chord that is hardly longer than the error nothing is known but its box
  const Fat_arc_2 boxed{{from, to, 0}, length + 4 * error};
  constexpr double MOST = 0.25;
  if (!(angle_error <= MOST)) return boxed;
  const double b0 = cross(piece.first.tangent, chord) / (length + dot(piece.first.tangent, chord)),
               b1 = cross(chord, piece.last.tangent) / (length + dot(chord, piece.last.tangent));
  // sine and tangent of angles up to MOST: 1.05 times
  const double radius =
      length * (0.25 * std::fabs(b0 - b1) + 0.55 * angle_error + 4 * ARC_HALF_ULP) * (1 + 8 * ARC_HALF_ULP) + error;
  // nor where the piece turns back within the error, whose bulges have no bound
  if (!(radius <= boxed.radius)) return boxed;
  return {{from, to, std::clamp(0.5 * (b0 + b1), -1.0, 1.0)}, radius};
}

}  // namespace CGAL::Bounding_arcs

#endif
