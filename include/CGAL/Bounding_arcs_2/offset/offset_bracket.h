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

#include <optional>
#include <ostream>

namespace CGAL::Bounding_arcs {

// A check of offsets: how far the distances of all their points are from |d|, by the hierarchy and not by samples.

/// How far the points of an offset's round pieces are from where they should be. Each bracket holds a distance from the
/// curves less |d|.
/// \code
/// const auto error = offset_error(tree, offset(tree, 0.1, 1e-4), 1e-6);
/// if (error) std::cout << error->nearest.lower << " to " << error->farthest.upper << '\n';
/// \endcode
struct Offset::Error {
  Bracket nearest;   ///< of the point that is nearest to the curves; negative if it is nearer than |d|
  Bracket farthest;  ///< of the point that is farthest from the curves

  /// Writes the members in their order, with a blank between.
  friend std::ostream& operator<<(std::ostream& out, const Error& answer) {
    return out << answer.nearest << ' ' << answer.farthest;
  }
};

/// Returns how far an offset's points are from where they should be.
/// \param tree the curves that were offset. An inset (d < 0) of closed curves is measured from the boundary of what
///   they fill. If a part of the curves lies inside of that, give a tree of source.outline().drawing() instead. An
///   inset of open and closed curves has two sorts of chains: measure one sort at a time, with a tree of its curves
/// \param eps how wide brackets may be, a length
/// \return nothing for an offset without round pieces or a drawing without curves
/// \guarantee certified for the arcs as they are given, but for the rounding of Offset::drawing()
/// \complexity as for distance() and hausdorff_distance() of curves that are parallel: the cube root of 1 / eps
[[nodiscard]] std::optional<Offset::Error> offset_error(const Bounding_arc_tree_2& tree, const Offset& offset,
                                                        double eps);

/// Two offsets with the true one between them. The region of `inside` lies inside of the true offset's region, and that
/// of `outside` holds it. Take a bracket where a verdict hangs on the offset, such as whether a tool fits.
/// \code
/// const Offset::Bounds bracket = offset_bracket(closed, 0.1, 1e-4);
/// std::cout << bracket.inside.chains.front().area << " < " << bracket.outside.chains.front().area << '\n';
/// \endcode
struct Offset::Bounds {
  Offset inside, outside;
};

/// Returns two offsets with the true one between them.
/// \param d a signed distance; open curves alone have a band of width |d| on each side
/// \param eps how wide the bracket is, in units of the coordinates, positive
/// \param options with round joins and caps and both sides; other options are refused, as distances alone do not tell
///   what is inside there
/// \return the offsets at d - eps / 4 and at d + eps / 4, each within eps / 4
/// \throws std::invalid_argument where |d| is not larger than eps, or the options are others, and as Offset_source_2
/// \guarantee where both are COMPLETE: all points of `inside` belong to the true offset's region, and no point of
///   `outside` does, but for points at the distance d itself up to rounding. Distances are from the curves, where d < 0
///   from the boundary of what these fill. A point of `inside` and the point of `outside` nearest to it have distances
///   that differ by no more than eps
[[nodiscard]] Offset::Bounds offset_bracket(const Bounding_arc_tree_2& tree, double d, double eps,
                                            const Offset::Options& options = {});

/// Returns what is within d of a region, rounded outward: of one region a closed chain, ready to stand for a tolerance
/// or a tool's way.
/// \param d positive
/// \param eps how far the chain may be beyond d, positive
/// \guarantee where the result is COMPLETE all of the region is inside its chains. So is the curve that the region
///   encloses, where its widening is known. Each point of the chains is d to d + eps away, and the widening
[[nodiscard]] Offset sleeve(const Arc_region_2& region, double d, double eps);

}  // namespace CGAL::Bounding_arcs

#endif
