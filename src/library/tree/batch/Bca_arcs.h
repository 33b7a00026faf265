// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The bulges of BCAs in plain double, for batches: the tangents of half the end angles.  What these err by
// (Half_tangents.h) moves an arc by that times half the chord, which is to be within `room` (Arc_points.h).

#ifndef BOUNDING_ARCS_LIBRARY_TREE_BATCH_BCA_ARCS_H
#define BOUNDING_ARCS_LIBRARY_TREE_BATCH_BCA_ARCS_H

#include "Half_tangents.h"

#include <CGAL/Bounding_arcs_2/number/strict_math.h>
#include "../../spiral/Local_figures.h"

namespace CGAL::Bounding_arcs::filter {

/// The bulges of BCAs in plain double: the tangents of half the end angles.
struct Bca_arcs {
  /// The most that |z| + |1 - z| is for a point z of a side over the unit chord, and some ulp more:
  /// 1 / cos(22.5 degrees), in the middle of the outer arc.
  static constexpr double MOST_MOVED = 1.09;
  static_assert(MOST_MOVED * MOST_MOVED > 1 + 0.1716 + 0.01, "update the derivation above");

  double outer, inner;  ///< the larger bulge and the smaller; next to a vertex rounding may tell which end's is which
  bool holds;

  template <bool WIDE>
  [[nodiscard]] CGAL_BOUNDING_ARCS_INLINE static Bca_arcs of(const Local_form<double>& c, const Local_piece<double>& g,
                                                             double room) {
    constexpr double U = Local_precision<double>::HALF_ULP;
    const Half_tangents t = Half_tangents::of<WIDE>(g);
    const Arc_errors e = arc_errors(c, g, t);
    const double outer = t.tight > t.flat ? t.tight : t.flat, inner = t.tight > t.flat ? t.flat : t.tight;
    const double error = e.turn + e.dot * (Half_tangents::ROUNDINGS * U * e.bend);
    const bool holds = e.holds & (e.half_chord * error <= room * e.dot);
    return {outer, inner, holds};
  }
};

}  // namespace CGAL::Bounding_arcs::filter

#endif
