// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The batch loops for one instruction set: compiled once for each, with BOUNDING_ARCS_ISA naming its tag.  What is
// inlined into them is always_inline, so that no other code picks up instructions of a wider set.

#include "Instruction_sets.h"
#include "batch/Bca_batch.h"
#include "batch/Bilens_batch.h"
#include "batch/Spiral_fat_arc_batch.h"
#include "batch/arc_batch.h"
#include "batch/bound_batch.h"

#include "../spiral/Local_curve.h"
#include "batch/Batch_questions.h"

namespace CGAL::Bounding_arcs::filter {

// The loops for a kind of curves, null for kind 0.
template <class Isa, class Method> Batch_function batch_function(int kind) {
  return for_kind(kind, [](auto k) -> Batch_function { return &bound_batch<Isa, Method, k()>; });
}
template <class Isa, class Method> Top_function top_function(int kind) {
  return for_kind(kind, [](auto k) -> Top_function { return &decide_top<Isa, Method, k()>; });
}
template <class Isa, class Arcs> Arc_function arc_function(int kind) {
  return for_kind(kind, [](auto k) -> Arc_function { return &arc_batch<Isa, Arcs, k()>; });
}
template <class Isa, class Arcs> Lanes_function lanes_function(int kind) {
  return for_kind(kind, [](auto k) -> Lanes_function { return &make_few_arcs<Isa, Arcs, k()>; });
}

#define BOUNDING_ARCS_LOOPS(Isa)                                          \
  template Batch_function batch_function<Isa, Bca_batch>(int);            \
  template Top_function top_function<Isa, Bca_batch>(int);                \
  template Batch_function batch_function<Isa, Spiral_fat_arc_batch>(int); \
  template Top_function top_function<Isa, Spiral_fat_arc_batch>(int);     \
  template Batch_function batch_function<Isa, Bilens_batch>(int);         \
  template Top_function top_function<Isa, Bilens_batch>(int);             \
  template Arc_function arc_function<Isa, Bca_arcs>(int);                 \
  template Lanes_function lanes_function<Isa, Bca_arcs>(int);             \
  template Arc_function arc_function<Isa, Spiral_fat_arc_arcs>(int);      \
  template Lanes_function lanes_function<Isa, Spiral_fat_arc_arcs>(int);  \
  template Arc_function arc_function<Isa, Bilens_arcs>(int);              \
  template Lanes_function lanes_function<Isa, Bilens_arcs>(int)
BOUNDING_ARCS_FOR_SETS(BOUNDING_ARCS_LOOPS)

}  // namespace CGAL::Bounding_arcs::filter
