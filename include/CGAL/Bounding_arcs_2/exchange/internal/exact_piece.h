// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The circle or line through the ends of an arc, over a field: five doubles are rational numbers, and so are the center
// and the squared radius.  All that goes to CGAL is made of these pieces.

#ifndef CGAL_BOUNDING_ARCS_2_EXCHANGE_INTERNAL_EXACT_PIECE_H
#define CGAL_BOUNDING_ARCS_2_EXCHANGE_INTERNAL_EXACT_PIECE_H

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/region/Arc_region_2.h>

#include <cmath>
#include <stdexcept>
#include <type_traits>

namespace CGAL::Bounding_arcs {

/// The piece in the numbers of an exact kernel.
template <class FT, class NT> [[nodiscard]] Boundary_piece_2<FT> piece_over(const Boundary_piece_2<NT>& p) {
  static_assert(!std::is_floating_point_v<NT>, "a boundary in floating numbers misses its ends; hand over its arcs");
  const auto point = [](const Xy<NT>& q) { return Xy<FT>{FT(q.x), FT(q.y)}; };
  return {point(p.from), point(p.to), {point(p.support.point), point(p.support.normal), FT(p.support.curvature)}};
}
/// The piece of the arc's circle or line between its ends, over a field; of an arc in doubles exactly.
/// \throws std::invalid_argument if a number is none
template <class FT> [[nodiscard]] Boundary_piece_2<FT> exact_piece(const Arc_2& arc) {
  for (const double x : {arc.from.x, arc.from.y, arc.to.x, arc.to.y, arc.bulge})
    if (!std::isfinite(x)) throw std::invalid_argument(expected("arc", "finite coordinates and bulge", x));
  return piece_on_chord(Xy<FT>{FT(arc.from.x), FT(arc.from.y)}, Xy<FT>{FT(arc.to.x), FT(arc.to.y)}, FT(arc.bulge));
}
/// \throws std::invalid_argument if the piece is a point, which has no circle
template <class FT> void require_two_ends(const Boundary_piece_2<FT>& p) {
  if (p.from == p.to) throw std::invalid_argument(expected("piece", "two different ends", "equal ones"));
}

}  // namespace CGAL::Bounding_arcs

#endif
