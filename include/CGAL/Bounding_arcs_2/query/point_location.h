// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a point is with respect to closed curves: how often they run round it, and whether it is inside.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_POINT_LOCATION_H
#define CGAL_BOUNDING_ARCS_2_QUERY_POINT_LOCATION_H

#include <CGAL/Bounding_arcs_2/query/Drawing_location.h>
#include <CGAL/Bounding_arcs_2/query/Point_side.h>
#include <CGAL/Bounding_arcs_2/tree/tree_declaration.h>

namespace CGAL::Bounding_arcs {

/// Point location for many points: that all curves of a tree are closed is checked once.
/// \code
/// const Point_location_2 location(closed);  // a tree of closed curves
/// const bool is_inside = location.locate({1, 1}) == Point_side::INSIDE;
/// \endcode
/// \tparam Kernel that of the tree
template <class Kernel> class Point_location_2 {
 public:
  /// \param tree must outlive this
  /// \throws std::invalid_argument if a curve is open, with its name
  template <class Traits, class Spiral, class Decider>
  explicit Point_location_2(const Bounding_arc_tree_2<Traits, Spiral, Decider>& tree) : location_(tree.curves()) {}

  /// Returns how often the curves run round a point.
  /// \guarantee exact for every point over kernels with exact predicates; else right where it is decided
  /// \complexity boxes that a ray to the right meets; exact arithmetic only for pieces within some ulp of the point
  /// \throws std::invalid_argument for a point that is no number
  [[nodiscard]] Winding_number winding_number(const typename Kernel::Point_2& q) const {
    return location_.winding_number(asked_point<Kernel>(q));
  }
  /// Tells whether a point is inside, with guarantees as above.
  [[nodiscard]] Point_side locate(const typename Kernel::Point_2& q, Fill_rule rule = Fill_rule::NONZERO) const {
    return side_of(winding_number(q), rule);
  }

 private:
  Drawing_location location_;
};
/// The kernel is that of the tree.
template <class Traits, class Spiral, class Decider>
explicit Point_location_2(const Bounding_arc_tree_2<Traits, Spiral, Decider>&)
    -> Point_location_2<typename Traits::Kernel>;

/// Returns how often the curves of a tree run round one point; see Point_location_2.
template <class Traits, class Spiral, class Decider>
[[nodiscard]] Winding_number winding_number(const Bounding_arc_tree_2<Traits, Spiral, Decider>& tree,
                                            const typename Traits::Kernel::Point_2& q) {
  return Point_location_2(tree).winding_number(q);
}
/// Tells whether one point is inside the curves of a tree; see Point_location_2.
template <class Traits, class Spiral, class Decider>
[[nodiscard]] Point_side locate(const Bounding_arc_tree_2<Traits, Spiral, Decider>& tree,
                                const typename Traits::Kernel::Point_2& q, Fill_rule rule = Fill_rule::NONZERO) {
  return Point_location_2(tree).locate(q, rule);
}

}  // namespace CGAL::Bounding_arcs

#endif
