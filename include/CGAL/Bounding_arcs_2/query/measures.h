// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How long curves are, and the area inside closed ones with its centroid, between bounds.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_MEASURES_H
#define CGAL_BOUNDING_ARCS_2_QUERY_MEASURES_H

#include <CGAL/Bounding_arcs_2/query/Query_point.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>

#include <optional>
#include <ostream>

namespace CGAL::Bounding_arcs {

/// Two bounds, between which a number of the exact curves is. A B-spline in a drawing counts as itself, with its knots
/// inserted exactly, and not as the Bezier pieces in doubles that other queries see.
/// \code
/// const Measure_bounds all = length(tree, 1e-9);
/// std::cout << "between " << all.lower << " and " << all.upper << '\n';
/// \endcode
struct Measure_bounds {
  double lower, upper;
  Query_status status = Query_status::COMPLETE;

  /// Writes both bounds, with a blank between.
  friend std::ostream& operator<<(std::ostream& out, const Measure_bounds& b) {
    return out << b.lower << ' ' << b.upper;
  }
};

/// A box that holds the centroid.
/// \code
/// if (const auto middle = centroid(closed, 1e-9)) std::cout << middle->x.lower << ' ' << middle->y.lower << '\n';
/// \endcode
struct Centroid_bounds {
  Measure_bounds x, y;

  /// Writes the members in their order, with a blank between.
  friend std::ostream& operator<<(std::ostream& out, const Centroid_bounds& answer) {
    return out << answer.x << ' ' << answer.y;
  }
};

/// Returns the length of all curves together.
/// \param eps how far the bounds may be apart; they are farther where doubles tell no more
/// \guarantee certified
/// \complexity n, some microseconds a Bezier piece; next to cusps pieces as the logarithm of 1 / eps
[[nodiscard]] Measure_bounds length(const Bounding_arc_tree_2& tree, double eps);

/// Returns the area that closed curves run round, each part as often as they do: counterclockwise more than 0, holes
/// that are clockwise taken off.
/// \param eps how far the bounds may be apart; they are farther where doubles tell no more of rational curves
/// \guarantee certified; for polynomial curves the nearest doubles
/// \complexity n; some tens of microseconds a rational piece, some hundred a piece of a B-spline with rounded pieces
/// \throws std::invalid_argument if a curve is open, with its name
[[nodiscard]] Measure_bounds area(const Bounding_arc_tree_2& tree, double eps);

/// Returns the centroid of that area.
/// \param eps as for area(), of each coordinate, relative to the extent of the drawing
/// \return nothing where the area may be 0
/// \guarantee certified
/// \complexity as for area()
/// \throws std::invalid_argument if a curve is open, with its name
[[nodiscard]] std::optional<Centroid_bounds> centroid(const Bounding_arc_tree_2& tree, double eps);

}  // namespace CGAL::Bounding_arcs

#endif
