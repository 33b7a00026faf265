// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the curves of drawings cut the plane into, decided exactly, and the areas of faces.

#ifndef CGAL_BOUNDING_ARCS_2_OVERLAY_OVERLAY_H
#define CGAL_BOUNDING_ARCS_2_OVERLAY_OVERLAY_H

#include <CGAL/Bounding_arcs_2/overlay/Outline_operand.h>
#include <CGAL/Bounding_arcs_2/overlay/Overlay_2.h>
#include <CGAL/Bounding_arcs_2/overlay/internal/compiled_overlay.h>
#include <CGAL/Bounding_arcs_2/query/measures.h>
#include <CGAL/Bounding_arcs_2/tree/tree_declaration.h>

#include <cstdint>
#include <initializer_list>
#include <vector>

namespace CGAL::Bounding_arcs {

/// Returns what the curves of several trees, open ones and closed ones, cut the plane into.
/// \param options what is cut beside places where curves meet
/// \return vertices, edges and faces. Curves that run together are one edge. A curve that is a point is a vertex
/// \guarantee over kernels with exact predicates vertices, edges and faces are those of the exact curves: no two are
///   made one, however near they are. Over others the status tells whether doubles left something open
/// \throws std::invalid_argument for curves out of the range of queries
/// \complexity (n + k) log n for n Bezier pieces and k common points, and exact arithmetic where curves touch or
///   overlap
template <class Traits, class Spiral, class Decider>
[[nodiscard]] Overlay_2 overlay(const std::vector<const Bounding_arc_tree_2<Traits, Spiral, Decider>*>& trees,
                                const Overlay_options& options = {}) {
  return internal::overlay(outline_operands(trees), options, Bounding_arc_tree_2<Traits, Spiral, Decider>::DECISIONS);
}

/// Returns the same for a list of trees: overlay({&a, &b, &c}).
template <class Traits, class Spiral, class Decider>
[[nodiscard]] Overlay_2 overlay(std::initializer_list<const Bounding_arc_tree_2<Traits, Spiral, Decider>*> trees,
                                const Overlay_options& options = {}) {
  return overlay(std::vector<const Bounding_arc_tree_2<Traits, Spiral, Decider>*>(trees), options);
}

/// Returns what a tree's curves cut the plane into. See above.
template <class Traits, class Spiral, class Decider>
[[nodiscard]] Overlay_2 overlay(const Bounding_arc_tree_2<Traits, Spiral, Decider>& tree,
                                const Overlay_options& options = {}) {
  return overlay({&tree}, options);
}
/// Returns what the curves of two trees cut the plane into. See above.
template <class Traits, class Spiral, class Decider>
[[nodiscard]] Overlay_2 overlay(const Bounding_arc_tree_2<Traits, Spiral, Decider>& a,
                                const Bounding_arc_tree_2<Traits, Spiral, Decider>& b,
                                const Overlay_options& options = {}) {
  return overlay({&a, &b}, options);
}

/// Returns the area of a face, without what lies in its holes.
/// \code
/// const Overlay_2 cells = overlay(tree);
/// for (std::uint32_t face = 1; face < cells.faces.size(); ++face)
///   std::cout << face_area(cells, face, {&tree}, 1e-9).lower << '\n';
/// \endcode
/// \param face the number of a face, bounded
/// \param trees those that the overlay was made of, in their order
/// \param eps how far the bounds may be apart; they are farther where doubles tell no more of rational curves, or of
///   the parameters of vertices
/// \guarantee certified; for polynomial curves the nearest doubles, but for what parameters of vertices leave open
/// \complexity some tens of microseconds an edge; for rational curves pieces as the third root of 1 / eps
/// \throws std::invalid_argument if the face is unbounded, or eps below 0
template <class Traits, class Spiral, class Decider>
[[nodiscard]] Measure_bounds face_area(const Overlay_2& overlay, std::uint32_t face,
                                       const std::vector<const Bounding_arc_tree_2<Traits, Spiral, Decider>*>& trees,
                                       double eps) {
  return internal::face_area(overlay, face, outline_operands(trees), eps);
}
/// Returns the same for a list of trees.
template <class Traits, class Spiral, class Decider>
[[nodiscard]] Measure_bounds face_area(const Overlay_2& overlay, std::uint32_t face,
                                       std::initializer_list<const Bounding_arc_tree_2<Traits, Spiral, Decider>*> trees,
                                       double eps) {
  return face_area(overlay, face, std::vector<const Bounding_arc_tree_2<Traits, Spiral, Decider>*>(trees), eps);
}

}  // namespace CGAL::Bounding_arcs

#endif
