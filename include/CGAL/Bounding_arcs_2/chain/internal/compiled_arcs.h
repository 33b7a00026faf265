// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Chains of arcs, which the library has compiled, of spiral segments: one curve or several that are joined.

#ifndef CGAL_BOUNDING_ARCS_2_CHAIN_INTERNAL_COMPILED_ARCS_H
#define CGAL_BOUNDING_ARCS_2_CHAIN_INTERNAL_COMPILED_ARCS_H

#include <CGAL/Bounding_arcs_2/chain/Arc_chain_2.h>
#include <CGAL/Bounding_arcs_2/spiral/Bezier_spiral_2.h>

#include <vector>

namespace CGAL::Bounding_arcs::internal {

[[nodiscard]] Arc_chain arc_chain(const std::vector<Bezier_spiral_2<double>>& spirals, double eps,
                                  const Arc_chain_options& options = {});

}  // namespace CGAL::Bounding_arcs::internal

#endif
