// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is made of several offsets: insets until nothing is left, opening and closing.

#ifndef CGAL_BOUNDING_ARCS_2_OFFSET_OFFSET_SERIES_H
#define CGAL_BOUNDING_ARCS_2_OFFSET_OFFSET_SERIES_H

#include <CGAL/Bounding_arcs_2/offset/Offset_2.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>

#include <vector>

namespace CGAL::Bounding_arcs {

/// Returns insets of closed curves a step apart, from the first until nothing is left: a pocket's tool paths.
/// \param step a positive length; there are as many insets as steps to the center of the largest inscribed circle
/// \throws std::invalid_argument for a step that is not larger than eps, and as Offset_source_2
[[nodiscard]] std::vector<Offset> insets(const Bounding_arc_tree_2& tree, double step, double eps,
                                         const Offset::Options& options = {});

/// Returns the opening: what discs of a radius cover that are in what closed curves enclose.  Round outer corners are
/// left. These are two offsets, one after the other: pieces of the second have pieces of the first as their places,
/// `curve` is a chain, `bezier` a piece of it.
/// \guarantee each of both as Offset_source_2::at, of half of eps: the second's points are that far from the first's
///   chains; the result is not COMPLETE where the first is not
[[nodiscard]] Offset opening(const Bounding_arc_tree_2& tree, double radius, double eps,
                             const Offset::Options& options = {});
/// Returns the closing: what discs of a radius do not cover that are outside.  Gaps are closed, and inner corners
/// rounded. Places and guarantees are as for the opening.
[[nodiscard]] Offset closing(const Bounding_arc_tree_2& tree, double radius, double eps,
                             const Offset::Options& options = {});

}  // namespace CGAL::Bounding_arcs

#endif
