// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// An axis as few long ways, as a tool follows them: the longest one first, then what branches off.
//
//     .             .      of each connected part a forest of its longest edges, cut into longest ways;
//      `--.-------.'       each edge that closes a way round is one of its own
//      .'         `.

#ifndef CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_AXIS_BRANCHES_H
#define CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_AXIS_BRANCHES_H

#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>

#include <cstddef>
#include <limits>
#include <ostream>
#include <vector>

namespace CGAL::Bounding_arcs {

/// A way along the axis.
/// \code
/// for (const Medial_axis_2::Branch& branch : axis_branches(axis, 0.5))  // where discs have radii of at most 0.5
///   for (const Medial_axis_2::Sample& s : branch.samples) std::cout << s.center.x << ' ' << s.center.y << ' ' <<
///   -s.radius;
/// \endcode
struct Medial_axis_2::Branch {
  std::vector<Sample> samples;  ///< one of a disc without edges; a way round has its first one again at the end
  double length = 0;            ///< of the straight lines between centers
  std::size_t part = 0;         ///< the connected part of what is taken that it belongs to

  /// Writes a line for each sample.
  friend std::ostream& operator<<(std::ostream& out, const Branch& all) {
    for (const Sample& one : all.samples) out << one << '\n';
    return out;
  }
};

/// Returns the axis as few long ways, or what of it has no larger discs.
///
/// Parts come one after the other, those with the longest first branches first. The first branch of a part is the
/// longest way in a tree of its longest edges. What branches off follows, the longest first, each with its start on a
/// branch before it. Edges that close a way round are branches of their own among these.
/// \param largest radius of a disc; where the axis has a larger one, a branch ends, or begins, at that radius
/// \guarantee each line between two samples is on one branch, less what has larger discs; ends there are on the line
///   between two samples, so within axis.eps of the axis, radii included. Where at most three edges meet in a vertex no
///   fewer ways can have each line once
/// \throws std::invalid_argument for a radius that is not above 0
/// \complexity n log n in the edges, linear in the samples
[[nodiscard]] std::vector<Medial_axis_2::Branch> axis_branches(
    const Medial_axis_2& axis, double largest = std::numeric_limits<double>::infinity());

}  // namespace CGAL::Bounding_arcs

#endif
