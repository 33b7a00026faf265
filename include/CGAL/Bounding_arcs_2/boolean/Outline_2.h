// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The boundary of a region that closed curves enclose, made of parts of these curves.

#ifndef CGAL_BOUNDING_ARCS_2_BOOLEAN_OUTLINE_2_H
#define CGAL_BOUNDING_ARCS_2_BOOLEAN_OUTLINE_2_H

#include <CGAL/Bounding_arcs_2/number/Bracket.h>
#include <CGAL/Bounding_arcs_2/number/Xy.h>
#include <CGAL/Bounding_arcs_2/overlay/Outline_status.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL::Bounding_arcs {

/// What of several drawings makes a region.
enum class Boolean_operation : std::uint8_t {
  UNION,                ///< what any of them fills
  INTERSECTION,         ///< what all of them fill
  DIFFERENCE,           ///< what the first one fills and none of the others
  SYMMETRIC_DIFFERENCE  ///< what an odd number of them fills
};

/// A part of one Bezier piece.
struct Outline_part {
  std::uint32_t operand = 0;  ///< the number of the drawing, in the order in which they were given
  std::uint32_t curve = 0;    ///< of that drawing
  std::uint32_t bezier = 0;   ///< of that curve
  Bracket from, to;           ///< hold the parameters of start and end, which may be nearer than doubles tell
  bool is_reversed = false;   ///< whether the chain runs against the curve: `from` is above `to`
  Xy<double> start, end;      ///< these points but for rounding; neighbours share them bit for bit
};

/// A closed chain that does not meet itself but at single vertices.
struct Outline_chain {
  std::vector<Outline_part> parts;    ///< each starts where the one before ends, the first where the last one ends
  bool is_ccw = true;                 ///< the outside of a region; holes run clockwise
  std::optional<std::size_t> parent;  ///< the innermost chain around it
};

/// The boundary of a region: its inside is to the left of all chains.
/// \code
/// const Outline_2 united = unite(tree, other);  // trees of closed curves, boolean_operations.h
/// for (const Outline_chain& chain : united.chains)
///   for (const Outline_part& part : chain.parts) std::cout << part.start.x << ' ' << part.start.y << '\n';
/// \endcode
struct Outline_2 {
  std::vector<Outline_chain> chains;
  Outline_status status = Outline_status::COMPLETE;
  std::optional<Undecided_meeting> undecided;  ///< the first one, where `status` is UNDECIDED and that is known
};

}  // namespace CGAL::Bounding_arcs

#endif
