// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of spiral/spiral_parameters.h.

#include "Cubic_roots.h"
#include "spiral_cuts.h"

#include <CGAL/Bounding_arcs_2/spiral/spiral_parameters.h>

namespace CGAL::Bounding_arcs {

Spiral_parameters internal::spiral_cuts(const Cut_numbers& curve) { return spiral_cuts(curve, No_root_filter()); }

template <> Spiral_parameters spiral_parameters(const Bezier_curve_2<double>& curve) {
  internal::check_finite(curve);
  return internal::with_cut_numbers(curve, [&](const internal::Cut_numbers& numbers) {
    return internal::spiral_cuts(numbers, internal::Cubic_roots(curve));
  });
}

}  // namespace CGAL::Bounding_arcs
