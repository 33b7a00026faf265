// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Invariant: a range holds its exact parameter, and is a single double only where the parameter is that double.

#ifndef CGAL_BOUNDING_ARCS_2_POLYNOMIAL_PARAMETER_RANGE_H
#define CGAL_BOUNDING_ARCS_2_POLYNOMIAL_PARAMETER_RANGE_H

#include <CGAL/Bounding_arcs_2/number/strict_math.h>

namespace CGAL::Bounding_arcs {

/// Holds one exact parameter in [0,1]; at most three doubles wide.
struct Parameter_range {
  double lower = 0, upper = 0;
};

}  // namespace CGAL::Bounding_arcs

#endif
