// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The kernel of points where no other is named. It takes a second to read, so that only what needs it includes it.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_DEFAULT_KERNEL_H
#define CGAL_BOUNDING_ARCS_2_QUERY_DEFAULT_KERNEL_H

#include <CGAL/Bounding_arcs_2/number/strict_math.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace CGAL::Bounding_arcs {

/// The kernel of points that are asked about or answered where no other is named.
using Default_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

}  // namespace CGAL::Bounding_arcs

#endif
