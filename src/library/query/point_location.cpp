// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of point_location.h.

#include <CGAL/Bounding_arcs_2/query/Query_point.h>
#include <CGAL/Bounding_arcs_2/query/point_location.h>
#include "../tree/Segment_hierarchy.h"
#include "Winding_search.h"
#include "query_units.h"

namespace CGAL::Bounding_arcs {

Winding_number Point_location_2::winding_number(const Asked_point& q) const {
  return Bounding_arcs::winding_number(tree_->in_unit(), point_in(tree_->unit(), q));
}

}  // namespace CGAL::Bounding_arcs
