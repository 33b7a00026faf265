// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The medial axis, whose threads are an argument: it is compiled without any.

#ifndef CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_INTERNAL_AXIS_SEARCH_H
#define CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_INTERNAL_AXIS_SEARCH_H

#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>
#include <CGAL/Bounding_arcs_2/medial_axis/internal/Axis_job.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>

namespace CGAL::Bounding_arcs::internal {

[[nodiscard]] Medial_axis_2 medial_axis(const Bounding_arc_tree_2& curves, const Axis_job& job = {});

}  // namespace CGAL::Bounding_arcs::internal

#endif
