// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the curves of drawings cut the plane into, decided exactly, and the areas of faces.

#ifndef CGAL_BOUNDING_ARCS_2_OVERLAY_OVERLAY_H
#define CGAL_BOUNDING_ARCS_2_OVERLAY_OVERLAY_H

#include <CGAL/Bounding_arcs_2/overlay/Overlay_2.h>
#include <CGAL/Bounding_arcs_2/query/measures.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>

#include <cstdint>
#include <vector>

namespace CGAL::Bounding_arcs {

/// Returns what the curves of several trees, open ones and closed ones, cut the plane into.
/// \param options what is cut beside places where curves meet
/// \return vertices, edges and faces. Curves that run together are one edge. A curve that is a point is a vertex
/// \guarantee with exact decisions vertices, edges and faces are those of the exact curves: no two are made one,
///   however near they are. If a tree has others, the status tells whether doubles left something open
/// \throws std::invalid_argument for curves out of the range of queries
/// \complexity (n + k) log n for n Bezier pieces and k common points, and exact arithmetic where curves touch or
///   overlap
[[nodiscard]] Overlay_2 overlay(const std::vector<const Bounding_arc_tree_2*>& trees,
                                const Overlay_options& options = {});

/// Returns what a tree's curves cut the plane into. See above.
[[nodiscard]] inline Overlay_2 overlay(const Bounding_arc_tree_2& tree, const Overlay_options& options = {}) {
  return overlay({&tree}, options);
}
/// Returns what the curves of two trees cut the plane into. See above.
[[nodiscard]] inline Overlay_2 overlay(const Bounding_arc_tree_2& a, const Bounding_arc_tree_2& b,
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
[[nodiscard]] Measure_bounds face_area(const Overlay_2& overlay, std::uint32_t face,
                                       const std::vector<const Bounding_arc_tree_2*>& trees, double eps);

}  // namespace CGAL::Bounding_arcs

#endif
