// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What an offset of a tree is made by.

#ifndef CGAL_BOUNDING_ARCS_2_OFFSET_INTERNAL_JOB_OF_H
#define CGAL_BOUNDING_ARCS_2_OFFSET_INTERNAL_JOB_OF_H

#include <CGAL/Bounding_arcs_2/offset/Offset_job.h>
#include <CGAL/Bounding_arcs_2/tree/tree_declaration.h>

namespace CGAL::Bounding_arcs::internal {

template <class Traits, class Spiral, class Decider>
[[nodiscard]] Offset_job job_of(const Bounding_arc_tree_2<Traits, Spiral, Decider>& tree, double eps,
                                const Offset_options& options) {
  return offset_job(eps, options, tree.rounding());
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
