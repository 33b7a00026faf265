// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The boundary of a region that is made of faces of an overlay: loops of edges, with the region to their left.

#ifndef BOUNDING_ARCS_LIBRARY_BOOLEAN_REGION_LOOPS_H
#define BOUNDING_ARCS_LIBRARY_BOOLEAN_REGION_LOOPS_H

#include "../overlay/Overlay.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// A closed way along sides of edges, each of which has the region to its left.
struct Region_loop {
  std::vector<Edge_side> sides;
  bool is_ccw = true;
  std::optional<std::size_t> parent;  ///< the innermost loop around it
};

/// What loops do where they come to a vertex again.
enum class Loops_at_vertices { SPLIT, GO_ON };

/// \param is_inside by face
[[nodiscard]] std::vector<Region_loop> region_loops(const Overlay& overlay, const std::vector<char>& is_inside,
                                                    Loops_at_vertices at_vertices);

}  // namespace CGAL::Bounding_arcs::internal

#endif
