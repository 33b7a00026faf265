// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The medial axis of the regions that the closed curves of a drawing bound, and the Voronoi diagram of all its curves,
// open ones and points, too, within a frame: a last curve that encloses the others. The path between two points along
// which there is most room, by the axis.

#ifndef CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_MEDIAL_AXIS_H
#define CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_MEDIAL_AXIS_H

#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>
#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>
#include <CGAL/Bounding_arcs_2/query/kernel_points.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>
#include <CGAL/Bounding_arcs_2/tree/for_each_index.h>

#include <cstddef>
#include <functional>
#include <optional>

namespace CGAL::Bounding_arcs {

/// A drawing with a rectangle behind its curves.
/// \param box to be the frame, with room around the curves: no disc fits between a curve and a frame that touch
[[nodiscard]] Drawing_2<double> framed(Drawing_2<double> drawing, const CGAL::Bbox_2& box);
/// Returns the drawing in a frame with a margin around the box of all control points.
/// \param margin above 0, in units of the coordinates
/// \throws std::invalid_argument for a drawing without curves, or a margin that coordinates do not resolve
[[nodiscard]] Drawing_2<double> framed(Drawing_2<double> drawing, double margin);

namespace internal {
/// Checks a drawing whose last curve is to be a frame, and whose curves do not cross.
/// \throws std::invalid_argument if that is open, or does not enclose a curve
void check_frame(const Drawing_2<double>& drawing);
}  // namespace internal

namespace internal {
/// A loop of independent pieces of work, for_each_index. A pointer to it is what lets the library, which is compiled
/// without threads, run in those of its user.
using Index_loop = void (*)(std::size_t count, const std::function<void(std::size_t)>& work);
template <class ConcurrencyTag> [[nodiscard]] Index_loop index_loop() {
  return &for_each_index<ConcurrencyTag, std::function<void(std::size_t)>>;
}
// The search takes threads as an argument: it is compiled without any.
[[nodiscard]] Medial_axis_2 medial_axis(const Bounding_arc_tree_2& curves, double eps,
                                        const Medial_axis_2::Options& options, Index_loop loop);
}  // namespace internal

/// Returns the medial axis of all regions that the closed curves of a tree fill under a rule, as boolean operations and
/// offsets take them. Curves may cross, touch and run together. A part of one with filled points on both sides is no
/// boundary: discs do not see it. `left_out` tells the curves that have no other parts.
///
/// Leaves are convex corners, where the radius is 0, and maxima of curvature with an empty osculating disc; a circular
/// arc of largest curvature is one leaf, which touches both ends of the arc. Discs that touch the same places are one
/// vertex of a higher degree. A disc has one vertex and no edge; the axis of a ring is an edge from a vertex of degree
/// 2, anywhere on it, to itself.
///
/// In a frame curves may cross, touch and run together, and each has discs on both sides. Ends of open curves and
/// points are touched from all around, like reflex corners. So the axis is the Voronoi diagram of the curves and the
/// frame, together with their medial axes within it. What only the frame makes has a sample that touches the last curve
/// in each of its edges (Medial_axis_2::Edge::touches).
/// \tparam ConcurrencyTag CGAL::Sequential_tag or CGAL::Parallel_tag, which needs TBB; the axis is the same
/// \param eps how far the axis, and its radius together, may be from the lines between samples, positive
/// \guarantee the axis is that of some drawing within `moved` of the given one: ends, walls and corners that are nearer
///   to each other than 2^-42 of the size are one. Where it is complete, discs of vertices and samples touch their
///   places but for some roundings of the coordinates; the bracket of each vertex's `clearance` is certified. Between
///   samples the axis is within eps by an estimate from its directions and the radius's slopes at both samples. Every
///   eighth sample is asked for curves in its disc at the end; an axis that fails is UNRESOLVED, never silently wrong
///   there
/// \throws std::invalid_argument if a curve is open, or eps is not above 0; in a frame, if that is open, or does not
///   enclose a curve
/// \complexity about n log n in the number of segments, and the samples, which are as many as eps^(-1/2)
/// \source Choi, Choi, Moon 1997 and Aichholzer, Aigner, Aurenhammer, Hackl, Juettler, Rabl 2009: cutting at maximal
///   discs; here of the curves themselves, by searches as Lee, Kim, Kim, Elber 2016 have them
template <class ConcurrencyTag = CGAL::Sequential_tag>
[[nodiscard]] Medial_axis_2 medial_axis(const Bounding_arc_tree_2& tree, double eps,
                                        const Medial_axis_2::Options& options = {}) {
  return internal::medial_axis(tree, eps, options, internal::index_loop<ConcurrencyTag>());
}

/// Returns a path whose least clearance is as large as any path's; among those along the axis the shortest. It leads
/// from a point away from what is nearest to it until a second thing is as near, then along the axis.
/// \param tree of the curves that the axis is of
/// \return nothing where a point is not in a region of the axis, or in one without edges, or they are in different ones
/// \guarantee the clearance along the path is within axis.eps of what lines between stations say. That no path has more
///   is as good as the axis (O'Dunlaing, Yap 1985: the way to the axis never loses clearance)
/// \throws std::invalid_argument for a point that is no number
/// \complexity n log n in the samples
[[nodiscard]] std::optional<Medial_axis_2::Path> clearance_path(const Bounding_arc_tree_2& tree,
                                                                const Medial_axis_2& axis, const Asked_point& from,
                                                                const Asked_point& to);

}  // namespace CGAL::Bounding_arcs

#endif
