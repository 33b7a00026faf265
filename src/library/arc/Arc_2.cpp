// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of arc/Arc_2.h.

#include "Arc_text.h"

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>

namespace CGAL::Bounding_arcs {

std::ostream& operator<<(std::ostream& out, const Arc_2& arc) {
  Arc_text(out) << arc;
  return out;
}

}  // namespace CGAL::Bounding_arcs
