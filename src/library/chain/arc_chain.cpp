// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of chain/arc_chain.h.

#include <CGAL/Bounding_arcs_2/chain/arc_chain.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/tree/tree_spirals.h>
#include "Chain_builder.h"

#include <vector>

namespace CGAL::Bounding_arcs {

Arc_chain arc_chain(const Bounding_arc_tree_2& tree, double eps, const Arc_chain_options& options) {
  return arc_chain(spiral_segments(tree), eps, options);
}

Arc_chain arc_chain(const std::vector<Bezier_spiral_2<double>>& spirals, double eps, const Arc_chain_options& options) {
  check_above_zero("eps", eps);
  Chain_builder builder(eps, options, spirals.size());
  for (const Bezier_spiral_2<double>& spiral : spirals) builder.add(spiral);
  return builder.finish();
}

}  // namespace CGAL::Bounding_arcs
