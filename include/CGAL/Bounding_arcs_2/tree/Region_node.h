// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Places in a hierarchy and what they stand for.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_REGION_NODE_H
#define CGAL_BOUNDING_ARCS_2_TREE_REGION_NODE_H

#include <CGAL/Bounding_arcs_2/number/strict_math.h>

#include <cstddef>
#include <cstdint>

namespace CGAL::Bounding_arcs {

/// A place in the hierarchy: a box over spiral segments, or a region node over a piece of one.
struct Node_handle {
  bool is_region = false;
  bool is_leaf = false;      ///< of a region
  int level = 0;             ///< of a region how far below its segment's root
  std::uint32_t spiral = 0;  ///< of a region: the index of its segment
  std::size_t index = 0;     ///< of a box; of a stored region its dense index, of an equalised one its first leaf's
  std::uint64_t place = 0;   ///< of a box where its parent has it; of a region: piece `place` of the segment's 2^level;
                             ///< of an equalised one the number of leaves
};

/// The piece [t0, t1] of a spiral segment that a region node is over.
struct Region_node {
  double t0, t1;
  std::uint32_t spiral;  ///< the index of the spiral segment
  bool is_leaf;
};

}  // namespace CGAL::Bounding_arcs

#endif
