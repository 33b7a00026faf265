// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Two edges of an axis that meet in a vertex as one.

#ifndef BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_JOIN_EDGES_H
#define BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_JOIN_EDGES_H

#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace CGAL::Bounding_arcs::internal {

inline void reverse(Medial_edge& e) {
  std::reverse(e.samples.begin(), e.samples.end());
  for (Medial_sample& s : e.samples) std::swap(s.left, s.right);
  std::swap(e.from, e.to);
}
/// Appends to e what goes on from a vertex along f, which is of no use any more.
inline void join_edges(std::size_t vertex, Medial_edge& e, Medial_edge& f) {
  if (e.to != vertex) reverse(e);
  if (f.from != vertex) reverse(f);
  e.samples.insert(e.samples.end(), f.samples.begin() + 1, f.samples.end());
  e.to = f.to;
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
