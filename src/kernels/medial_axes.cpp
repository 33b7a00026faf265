// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Medial axes, once for all programs.

#include <CGAL/Bounding_arcs_2/internal/medial_axis/axis_of_uncrossed_impl.h>

namespace CGAL::Bounding_arcs::internal {

template Medial_axis_2 axis_of_uncrossed(const Curve_index_2&, const Medial_axis_options&);

}  // namespace CGAL::Bounding_arcs::internal
