// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One arc or segment of a chain that approximates a curve, given by its ends and its bulge as in DXF files.

#ifndef CGAL_BOUNDING_ARCS_2_CHAIN_CHAIN_ARC_2_H
#define CGAL_BOUNDING_ARCS_2_CHAIN_CHAIN_ARC_2_H

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>

#include <cstddef>

namespace CGAL::Bounding_arcs {

/// An arc or a segment of a chain, and what it stands for.
struct Chain_arc_2 : Arc_2 {
  double t0 = 0, t1 = 0;   ///< the piece of curve that it stands for
  double error = 0;        ///< at least the distance between the two, see arc_chain
  std::size_t spiral = 0;  ///< the index of that piece's spiral segment
};

}  // namespace CGAL::Bounding_arcs

#endif
