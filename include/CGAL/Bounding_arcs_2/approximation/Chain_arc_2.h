// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One arc or segment of a chain that approximates a curve, given by its ends and its bulge as in DXF files.

#ifndef CGAL_BOUNDING_ARCS_2_APPROXIMATION_CHAIN_ARC_2_H
#define CGAL_BOUNDING_ARCS_2_APPROXIMATION_CHAIN_ARC_2_H

#include <CGAL/Bounding_arcs_2/curve/Xy.h>

#include <cmath>
#include <cstddef>

namespace CGAL::Bounding_arcs {

/// The arc `from` -> `to` that turns by 4 atan(bulge), to the left for a positive bulge; 0 is the segment.
struct Chain_arc_2 {
  Xy<double> from, to;
  double bulge = 0;
  double t0 = 0, t1 = 0;   ///< the piece of curve that it stands for
  double error = 0;        ///< at least the distance between the two, see arc_chain
  std::size_t spiral = 0;  ///< the index of that piece's spiral segment

  [[nodiscard]] bool is_segment() const { return bulge == 0; }
  [[nodiscard]] bool is_ccw() const { return bulge > 0; }
  /// Rounded to double, which costs flat arcs digits that the bulge has. \pre not a segment
  [[nodiscard]] Xy<double> center() const {
    const Xy<double> chord = to - from;
    return from + 0.5 * chord + ((1 - bulge) * (1 + bulge) / (4 * bulge)) * perp(chord);
  }
  /// \pre not a segment
  [[nodiscard]] double radius() const {
    return std::hypot(to.x - from.x, to.y - from.y) * (1 + bulge * bulge) / (4 * std::fabs(bulge));
  }
};

}  // namespace CGAL::Bounding_arcs

#endif
