// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// An offset between two: chains that are certainly inside of it and chains that are certainly outside.

#ifndef CGAL_BOUNDING_ARCS_2_OFFSET_OFFSET_BRACKET_H
#define CGAL_BOUNDING_ARCS_2_OFFSET_OFFSET_BRACKET_H

#include <CGAL/Bounding_arcs_2/offset/Offset_2.h>
#include <CGAL/Bounding_arcs_2/region/Arc_region_2.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>

namespace CGAL::Bounding_arcs {

/// Two offsets with the true one between them; their regions, not their chains, are inside and outside.
/// \code
/// const Offset_bracket bracket = offset_bracket(closed, 0.1, 1e-4);
/// std::cout << bracket.inside.chains.front().area << " < " << bracket.outside.chains.front().area << '\n';
/// \endcode
struct Offset_bracket {
  Offset inside, outside;
};

/// Returns an offset between two.
/// \param d a signed distance; of open curves alone |d| is that of the band
/// \param eps how wide the bracket is, in units of the coordinates, positive
/// \param options with round joins and caps and both sides, for which alone distances tell what is inside
/// \return offsets at distances less and more than d by eps / 4, each within eps / 4
/// \throws std::invalid_argument where |d| is not larger than eps, or the options are others, and as Offset_source_2
/// \guarantee where both are COMPLETE: the distance of all points of `inside` from the curves, where d < 0 from what of
///   them bounds, is one for which they belong to the true offset's region. The distance of points of `outside` is one
///   for which they do not. Both may be d itself, but for rounding. Take a point on each side of the true offset, one
///   nearest to the other: their distances from the curves differ by no more than eps
[[nodiscard]] Offset_bracket offset_bracket(const Bounding_arc_tree_2& tree, double d, double eps,
                                            const Offset_options& options = {});

/// Returns what is within d of a region, rounded outward: of one region a closed chain, ready to stand for a tolerance
/// or a tool's way.
/// \param d positive
/// \param eps how far the chain may be beyond d, positive
/// \guarantee where the result is COMPLETE all of the region is inside its chains. So is the curve that the region
///   encloses, where its widening is known. Each point of the chains is d to d + eps away, and the widening
[[nodiscard]] Offset sleeve(const Arc_region_2& region, double d, double eps);

}  // namespace CGAL::Bounding_arcs

#endif
