// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What two drawings, or the curves of one, have in common: points, and parts along which they run together.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_INTERSECTIONS_2_H
#define CGAL_BOUNDING_ARCS_2_QUERY_INTERSECTIONS_2_H

#include <CGAL/Bounding_arcs_2/query/Piece_intersections.h>
#include <CGAL/Bounding_arcs_2/query/kernel_points.h>

#include <cstdint>
#include <vector>

namespace CGAL::Bounding_arcs {

/// A place of a drawing whose parameter is in a range, in [0, 1]: that at a joint of two pieces is the later one's
/// start.
struct Curve_range {
  std::uint32_t curve, bezier;
  Bracket t;
};

/// A common point. One that is undecided may be none, several or a part that is shared, all of them in these ranges.
template <class Point = Xy<double>> struct Intersection_2 {
  Point point;  ///< of curve a in the middle of its range, which is as wide as curves are nearly parallel
  Intersection_kind kind;
  Curve_range a, b;
};

/// Common points without end: from a_from on, up to a_to, the first curve runs through the points that the second one
/// has from b_from to b_to, forwards or backwards.
struct Overlap_2 {
  Curve_range a_from, a_to, b_from, b_to;
  bool is_backwards = false;  ///< the second curve falls from b_from to b_to
};

/// The intersections of two drawings, in the order of the first drawing's curves. Points on overlaps are not among the
/// points.
/// \code
/// const auto found = intersections(tree, other);
/// for (const auto& common : found.points) std::cout << common.point << " on curve " << common.a.curve << '\n';
/// for (const Overlap_2& part : found.overlaps) std::cout << "along curve " << part.a_from.curve << '\n';
/// \endcode
template <class Point = Xy<double>> struct Intersections_2 {
  std::vector<Intersection_2<Point>> points;
  std::vector<Overlap_2> overlaps;

  template <class Other> operator Intersections_2<Other>() const {  // NOLINT: the same with another kernel's points
    Intersections_2<Other> result{{}, overlaps};
    for (const auto& p : points) result.points.push_back({answered<Other>(p.point), p.kind, p.a, p.b});
    return result;
  }
};

}  // namespace CGAL::Bounding_arcs

#endif
