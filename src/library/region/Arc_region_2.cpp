// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of region/Arc_region_2.h.

#include "../arc/Arc_text.h"

#include <CGAL/Bounding_arcs_2/region/Arc_region_2.h>

namespace CGAL::Bounding_arcs {

std::ostream& operator<<(std::ostream& out, const Arc_region_2& region) {
  Arc_text text(out);
  text << region.from;
  for (const Arc_region_2::Side* side : {&region.inner, &region.outer}) {
    text.open("[") << side->bulges[0];
    if (side->size == 2) text << side->joint << side->bulges[1];
    text.mark("]");
  }
  text << region.to << region.widening;
  return out;
}

}  // namespace CGAL::Bounding_arcs
