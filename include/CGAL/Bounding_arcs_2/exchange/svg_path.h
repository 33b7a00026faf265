// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Chains of arcs as path data of SVG, for pictures and for whatever reads it.

#ifndef CGAL_BOUNDING_ARCS_2_EXCHANGE_SVG_PATH_H
#define CGAL_BOUNDING_ARCS_2_EXCHANGE_SVG_PATH_H

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>
#include <CGAL/Bounding_arcs_2/offset/Offset_2.h>

#include <sstream>
#include <string>

namespace CGAL::Bounding_arcs {

/// Returns the chains of an offset as the `d` of an SVG path, a subpath a chain, closed ones with Z.
/// SVG's y runs downwards: `transform="scale(1,-1)"` shows the plane upright.
/// \return an empty string for an offset without chains
/// \guarantee ends of arcs are the same doubles when read again; radii are rounded
[[nodiscard]] inline std::string svg_path(const Offset& offset) {
  std::ostringstream out;
  out.precision(17);
  for (const Offset::Chain& chain : offset.chains) {
    const Xy<double>& start = chain.pieces.front().arc.from;
    out << 'M' << start.x << ' ' << start.y;
    for (const Offset::Piece& piece : chain.pieces) {
      const Arc_2& arc = piece.arc;
      if (arc.bulge == 0) out << 'L';
      else {
        const double r = radius(arc);
        out << 'A' << r << ' ' << r << " 0 0 " << (arc.bulge > 0 ? 1 : 0) << ' ';
      }
      out << arc.to.x << ' ' << arc.to.y;
    }
    if (chain.is_closed) out << 'Z';
  }
  return out.str();
}

}  // namespace CGAL::Bounding_arcs

#endif
