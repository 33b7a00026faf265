// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How a search ended.  Its bracket holds the true number whatever the status is.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_QUERY_STATUS_H
#define CGAL_BOUNDING_ARCS_2_QUERY_QUERY_STATUS_H

#include <CGAL/Bounding_arcs_2/number/strict_math.h>

#include <cstdint>

namespace CGAL::Bounding_arcs {

/// How a search ended.
enum class Query_status : std::uint8_t {
  COMPLETE,            ///< the bracket is as narrow as was asked, or as doubles tell where no tolerance was
  RESOLUTION_REACHED,  ///< the bracket is wider than the tolerance, as doubles tell no more
  LIMIT_REACHED        ///< the bracket is wider: the search took as much work as one in a drawing of this size may take
};

}  // namespace CGAL::Bounding_arcs

#endif
