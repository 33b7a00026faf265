// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A curve as few circular arcs and segments as a tolerance allows, each with a certified bound of its error.

#ifndef CGAL_BOUNDING_ARCS_2_CHAIN_ARC_CHAIN_H
#define CGAL_BOUNDING_ARCS_2_CHAIN_ARC_CHAIN_H

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>
#include <CGAL/Bounding_arcs_2/tree/Build_options.h>

#include <cstddef>
#include <iosfwd>
#include <vector>

namespace CGAL::Bounding_arcs {

// One arc or segment of a chain that approximates a curve, given by its ends and its bulge as in DXF files.

/// Few circular arcs and segments within a tolerance of curves, as arc_chain() returns them. CAD programs and machines
/// read these where they do not read splines.
/// \code
/// const Arc_chain chain = arc_chain(tree, 1e-4);
/// for (const Arc_chain::Arc& arc : chain.arcs) std::cout << arc.from.x << ' ' << arc.from.y << ' ' << arc.bulge <<
/// '\n';
/// \endcode
/// An arc is given by its ends and its bulge, the tangent of a quarter of its angle, as in DXF; radius() and center()
/// of Arc_2.h are rounded. Each arc has a certified bound of its distance from the piece of curve that it stands for.
/// If `status` is COMPLETE, all bounds are at most eps.
///
/// By default arcs meet with common tangents and lie on both sides of the curve. Take Arc_chain::Continuity::POSITION
/// for about two thirds as many arcs, with corners of small angles. Take Arc_chain::Side::LEFT or RIGHT where the chain
/// must not cross the curve; that takes more arcs.
struct Arc_chain {
  /// An arc or a segment of a chain, and what it stands for.
  struct Arc : Arc_2 {
    double t0 = 0, t1 = 0;   ///< the piece of curve that it stands for
    double error = 0;        ///< at least the distance between the two, see arc_chain
    std::size_t spiral = 0;  ///< the index of that piece's spiral segment
  };

  /// What a chain of arcs does where two arcs meet inside a smooth piece of the curve.
  enum class Continuity {
    POSITION,  ///< meets: one arc a piece, both ends on the curve
    TANGENT    ///< meets with a common tangent: a biarc a piece, with the curve's ends and tangents
  };

  /// The side of the curve, seen along it, on which a chain runs.
  enum class Side { BOTH, LEFT, RIGHT };

  /// How a curve becomes a chain of arcs.
  /// \code
  /// Arc_chain::Options options;
  /// options.continuity = Arc_chain::Continuity::POSITION;  // fewer arcs, with corners
  /// const Arc_chain chain = arc_chain(tree, 1e-4, options);
  /// \endcode
  struct Options {
    Continuity continuity = Continuity::TANGENT;
    Side side = Side::BOTH;
    std::size_t max_arcs = 20'000'000;
    Build_options::Instruction_set instruction_set =
        Build_options::Instruction_set::BEST;  ///< results do not depend on it
  };

  std::vector<Arc> arcs;  ///< in curve order
  double error = 0;       ///< the largest of an arc
  Build_status status = Build_status::COMPLETE;
};

/// Writes a chain on the line, with 17 digits: `from.x from.y` of the first arc, then `bulge to.x to.y` of each.
/// An arc that does not start where the one before ends has `, from.x from.y` before its bulge. No arcs write nothing.
std::ostream& operator<<(std::ostream& out, const Arc_chain& chain);

template <class NT> class Bezier_spiral_2;

/// Returns arcs and segments that follow the spiral segments of a tree, in their order. Each arc starts
/// where the one before ends, bit for bit, where the curve does; both ends of a spiral segment are break points. A
/// straight segment becomes one segment, a circular one a single arc.
/// \param eps the largest error of an arc, in units of the coordinates, positive
/// \return a chain whose status is COMPLETE when every error is at most eps; RESOLUTION_REACHED when eps is below what
///   coordinates resolve, with the errors reached; REGION_LIMIT, and no arcs, above max_arcs
/// \throws std::invalid_argument for an eps that is not positive, and for curves out of the range of queries
/// \guarantee certified: an arc's error is at least the Frechet distance, hence the Hausdorff distance, between the arc
///   with this `from`, `to` and `bulge` and the curve's piece [t0, t1], rounding included. Only an error that could be
///   brought neither to eps nor to what coordinates resolve is some number above both. With a side, the chain is on it
///   but for rounding of coordinates. Tangents at joints agree but for rounding. The number of arcs is a heuristic
///   close to the least, see doc/arcs.md
/// \complexity less than two fits an arc of two-sided chains of polynomial curves of degree 2 and 3, about three of
///   others
[[nodiscard]] Arc_chain arc_chain(const Bounding_arc_tree_2& tree, double eps, const Arc_chain::Options& options = {});
/// Returns arcs that follow spiral segments in hand, of one curve or of several. See above.
[[nodiscard]] Arc_chain arc_chain(const std::vector<Bezier_spiral_2<double>>& spirals, double eps,
                                  const Arc_chain::Options& options = {});

}  // namespace CGAL::Bounding_arcs

#endif
