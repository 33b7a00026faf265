// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The batch loops for one instruction set: compiled once for each, with BOUNDING_ARCS_ISA naming its tag.  What is
// inlined into them is always_inline, so that no other code picks up instructions of a wider set.

#include <CGAL/Bounding_arcs_2/chain/internal/Arc_columns.h>
#include <CGAL/Bounding_arcs_2/tree/internal/batch/Batch_function.h>
#include <CGAL/Bounding_arcs_2/tree/internal/batch/Bca_batch.h>
#include <CGAL/Bounding_arcs_2/tree/internal/batch/Bilens_batch.h>
#include <CGAL/Bounding_arcs_2/tree/internal/batch/Spiral_fat_arc_batch.h>

namespace CGAL::Bounding_arcs::filter {

template <class Isa, class Method> Batch_function compiled_batch(int kind) { return batch_of_kind<Isa, Method>(kind); }
template <class Isa, class Method> Top_function compiled_top(int kind) { return top_of_kind<Isa, Method>(kind); }
template <class Isa, class Arcs> Arc_function compiled_arcs(int kind) { return arcs_of_kind<Isa, Arcs>(kind); }
template <class Isa, class Arcs> Lanes_function compiled_lanes(int kind) { return lanes_of_kind<Isa, Arcs>(kind); }

template Batch_function compiled_batch<BOUNDING_ARCS_ISA, Bca_batch>(int);
template Top_function compiled_top<BOUNDING_ARCS_ISA, Bca_batch>(int);
template Batch_function compiled_batch<BOUNDING_ARCS_ISA, Spiral_fat_arc_batch>(int);
template Top_function compiled_top<BOUNDING_ARCS_ISA, Spiral_fat_arc_batch>(int);
template Batch_function compiled_batch<BOUNDING_ARCS_ISA, Bilens_batch>(int);
template Top_function compiled_top<BOUNDING_ARCS_ISA, Bilens_batch>(int);
template Arc_function compiled_arcs<BOUNDING_ARCS_ISA, Bca_arcs>(int);
template Lanes_function compiled_lanes<BOUNDING_ARCS_ISA, Bca_arcs>(int);
template Arc_function compiled_arcs<BOUNDING_ARCS_ISA, Spiral_fat_arc_arcs>(int);
template Lanes_function compiled_lanes<BOUNDING_ARCS_ISA, Spiral_fat_arc_arcs>(int);
template Arc_function compiled_arcs<BOUNDING_ARCS_ISA, Bilens_arcs>(int);
template Lanes_function compiled_lanes<BOUNDING_ARCS_ISA, Bilens_arcs>(int);

}  // namespace CGAL::Bounding_arcs::filter

namespace CGAL::Bounding_arcs::internal {

template <class Isa> void compiled_biarcs(Arc_columns& columns) { fit_biarcs<Isa>(columns); }
template <class Isa> void compiled_balanced(Arc_columns& columns) { fit_balanced<Isa>(columns); }

template void compiled_biarcs<BOUNDING_ARCS_ISA>(Arc_columns&);
template void compiled_balanced<BOUNDING_ARCS_ISA>(Arc_columns&);

}  // namespace CGAL::Bounding_arcs::internal
