// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The smallest circle about a drawing.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_ENCLOSING_CIRCLE_H
#define CGAL_BOUNDING_ARCS_2_QUERY_ENCLOSING_CIRCLE_H

#include <CGAL/Bounding_arcs_2/query/kernel_points.h>
#include <CGAL/Bounding_arcs_2/query/measures.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>

#include <optional>
#include <ostream>

namespace CGAL::Bounding_arcs {

/// A circle about a drawing.
/// \code
/// if (const auto circle = smallest_enclosing_circle(tree, 1e-9)) std::cout << circle->center << '\n';
/// \endcode
template <class Point = Xy<double>> struct Enclosing_circle {
  Point center;
  Measure_bounds radius;  ///< of the smallest circle; about this center all curves are within the upper bound

  template <class Other> operator Enclosing_circle<Other>() const {  // NOLINT: the same with another kernel's point
    return {internal::answered<Other>(center), radius};
  }

  /// Writes the members in their order, with a blank between.
  friend std::ostream& operator<<(std::ostream& out, const Enclosing_circle& answer) {
    return out << answer.center << ' ' << answer.radius;
  }
};

namespace internal {
[[nodiscard]] std::optional<Enclosing_circle<>> smallest_enclosing_circle(const Bounding_arc_tree_2& tree, double eps);
}  // namespace internal

/// Returns the smallest circle that all curves are inside of.
/// \param eps how far the bounds may be apart, no less than some ulp
/// \return nothing for an empty tree
/// \guarantee certified
/// \complexity n log n, and pieces that come near the circle, as the root of 1 / eps where they run along it
template <class Kernel = Default_kernel>
[[nodiscard]] std::optional<Enclosing_circle<typename Kernel::Point_2>> smallest_enclosing_circle(
    const Bounding_arc_tree_2& tree, double eps) {
  return internal::smallest_enclosing_circle(tree, eps);
}

}  // namespace CGAL::Bounding_arcs

#endif
