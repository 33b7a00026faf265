// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// An outline as curves in doubles, with how far rounding moved it.

#ifndef CGAL_BOUNDING_ARCS_2_BOOLEAN_DRAWN_OUTLINE_H
#define CGAL_BOUNDING_ARCS_2_BOOLEAN_DRAWN_OUTLINE_H

#include <CGAL/Bounding_arcs_2/boolean/Outline_2.h>
#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>

namespace CGAL::Bounding_arcs {

/// How an outline becomes a drawing.
struct Outline_drawing_options {
  /// Leaves out parts that doubles do not tell from a point, and chains of which nothing else is there. Such a part has
  /// no direction for whoever reads the drawing, and another operation would cut it again.
  bool drops_tiny_parts = true;
};

/// An outline as a drawing in doubles, and what that is of.
/// \code
/// const Drawn_outline rest = drawn_outline(subtract(a, b), {&a, &b});
/// std::cout << rest.drawing.curves().size() << " curves, moved by " << rest.moved << " at most\n";
/// \endcode
struct Drawn_outline {
  Drawing_2<double> drawing;  ///< piece k of curve i is part k of chain i of `outline`
  Outline_2 outline;          ///< what is drawn: the outline without parts and chains that were left out
  double moved = 0;  ///< no point of a chain that is drawn is farther from its curve, and none of the curve farther
                     ///< from its chain; a chain that is left out is within that of one point
};

}  // namespace CGAL::Bounding_arcs

#endif
