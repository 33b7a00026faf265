// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What an axis keeps of its boundary, declared for those who only hand it on.

#ifndef CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_INTERNAL_BOUNDS_DECLARATION_H
#define CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_INTERNAL_BOUNDS_DECLARATION_H

namespace CGAL::Bounding_arcs::internal {

struct Bounding_parts;

}  // namespace CGAL::Bounding_arcs::internal

#endif
