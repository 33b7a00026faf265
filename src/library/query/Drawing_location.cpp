// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of Drawing_location.h.

#include <CGAL/Bounding_arcs_2/query/Drawing_location.h>
#include <CGAL/Bounding_arcs_2/query/Query_point.h>
#include <CGAL/Bounding_arcs_2/query/Winding_search.h>
#include <CGAL/Bounding_arcs_2/query/query_units.h>

namespace CGAL::Bounding_arcs {

Winding_number Drawing_location::winding_number(const Asked_point& q) const {
  return Bounding_arcs::winding_number(curves_->in_unit(), point_in(curves_->unit(), q));
}

}  // namespace CGAL::Bounding_arcs
