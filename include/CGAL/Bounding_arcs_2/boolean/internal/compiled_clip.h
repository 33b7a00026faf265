// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What boolean/clip.h calls, compiled in the library.

#ifndef CGAL_BOUNDING_ARCS_2_BOOLEAN_INTERNAL_COMPILED_CLIP_H
#define CGAL_BOUNDING_ARCS_2_BOOLEAN_INTERNAL_COMPILED_CLIP_H

#include <CGAL/Bounding_arcs_2/boolean/Clipped_2.h>
#include <CGAL/Bounding_arcs_2/curve/Fill_rule.h>
#include <CGAL/Bounding_arcs_2/tree/Drawing_hierarchy.h>

namespace CGAL::Bounding_arcs::internal {

/// \throws std::invalid_argument for an open curve of the region
[[nodiscard]] Clipped_2 clip(const Drawing_hierarchy& curves, const Drawing_hierarchy& region, Fill_rule rule);

}  // namespace CGAL::Bounding_arcs::internal

#endif
