// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Verdicts of predicates on grids of neighbouring doubles, by rounded figures and by this library: a picture shows
// where rounding has taken the side of a curve.

#ifndef CGAL_BOUNDING_ARCS_2_STUDY_VERDICT_GRID_H
#define CGAL_BOUNDING_ARCS_2_STUDY_VERDICT_GRID_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Bounding_arcs {

/// An arc of a BCA, of radius 25: it starts in p0 along a tangent, turns left and ends in p1.
struct Verdict_arc {
  Xy<double> p0{0.125, 0.6}, tangent{1, -0.001}, p1{0.95, 0.6125};
};
/// Two circles; the center of the second one is what the grid moves.
struct Verdict_circles {
  Xy<double> center{0.1, 0.2};
  double radius = 0.3, other_radius = 0.45;
};
/// The right side of a closed curve, which runs upwards; its left side is two segments far away.
[[nodiscard]] inline Bezier_curve_2<double> verdict_curve() {
  return Bezier_curve_2<double>({{0.6, 0.1}, {0.9, 0.4}, {0.55, 0.7}, {0.8, 0.9}});
}

/// The verdicts on size x size points, whose coordinates are neighbouring doubles, around one near the curve. They are
/// 1, 0 or -1: left of the arc, on it, right of it; circles apart, touching, crossing; outside, on, inside.
struct Verdict_grid {
  std::string name;  ///< side of arc, tangency, point location
  Xy<double> corner;
  std::size_t size = 0;
  std::vector<signed char> naive =
      {};                              ///< by rows upwards: center and radius, square roots, a bisection, all in double
  std::vector<signed char> ours = {};  ///< double where its bound tells, else exact numbers

  /// Returns the point in a column and a row, both from 0.
  [[nodiscard]] Xy<double> point(std::size_t column, std::size_t row) const;
  /// Counts the points with another verdict.
  [[nodiscard]] std::size_t differences() const;
};

/// Makes the three grids.
/// \guarantee ours is exact
[[nodiscard]] std::vector<Verdict_grid> verdict_grids(std::size_t size);

}  // namespace CGAL::Bounding_arcs

#endif
