// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parts of two pieces about a place where doubles leave their common points open.
//
// Coordinates lose what the parts are smaller by than their curves: the middle of a curve of high degree may have waves
// of 1e-6 of its size.  Taken out exactly, moved to the origin and enlarged, the parts are ordinary pieces, and the
// same search decides.  Elimination decides, too, but of degrees m and n it takes polynomials of the degree m n.

#ifndef BOUNDING_ARCS_LIBRARY_QUERY_NEARER_LOOK_H
#define BOUNDING_ARCS_LIBRARY_QUERY_NEARER_LOOK_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>
#include <CGAL/Bounding_arcs_2/number/Bracket.h>
#include "../tree/Segment_hierarchy.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// Parts of two pieces, as they are seen from the start of the first one.
struct Nearer_look {
  Segment_hierarchy a, b;
};

/// A range with some of what is beside it.
[[nodiscard]] inline Bracket with_room(const Bracket& t) {
  const double room = t.width() + 0x1p-46;  // and what is known of a parameter
  return {t.lower - room, t.upper + room};
}
/// The parameter of a piece, of which one of its part in a range is known. \param u in [0, 1]
[[nodiscard]] inline Bracket parameter_on_whole(const Bracket& range, const Bracket& u) {
  constexpr double ROUNDING = 4 * HALF_ULP;  // of a difference, a product and a sum below 1
  return {range.lower + range.width() * u.lower - ROUNDING, range.lower + range.width() * u.upper + ROUNDING};
}

/// \param t, s ranges within [0, 1]
/// \return nothing where both parts are one point
[[nodiscard]] inline std::optional<Nearer_look> look_nearer(const Bezier_curve_2<Exact_rational>& a, const Bracket& t,
                                                            const Bezier_curve_2<Exact_rational>& b, const Bracket& s) {
  const auto part = [](const Bezier_curve_2<Exact_rational>& whole, const Bracket& range) {
    return whole.subcurve(Exact_rational(range.lower), Exact_rational(range.upper));
  };
  const Bezier_curve_2<Exact_rational> p = part(a, t), q = part(b, s);
  const Xy<Exact_rational> from = p.control_points().front();
  double size = 0;
  for (const auto* curve : {&p, &q})
    for (const Xy<Exact_rational>& c : curve->control_points())
      size = (std::max)({size, std::fabs(CGAL::to_double(Exact_rational(c.x - from.x))),
                         std::fabs(CGAL::to_double(Exact_rational(c.y - from.y)))});
  if (!(size > 0)) return std::nullopt;
  const Exact_rational unit(std::ldexp(1.0, std::ilogb(size)));
  const auto seen = [&](const Bezier_curve_2<Exact_rational>& curve) {
    std::vector<Xy<Exact_rational>> points;
    for (const Xy<Exact_rational>& c : curve.control_points())
      points.push_back({Exact_rational((c.x - from.x) / unit), Exact_rational((c.y - from.y) / unit)});
    Drawing_2<Exact_rational> drawing;
    drawing.add({Bezier_curve_2<Exact_rational>(std::move(points), curve.weights())});
    return Segment_hierarchy(drawing, Decisions::EXACT);
  };
  return Nearer_look{seen(p), seen(q)};
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
