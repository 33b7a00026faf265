// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The loops that fit arcs, for one instruction set: compiled once for each, as the batch loops are
// (src/library/tree/batch_loops.cpp).

#include "../tree/for_instruction_sets.h"

#include "Arc_columns.h"

namespace CGAL::Bounding_arcs::internal {

template <class Isa> void compiled_biarcs(Arc_columns& columns) { fit_biarcs<Isa>(columns); }
template <class Isa> void compiled_balanced(Arc_columns& columns) { fit_balanced<Isa>(columns); }

#define BOUNDING_ARCS_FITS(Isa)                     \
  template void compiled_biarcs<Isa>(Arc_columns&); \
  template void compiled_balanced<Isa>(Arc_columns&)
BOUNDING_ARCS_FOR_SETS(BOUNDING_ARCS_FITS)

}  // namespace CGAL::Bounding_arcs::internal
