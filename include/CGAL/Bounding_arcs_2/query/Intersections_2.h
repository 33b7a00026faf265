// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What two drawings, or the curves of one, have in common: points, and parts along which they run together.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_INTERSECTIONS_2_H
#define CGAL_BOUNDING_ARCS_2_QUERY_INTERSECTIONS_2_H

#include <CGAL/Bounding_arcs_2/number/Bracket.h>
#include <CGAL/Bounding_arcs_2/query/kernel_points.h>

#include <cstdint>
#include <ostream>
#include <vector>

namespace CGAL::Bounding_arcs {

// What two pieces, or one piece with itself, have in common: parameters in narrow ranges.
// Invariant: a range holds its exact parameter, and is a single double only where the parameter is that double.

/// Tangential: the tangents are parallel there, or one piece has none, as in a cusp.
enum class Intersection_kind { TRANSVERSAL, TANGENTIAL, UNDECIDED };

/// All that is common, each list sorted by the first piece's parameter, then by the second one's.
/// A pair of parameters on an overlap, its ends included, is not among the points.
struct Piece_intersections {
  /// A common point, the first piece's parameter and the second one's, both in [0, 1].
  /// A bracket holds one exact parameter. It is at most three doubles wide, and a single double only where the
  /// parameter is that double.
  struct Intersection {
    Bracket a, b;
    Intersection_kind kind = Intersection_kind::UNDECIDED;

    /// Writes the members in their order, with a blank between.
    friend std::ostream& operator<<(std::ostream& out, const Intersection& answer) {
      return out << answer.a << ' ' << answer.b;
    }
  };

  /// Common points without end: while the first piece runs from a_from up to a_to, the second one runs from b_from to
  /// b_to, up or down, through the same points. A piece that is a single point stays there all the time.
  struct Overlap {
    Bracket a_from, a_to, b_from, b_to;

    /// Writes the members in their order, with a blank between.
    friend std::ostream& operator<<(std::ostream& out, const Overlap& answer) {
      return out << answer.a_from << ' ' << answer.a_to << ' ' << answer.b_from << ' ' << answer.b_to;
    }
  };

  std::vector<Intersection> points;
  std::vector<Overlap> overlaps;
};

/// A place of a drawing whose parameter is in a range, in [0, 1]: that at a joint of two pieces is the later one's
/// start.
struct Curve_range {
  std::uint32_t curve, bezier;
  Bracket t;

  /// Writes the members in their order, with a blank between.
  friend std::ostream& operator<<(std::ostream& out, const Curve_range& answer) {
    return out << answer.curve << ' ' << answer.bezier << ' ' << answer.t;
  }
};

/// Common points without end: from a_from on, up to a_to, the first curve runs through the points that the second one
/// has from b_from to b_to, forwards or backwards.
struct Overlap_2 {
  Curve_range a_from, a_to, b_from, b_to;
  bool is_backwards = false;  ///< the second curve falls from b_from to b_to

  /// Writes the members in their order, with a blank between.
  friend std::ostream& operator<<(std::ostream& out, const Overlap_2& answer) {
    return out << answer.a_from << ' ' << answer.a_to << ' ' << answer.b_from << ' ' << answer.b_to;
  }
};

/// The intersections of two drawings, in the order of the first drawing's curves. Points on overlaps are not among the
/// points.
/// \code
/// const auto found = intersections(tree, other);
/// for (const auto& common : found.points) std::cout << common.point << " on curve " << common.a.curve << '\n';
/// for (const Overlap_2& part : found.overlaps) std::cout << "along curve " << part.a_from.curve << '\n';
/// \endcode
template <class Point = Xy<double>> struct Intersections_2 {
  /// A common point. One that is undecided may be none, several or a part that is shared, all of them in these ranges.
  struct Intersection {
    Point point;  ///< of curve a in the middle of its range, which is as wide as curves are nearly parallel
    Intersection_kind kind;
    Curve_range a, b;

    /// Writes the members in their order, with a blank between.
    friend std::ostream& operator<<(std::ostream& out, const Intersection& answer) {
      return out << answer.point << ' ' << answer.a << ' ' << answer.b;
    }
  };

  std::vector<Intersection> points;
  std::vector<Overlap_2> overlaps;

  template <class Other> operator Intersections_2<Other>() const {  // NOLINT: the same with another kernel's points
    Intersections_2<Other> result{{}, overlaps};
    for (const auto& p : points) result.points.push_back({internal::answered<Other>(p.point), p.kind, p.a, p.b});
    return result;
  }

  /// Writes a line for each point, and one for each overlap.
  friend std::ostream& operator<<(std::ostream& out, const Intersections_2& all) {
    for (const auto& p : all.points) out << p << '\n';
    for (const Overlap_2& o : all.overlaps) out << o << '\n';
    return out;
  }
};

}  // namespace CGAL::Bounding_arcs

#endif
