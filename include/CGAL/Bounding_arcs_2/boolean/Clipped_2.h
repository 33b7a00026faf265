// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Curves cut by a region.

#ifndef CGAL_BOUNDING_ARCS_2_BOOLEAN_CLIPPED_2_H
#define CGAL_BOUNDING_ARCS_2_BOOLEAN_CLIPPED_2_H

#include <CGAL/Bounding_arcs_2/number/Bracket.h>
#include <CGAL/Bounding_arcs_2/number/Xy.h>
#include <CGAL/Bounding_arcs_2/overlay/Outline_status.h>
#include <CGAL/Bounding_arcs_2/query/Point_side.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL::Bounding_arcs {

/// A part of one Bezier piece on one side of a region.
struct Clipped_part {
  std::uint32_t curve = 0;                ///< of the drawing
  std::uint32_t bezier = 0;               ///< of that curve
  Bracket from, to;                       ///< hold the parameters of start and end, which rise
  Xy<double> start, end;                  ///< these points but for rounding; parts of a piece share them bit for bit
  Point_side side = Point_side::OUTSIDE;  ///< ON: along a curve of the region, whatever that fills
};

/// All parts of some curves, in the order of the curves. The parts of a piece cover it.
/// \code
/// for (const Clipped_part& part : clip(hatching, region).parts)  // clip.h
///   if (part.side == Point_side::INSIDE) std::cout << part.start << " to " << part.end << '\n';
/// \endcode
struct Clipped_2 {
  std::vector<Clipped_part> parts;
  Outline_status status = Outline_status::COMPLETE;
  std::optional<Undecided_meeting> undecided;  ///< the first one, of curves as operand 0 and the region as operand 1
};

}  // namespace CGAL::Bounding_arcs

#endif
