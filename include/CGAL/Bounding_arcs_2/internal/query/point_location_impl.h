// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of query/point_location.h, which the library has compiled.

#ifndef CGAL_BOUNDING_ARCS_2_INTERNAL_QUERY_POINT_LOCATION_IMPL_H
#define CGAL_BOUNDING_ARCS_2_INTERNAL_QUERY_POINT_LOCATION_IMPL_H

#include <CGAL/Bounding_arcs_2/internal/inline.h>
#include <CGAL/Bounding_arcs_2/internal/query/Common_unit.h>
#include <CGAL/Bounding_arcs_2/internal/query/Winding_search.h>
#include <CGAL/Bounding_arcs_2/query/Query_point.h>
#include <CGAL/Bounding_arcs_2/query/point_location.h>

namespace CGAL::Bounding_arcs {

CGAL_BOUNDING_ARCS_INLINE Winding_number Point_location_2::winding_number(const Xy<double>& q) const {
  internal::Winding_search search(index_.in_unit(), internal::point_in(index_.unit(), q));
  search.search();
  if (search.is_on()) return {Winding_number::State::ON, 0};
  if (search.is_undecided()) return {Winding_number::State::UNDECIDED, 0};
  return {Winding_number::State::DECIDED, search.number()};
}

}  // namespace CGAL::Bounding_arcs

#endif
