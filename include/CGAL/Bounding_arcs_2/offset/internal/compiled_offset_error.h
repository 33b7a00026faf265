// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The error of an offset, which the library has compiled.

#ifndef CGAL_BOUNDING_ARCS_2_OFFSET_INTERNAL_COMPILED_OFFSET_ERROR_H
#define CGAL_BOUNDING_ARCS_2_OFFSET_INTERNAL_COMPILED_OFFSET_ERROR_H

#include <CGAL/Bounding_arcs_2/offset/Offset_2.h>
#include <CGAL/Bounding_arcs_2/tree/Drawing_hierarchy.h>

#include <optional>

namespace CGAL::Bounding_arcs {

struct Offset_error;

namespace internal {

[[nodiscard]] std::optional<Offset_error> offset_error(const Drawing_hierarchy& curves, const Offset& offset,
                                                       double eps);

}  // namespace internal

}  // namespace CGAL::Bounding_arcs

#endif
