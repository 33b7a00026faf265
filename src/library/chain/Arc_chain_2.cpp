// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of chain/arc_chain.h.

#include "../arc/Arc_text.h"

#include <CGAL/Bounding_arcs_2/chain/arc_chain.h>

namespace CGAL::Bounding_arcs {

std::ostream& operator<<(std::ostream& out, const Arc_chain& chain) {
  Arc_text text(out);
  for (const Arc_2& arc : chain.arcs) text << arc;
  return out;
}

}  // namespace CGAL::Bounding_arcs
