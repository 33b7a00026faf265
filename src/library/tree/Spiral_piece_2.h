// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A piece of a spiral segment in hand: two samples of the curve, and the fat arc (region/Fat_arc_2.h) between them.
// Made from ends and tangents in plain doubles: what they miss is some ulp of the coordinates, which counts in the
// radius, while brackets cannot be narrower.

#ifndef BOUNDING_ARCS_LIBRARY_TREE_SPIRAL_PIECE_2_H
#define BOUNDING_ARCS_LIBRARY_TREE_SPIRAL_PIECE_2_H

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

/// At most the error of the tangents at both ends and, of a piece less than half a turn long, between them.
[[nodiscard]] inline double tangent_error(const Spiral_sample& p, const Spiral_sample& q) {
  return (std::max)(p.tangent_error, q.tangent_error);
}
/// More than the rounding of a dot or cross product of a tangent with another one, or with a difference of points, in
/// units of the lengths: the difference errs by u, products and their sum by 2 u.
inline constexpr double TANGENT_ROUNDING = 8 * HALF_ULP;

/// The bulges of the arcs between the ends of a piece that touch it at its first and at its last point.
///
/// The chord's direction errs by 2 e / L + 4 u, a tangent's by its own bound, a half angle's tangent by as much as the
/// angle does, since it is at most 1, and for rounding by 8 u.
struct End_bulges {
  double length;       ///< of the chord
  double angle_error;  ///< of the angles between chord and tangents
  double first, last;  ///< only where they are known

  /// \param error how far points of the piece may be from the exact curve
  End_bulges(const Spiral_piece_2& piece, double error) {
    const Xy<double> chord = piece.last.point - piece.first.point;
    length = euclidean_norm(chord);
    angle_error = 2 * error / length + tangent_error(piece.first, piece.last) + 12 * HALF_ULP;
    first = cross(piece.first.tangent, chord) / (length + dot(piece.first.tangent, chord));
    last = cross(chord, piece.last.tangent) / (length + dot(chord, piece.last.tangent));
  }
  /// Nothing but its box is known of a piece whose chord is hardly longer than the error.
  [[nodiscard]] bool are_known() const {
    constexpr double MOST = 0.25;
    return angle_error <= MOST;
  }
};

/// \param error how far points of the piece may be from the exact curve
/// \guarantee certified
///
/// What the radius is made of: L/4 |b0 - b1| and half the chord times the larger of the bulges' errors; the ends moved
/// by e; arcs and their mean bulge, rounded, by 4 u L.
[[nodiscard]] inline Fat_arc_2 fat_arc(const Spiral_piece_2& piece, double error) {
  const Xy<double> from = piece.first.point, to = piece.last.point;
  const End_bulges bulges(piece, error);
  const Fat_arc_2 boxed{{from, to, 0}, bulges.length + 4 * error};
  if (!bulges.are_known()) return boxed;
  const double b0 = bulges.first, b1 = bulges.last;
  // sine and tangent of angles that are known: 1.05 times
  const double radius =
      bulges.length * (0.25 * std::fabs(b0 - b1) + 0.55 * bulges.angle_error + 4 * HALF_ULP) * ROUNDED_UP<8> + error;
  // nor where the piece turns back within the error, whose bulges have no bound
  if (!(radius <= boxed.radius)) return boxed;
  return {{from, to, std::clamp(0.5 * (b0 + b1), -1.0, 1.0)}, radius};
}

}  // namespace CGAL::Bounding_arcs

#endif
