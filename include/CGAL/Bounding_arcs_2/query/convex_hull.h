// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The convex hull of a drawing as a chain of parts of its curves and bitangents, its width and its diameter.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_CONVEX_HULL_H
#define CGAL_BOUNDING_ARCS_2_QUERY_CONVEX_HULL_H

#include <CGAL/Bounding_arcs_2/query/Query_point.h>
#include <CGAL/Bounding_arcs_2/query/kernel_points.h>
#include <CGAL/Bounding_arcs_2/query/measures.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>

#include <optional>
#include <ostream>
#include <vector>

namespace CGAL::Bounding_arcs {

/// The convex hull of a drawing: pieces counterclockwise, each of which starts where the one before ends. The hull of a
/// straight drawing has both sides, and that of a point has one piece from the point to itself.
/// \code
/// const auto hull = convex_hull(tree, 1e-9);
/// for (const auto& piece : hull.pieces) std::cout << piece.from_point << " to " << piece.to_point << '\n';
/// \endcode
template <class Point = Xy<double>> struct Convex_hull {
  /// A piece of the boundary of a hull: a part of one Bezier piece, which is run through backwards where parameters
  /// fall, or a segment that touches curves in its ends or ends in a corner or an end of one.
  struct Piece {
    bool is_bitangent = false;  ///< such a segment
    Curve_place from, to;
    Point from_point, to_point;

    /// Writes the members in their order, with a blank between.
    friend std::ostream& operator<<(std::ostream& out, const Piece& answer) {
      return out << answer.from_point << ' ' << answer.to_point << ' ' << answer.from << ' ' << answer.to;
    }
  };

  std::vector<Piece> pieces;
  double height = 0;                             ///< the exact hull is within this of the chain
  Query_status status = Query_status::COMPLETE;  ///< whether the height is at most eps

  template <class Other> operator Convex_hull<Other>() const {  // NOLINT: the same with another kernel's points
    Convex_hull<Other> result{{}, height, status};
    for (const auto& p : pieces)
      result.pieces.push_back({p.is_bitangent, p.from, p.to, internal::answered<Other>(p.from_point),
                               internal::answered<Other>(p.to_point)});
    return result;
  }

  /// Writes a line for each piece.
  friend std::ostream& operator<<(std::ostream& out, const Convex_hull& hull) {
    for (const auto& p : hull.pieces) out << p << '\n';
    return out;
  }
};

/// The least distance of two parallel lines that all curves are between.
/// \code
/// if (const auto found = width(tree, 1e-9)) std::cout << found->width.lower << '\n';
/// \endcode
template <class Vector = Xy<double>> struct Width_of_drawing {
  Measure_bounds width;
  Vector along;  ///< unit vector along such lines; they are apart by no more than the upper bound

  template <class Other> operator Width_of_drawing<Other>() const {  // NOLINT: the same with another kernel's vector
    return {width, internal::answered<Other>(along)};
  }

  /// Writes the members in their order, with a blank between.
  friend std::ostream& operator<<(std::ostream& out, const Width_of_drawing& answer) {
    return out << answer.width << ' ' << answer.along;
  }
};

/// The largest distance of two points of the curves.
/// \code
/// if (const auto found = diameter(tree, 1e-9)) std::cout << found->diameter.lower << '\n';
/// \endcode
template <class Point = Xy<double>> struct Diameter_of_drawing {
  Measure_bounds diameter;
  Curve_place first, second;  ///< of points that are no closer than the lower bound
  Point first_point, second_point;

  template <class Other> operator Diameter_of_drawing<Other>() const {  // NOLINT: the same with another kernel's points
    return {diameter, first, second, internal::answered<Other>(first_point), internal::answered<Other>(second_point)};
  }

  /// Writes the members in their order, with a blank between.
  friend std::ostream& operator<<(std::ostream& out, const Diameter_of_drawing& answer) {
    return out << answer.diameter << ' ' << answer.first_point << ' ' << answer.second_point;
  }
};

namespace internal {
[[nodiscard]] Convex_hull<> convex_hull(const Bounding_arc_tree_2& tree, double eps);
[[nodiscard]] std::optional<Width_of_drawing<>> width(const Bounding_arc_tree_2& tree, double eps);
[[nodiscard]] std::optional<Diameter_of_drawing<>> diameter(const Bounding_arc_tree_2& tree, double eps);
}  // namespace internal

/// Returns the convex hull of all curves.
/// \param eps what rises less above a chord may be left out, no less than some ulp
/// \tparam Kernel of the points that are answered
/// \return no pieces for an empty tree
/// \guarantee nothing is farther outside than the height that is told, which is no more than eps and some ulp, or the
///   status says so. If the polygon of samples has an edge for each bitangent, these are as exact as doubles tell their
///   ends
/// \complexity n log n, and pieces at the hull as the root of 1 / eps; for eps below 2^-20 of the extent pieces with
///   ends of bitangents as its logarithm
template <class Kernel = Default_kernel>
[[nodiscard]] Convex_hull<typename Kernel::Point_2> convex_hull(const Bounding_arc_tree_2& tree, double eps) {
  return internal::convex_hull(tree, eps);
}

/// Returns the width of all curves.
/// \param eps how far the bounds may be apart, no less than some ulp
/// \return nothing for an empty tree
/// \guarantee certified
/// \complexity as for convex_hull(); as the root of 1 / eps, too, where it is the same in all directions
template <class Kernel = Default_kernel>
[[nodiscard]] std::optional<Width_of_drawing<typename Kernel::Vector_2>> width(const Bounding_arc_tree_2& tree,
                                                                               double eps) {
  return internal::width(tree, eps);
}

/// Returns the diameter of all curves.
/// \param eps how far the bounds may be apart, no less than some ulp
/// \return nothing for an empty tree
/// \guarantee certified
/// \complexity as for convex_hull(); as the root of 1 / eps, too, where it is the same in all directions
template <class Kernel = Default_kernel>
[[nodiscard]] std::optional<Diameter_of_drawing<typename Kernel::Point_2>> diameter(const Bounding_arc_tree_2& tree,
                                                                                    double eps) {
  return internal::diameter(tree, eps);
}

}  // namespace CGAL::Bounding_arcs

#endif
