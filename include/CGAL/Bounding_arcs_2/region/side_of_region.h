// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a point lies against a region, by signs only: caps of arcs over their own chords, and the triangle between two.

#ifndef CGAL_BOUNDING_ARCS_2_REGION_SIDE_OF_REGION_H
#define CGAL_BOUNDING_ARCS_2_REGION_SIDE_OF_REGION_H

#include <CGAL/Bounding_arcs_2/region/Contact_circle_2.h>

#include <CGAL/enum.h>

#include <cmath>

namespace CGAL::Bounding_arcs {
/// The sign of where q lies against one piece and its chord: +1 strictly between them, 0 on the piece, -1 elsewhere.
template <class NT> [[nodiscard]] int side_of_cap(const Boundary_piece_2<NT>& piece, const Xy<NT>& q) {
  const Xy<NT> chord = piece.to - piece.from, v = q - piece.from;
  const int chord_side = sign_of(cross(chord, v));
  if (piece.is_segment()) {
    const NT along = dot(chord, v);
    return chord_side == 0 && !(along < NT(0)) && !(dot(chord, chord) < along) ? 0 : -1;
  }
  const int turn = piece.is_ccw() ? 1 : -1;
  if (turn * chord_side > 0) return -1;
  const int circle_side = turn * sign_of(piece.support.side(q));
  if (circle_side < 0) return -1;
  if (circle_side == 0) return 0;
  return 1;
}

/// +1 strictly between a chain and its chord (the chord included), 0 on the chain, -1 beyond.
template <class NT> [[nodiscard]] int side_of_chain(const Boundary_chain_2<NT>& chain, const Xy<NT>& q) {
  int side = -1;
  for (const Boundary_piece_2<NT>& piece : chain) {
    const int cap = side_of_cap(piece, q);
    if (cap == 0) return 0;
    if (cap > 0) side = 1;
  }
  if (side > 0 || chain.size() == 1) return side;
  const Xy<NT>&p = chain[0].from, &j = chain[0].to, &r = chain[1].to;
  const int orientation = sign_of(cross(j - p, r - p));
  const int a = orientation * sign_of(cross(j - p, q - p)), b = orientation * sign_of(cross(r - j, q - j)),
            c = orientation * sign_of(cross(p - r, q - r));
  return orientation != 0 && a >= 0 && b >= 0 && c >= 0 ? 1 : -1;
}

/// Inside, on the boundary of, or outside the closed region between inner and outer boundary.
/// \guarantee exact where the boundary's coordinates are; over double as good as they are
template <class NT>
[[nodiscard]] CGAL::Bounded_side bounded_side(const Region_boundary_2<NT>& region, const Xy<NT>& q) {
  const int outer = side_of_chain(region.outer, q), inner = side_of_chain(region.inner, q);
  const Boundary_piece_2<NT>&first = region.outer[0], &second = region.inner[0];
  const bool opposite = !first.is_segment() && !second.is_segment() && first.is_ccw() != second.is_ccw();
  if (opposite) {  // a sliver past an inflection: the two arcs lie on different sides of the chord
    if (outer == 0 || inner == 0) return CGAL::ON_BOUNDARY;
    return outer > 0 || inner > 0 ? CGAL::ON_BOUNDED_SIDE : CGAL::ON_UNBOUNDED_SIDE;
  }
  if (outer == 0 || inner == 0) {
    // the other chain decides whether this boundary point is one of the region's
    const int other = outer == 0 ? -inner : outer;
    return other < 0 ? CGAL::ON_UNBOUNDED_SIDE : CGAL::ON_BOUNDARY;
  }
  return outer > 0 && inner < 0 ? CGAL::ON_BOUNDED_SIDE : CGAL::ON_UNBOUNDED_SIDE;
}

}  // namespace CGAL::Bounding_arcs

#endif
