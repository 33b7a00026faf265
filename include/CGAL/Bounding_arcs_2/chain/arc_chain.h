// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A curve as few circular arcs and segments as a tolerance allows, each with a certified bound of its error.

#ifndef CGAL_BOUNDING_ARCS_2_CHAIN_ARC_CHAIN_H
#define CGAL_BOUNDING_ARCS_2_CHAIN_ARC_CHAIN_H

#include <CGAL/Bounding_arcs_2/chain/Arc_chain_2.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>

#include <vector>

namespace CGAL::Bounding_arcs {

template <class NT> class Bezier_spiral_2;

/// Returns arcs and segments that follow the spiral segments of a tree, in their order. Each arc starts
/// where the one before ends, bit for bit, where the curve does; both ends of a spiral segment are break points. A
/// straight segment becomes one segment, a circular one a single arc.
/// \param eps the largest error of an arc, in units of the coordinates, positive
/// \return a chain whose status is COMPLETE when every error is at most eps; RESOLUTION_REACHED when eps is below what
///   coordinates resolve, with the errors reached; REGION_LIMIT, and no arcs, above max_arcs
/// \throws std::invalid_argument for an eps that is not positive, and for curves out of the range of check_queried
/// \guarantee certified: an arc's error is at least the Frechet distance, hence the Hausdorff distance, between the arc
///   with this `from`, `to` and `bulge` and the curve's piece [t0, t1], rounding included. Only an error that could be
///   brought neither to eps nor to what coordinates resolve is some number above both. With a side, the chain is on it
///   but for rounding of coordinates. Tangents at joints agree but for rounding. The number of arcs is a heuristic
///   close to the least, see doc/arcs.md
/// \complexity less than two fits an arc of two-sided chains of polynomial curves of degree 2 and 3, about three of
///   others
[[nodiscard]] Arc_chain arc_chain(const Bounding_arc_tree_2& tree, double eps, const Arc_chain_options& options = {});
/// Returns arcs that follow spiral segments in hand, of one curve or of several. See above.
[[nodiscard]] Arc_chain arc_chain(const std::vector<Bezier_spiral_2<double>>& spirals, double eps,
                                  const Arc_chain_options& options = {});

}  // namespace CGAL::Bounding_arcs

#endif
