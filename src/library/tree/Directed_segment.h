// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A segment as a ring goes along it.

#ifndef BOUNDING_ARCS_LIBRARY_TREE_DIRECTED_SEGMENT_H
#define BOUNDING_ARCS_LIBRARY_TREE_DIRECTED_SEGMENT_H

#include <cstdint>

namespace CGAL::Bounding_arcs {

/// A segment in its direction or against it.
struct Directed_segment {
  std::uint32_t segment = 0;
  bool is_reversed = false;
};

}  // namespace CGAL::Bounding_arcs

#endif
