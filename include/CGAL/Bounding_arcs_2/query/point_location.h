// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a point is with respect to closed curves: how often they run round it, and whether it is inside.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_POINT_LOCATION_H
#define CGAL_BOUNDING_ARCS_2_QUERY_POINT_LOCATION_H

#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/query/Query_point.h>
#include <CGAL/Bounding_arcs_2/query/kernel_points.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>

#include <cstddef>
#include <stdexcept>
#include <string>

namespace CGAL::Bounding_arcs {

namespace internal {
/// \throws std::invalid_argument if a curve is open, with its number, from 0, and its name
template <class NT> void check_closed(const Drawing_2<NT>& drawing) {
  for (std::size_t i = 0; i < drawing.curves().size(); ++i) {
    const auto& curve = drawing.curves()[i];
    if (curve.is_closed) continue;
    const std::string name = curve.name.empty() ? std::string() : " '" + curve.name + "'";
    throw std::invalid_argument(
        expected("curve " + text_of(i) + name, "a closed curve, which has an inside", "an open one"));
  }
}
}  // namespace internal

/// Point location for many points: that all curves of a tree are closed is checked once.
/// \code
/// const Point_location_2 location(closed);  // a tree of closed curves
/// const bool is_inside = location.locate({1, 1}) == CGAL::ON_BOUNDED_SIDE;
/// \endcode
class Point_location_2 {
 public:
  /// \param tree must outlive this
  /// \throws std::invalid_argument if a curve is open, with its name
  explicit Point_location_2(const Bounding_arc_tree_2& tree) : tree_(&tree) { internal::check_closed(tree.drawing()); }

  /// Returns how often the curves run round a point.
  /// \param q of any kernel
  /// \guarantee exact for every point of a tree with exact decisions; else right where it is decided
  /// \complexity boxes that a ray to the right meets; exact arithmetic only for pieces within some ulp of the point
  /// \throws std::invalid_argument for a point that is no number
  [[nodiscard]] Winding_number winding_number(const Asked_point& q) const;
  /// Tells on which side a point is, with guarantees as above. \return uncertain only without exact decisions
  [[nodiscard]] Uncertain<Bounded_side> locate(const Asked_point& q, Fill_rule rule = Fill_rule::NONZERO) const {
    return winding_number(q).side(rule);
  }

 private:
  const Bounding_arc_tree_2* tree_;
};

/// Returns how often the curves of a tree run round one point; see Point_location_2.
[[nodiscard]] inline Winding_number winding_number(const Bounding_arc_tree_2& tree, const Asked_point& q) {
  return Point_location_2(tree).winding_number(q);
}
/// Tells on which side of the curves of a tree one point is; see Point_location_2.
[[nodiscard]] inline Uncertain<Bounded_side> locate(const Bounding_arc_tree_2& tree, const Asked_point& q,
                                                    Fill_rule rule = Fill_rule::NONZERO) {
  return Point_location_2(tree).locate(q, rule);
}

}  // namespace CGAL::Bounding_arcs

#endif
