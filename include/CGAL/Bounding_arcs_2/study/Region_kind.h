// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The kinds of region by name.

#ifndef CGAL_BOUNDING_ARCS_2_STUDY_REGION_KIND_H
#define CGAL_BOUNDING_ARCS_2_STUDY_REGION_KIND_H

#include <CGAL/Bounding_arcs_2/number/strict_math.h>

namespace CGAL::Bounding_arcs {

/// The library's three, and those to compare them with.
enum class Region_kind { BCA, SFA, BILENS, FAT_ARC, FAT_BIARC, BOX, ORIENTED_BOX, HULL };

}  // namespace CGAL::Bounding_arcs

#endif
