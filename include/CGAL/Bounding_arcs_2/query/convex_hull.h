// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The convex hull of a drawing as a chain of parts of its curves and bitangents, its width and its diameter.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_CONVEX_HULL_H
#define CGAL_BOUNDING_ARCS_2_QUERY_CONVEX_HULL_H

#include <CGAL/Bounding_arcs_2/query/Curve_index_2.h>
#include <CGAL/Bounding_arcs_2/query/measures.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL::Bounding_arcs {

/// A piece of the boundary of a hull.
struct Hull_piece {
  enum class Kind : std::uint8_t {
    CURVE,     ///< a part of one Bezier piece, where it is run through backwards with falling parameters
    BITANGENT  ///< a segment that touches curves in its ends, or ends in a corner or an end of one
  };
  Kind kind = Kind::CURVE;
  Curve_place from, to;
  Xy<double> from_point, to_point;
};

/// Counterclockwise, each piece starts where the one before ends. Of a straight drawing both sides are told, of a point
/// one piece from it to itself.
struct Convex_hull {
  std::vector<Hull_piece> pieces;
  double height = 0;                             ///< the exact hull is within this of the chain
  Query_status status = Query_status::COMPLETE;  ///< whether the height is at most the tolerance
};

/// The convex hull of all curves.
/// \param tolerance what rises less above a chord may be left out, no less than some ulp
/// \return no pieces for an empty drawing
/// \guarantee nothing is farther outside than the height that is told, which is no more than tolerance and some ulp, or
///   the status says so; if the polygon of samples has an edge for each bitangent, these are as exact as doubles tell
///   their ends
/// \complexity n log n, and pieces at the hull as the root of 1 / tolerance; for tolerances below 2^-20 of the extent
///   pieces with ends of bitangents as its logarithm
[[nodiscard]] Convex_hull convex_hull(const Curve_index_2& index, double tolerance);

/// The least distance of two parallel lines that all curves are between.
struct Width_of_drawing {
  Measure_bounds width;
  Xy<double> along;  ///< unit vector along such lines; they are apart by no more than the upper bound
};
/// \param tolerance how far the bounds may be apart, no less than some ulp
/// \return nothing for an empty drawing
/// \guarantee certified
/// \complexity as for convex_hull(); as the root of 1 / tolerance, too, where it is the same in all directions
[[nodiscard]] std::optional<Width_of_drawing> width(const Curve_index_2& index, double tolerance);

/// The largest distance of two points of the curves.
struct Diameter_of_drawing {
  Measure_bounds diameter;
  Curve_place first, second;  ///< of points that are no closer than the lower bound
  Xy<double> first_point, second_point;
};
/// \param tolerance how far the bounds may be apart, no less than some ulp
/// \return nothing for an empty drawing
/// \guarantee certified
/// \complexity as for convex_hull(); as the root of 1 / tolerance, too, where it is the same in all directions
[[nodiscard]] std::optional<Diameter_of_drawing> diameter(const Curve_index_2& index, double tolerance);

}  // namespace CGAL::Bounding_arcs

#ifndef BOUNDING_ARCS_KERNELS
#include <CGAL/Bounding_arcs_2/internal/query/convex_hull_impl.h>
#endif

#endif
