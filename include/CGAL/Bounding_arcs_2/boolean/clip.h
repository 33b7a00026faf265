// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Curves, cut where they meet those of a region: parts inside of it, outside of it, and along its curves.

#ifndef CGAL_BOUNDING_ARCS_2_BOOLEAN_CLIP_H
#define CGAL_BOUNDING_ARCS_2_BOOLEAN_CLIP_H

#include <CGAL/Bounding_arcs_2/boolean/Clipped_2.h>
#include <CGAL/Bounding_arcs_2/curve/Fill_rule.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>

namespace CGAL::Bounding_arcs {

/// Cuts the curves of a tree, open ones and closed ones, where they meet those of a region.
/// \param region a tree of closed curves
/// \param rule says what these fill
/// \return all parts, in the order of the curves, with the side that each is on
/// \guarantee with exact decisions parts and sides are those of the exact curves, and the status is
///   COMPLETE. Parts may be shorter than doubles tell. Else the status tells what doubles left open
/// \throws std::invalid_argument for an open curve of the region, and for curves out of the range of queries
/// \complexity that of intersections, and log n for each part but for what a ray from it crosses
[[nodiscard]] Clipped_2 clip(const Bounding_arc_tree_2& curves, const Bounding_arc_tree_2& region,
                             Fill_rule rule = Fill_rule::NONZERO);

/// Returns a part as a curve: cut out in doubles, with the part's ends bit for bit.
/// \param drawing that of the tree that was clipped
[[nodiscard]] Bezier_curve_2<double> curve_of(const Clipped_part& part, const Drawing_2<double>& drawing);

}  // namespace CGAL::Bounding_arcs

#endif
