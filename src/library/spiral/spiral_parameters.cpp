// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of spiral/spiral_parameters.h.

#include "Cubic_roots.h"
#include "spiral_cuts.h"

#include <CGAL/Bounding_arcs_2/spiral/Segment_place.h>
#include <CGAL/Bounding_arcs_2/spiral/spiral_parameters.h>

#include <CGAL/FPU.h>

namespace CGAL::Bounding_arcs {

Spiral_parameters internal::spiral_cuts(const Cut_numbers& curve, const Cubic_roots* filter) {
  ++cut_count();
  const Protect_FPU_rounding<true> nearest(CGAL_FE_TONEAREST);
  const Numerator_roots roots = numerator_roots(curve, filter);
  const auto vanishes = [&roots](Numerator which, double t) { return vanishes_at(roots[which], t); };
  Spiral_parameters r;
  r.breaks = separated_cuts(roots);
  for (const double t : r.breaks) {
    const bool is_x = vanishes(SPEED_X, t), is_y = vanishes(SPEED_Y, t);
    r.reasons.push_back(is_x && is_y              ? Cut_reason::CUSP
                        : is_x                    ? Cut_reason::X
                        : is_y                    ? Cut_reason::Y
                        : vanishes(INFLECTION, t) ? Cut_reason::INFLECTION
                                                  : Cut_reason::VERTEX);
  }
  r.is_point = roots[SPEED_X].is_zero && roots[SPEED_Y].is_zero;
  r.is_straight = roots[INFLECTION].is_zero;
  r.is_circular = roots[CURVATURE_CHANGE].is_zero && !r.is_straight;
  r.has_hidden_tip = has_hidden_tip(curve, roots, r.breaks);
  return r;
}

template <> Spiral_parameters spiral_parameters(const Bezier_curve_2<double>& curve) {
  internal::check_finite(curve);
  return internal::with_cut_numbers(curve, [&](const internal::Cut_numbers& numbers) {
    const internal::Cubic_roots filter(curve);
    return internal::spiral_cuts(numbers, &filter);
  });
}

}  // namespace CGAL::Bounding_arcs
