// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a chain of arcs is asked for, and what is told of it; arc_chain.h makes one.

#ifndef CGAL_BOUNDING_ARCS_2_CHAIN_ARC_CHAIN_2_H
#define CGAL_BOUNDING_ARCS_2_CHAIN_ARC_CHAIN_2_H

#include <CGAL/Bounding_arcs_2/chain/Chain_arc_2.h>
#include <CGAL/Bounding_arcs_2/tree/Build_options.h>

#include <cstddef>
#include <iosfwd>
#include <vector>

namespace CGAL::Bounding_arcs {

/// What a chain of arcs does where two arcs meet inside a smooth piece of the curve.
enum class Continuity {
  POSITION,  ///< meets: one arc a piece, both ends on the curve
  TANGENT    ///< meets with a common tangent: a biarc a piece, with the curve's ends and tangents
};

/// The side of the curve, seen along it, on which a chain runs.
enum class Chain_side { BOTH, LEFT, RIGHT };

/// How a curve becomes a chain of arcs.
/// \code
/// Arc_chain_options options;
/// options.continuity = Continuity::POSITION;  // fewer arcs, with corners
/// const Arc_chain chain = arc_chain(tree, 1e-4, options);
/// \endcode
struct Arc_chain_options {
  Continuity continuity = Continuity::TANGENT;
  Chain_side side = Chain_side::BOTH;
  std::size_t max_arcs = 20'000'000;
  Instruction_set instruction_set = Instruction_set::BEST;  ///< results do not depend on it
};

/// Arcs within a tolerance of curves, and what was reached.
/// \code
/// const Arc_chain chain = arc_chain(tree, 1e-4);
/// for (const Chain_arc_2& arc : chain.arcs) std::cout << arc.from.x << ' ' << arc.from.y << ' ' << arc.bulge << '\n';
/// \endcode
struct Arc_chain {
  std::vector<Chain_arc_2> arcs;  ///< in curve order
  double error = 0;               ///< the largest of an arc
  Build_status status = Build_status::COMPLETE;
};

/// Writes a chain on the line, with 17 digits: `from.x from.y` of the first arc, then `bulge to.x to.y` of each.
/// An arc that does not start where the one before ends has `, from.x from.y` before its bulge. No arcs write nothing.
std::ostream& operator<<(std::ostream& out, const Arc_chain& chain);

}  // namespace CGAL::Bounding_arcs

#endif
