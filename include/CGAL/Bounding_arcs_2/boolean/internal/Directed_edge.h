// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// An edge as a loop or a ring goes along it.

#ifndef CGAL_BOUNDING_ARCS_2_BOOLEAN_INTERNAL_DIRECTED_EDGE_H
#define CGAL_BOUNDING_ARCS_2_BOOLEAN_INTERNAL_DIRECTED_EDGE_H

#include <cstdint>

namespace CGAL::Bounding_arcs::internal {

/// An edge in the direction of its loop.
struct Directed_edge {
  std::uint32_t edge = 0;
  bool is_reversed = false;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
