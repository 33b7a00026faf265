// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The filter's code for one or two pieces, once for all programs and instruction sets.

#include <CGAL/Bounding_arcs_2/tree/internal/batch/Batch_function.h>
#include <CGAL/Bounding_arcs_2/tree/internal/batch/Bca_batch.h>
#include <CGAL/Bounding_arcs_2/tree/internal/batch/Bilens_batch.h>
#include <CGAL/Bounding_arcs_2/tree/internal/batch/Spiral_fat_arc_batch.h>

namespace CGAL::Bounding_arcs::filter {

template <class Method> Bound_function compiled_one(int kind) { return one_of_kind<Method>(kind); }
template <class Arcs> Arc_function compiled_few(int kind) { return few_of_kind<Arcs>(kind); }

template Bound_function compiled_one<Bca_batch>(int);
template Bound_function compiled_one<Spiral_fat_arc_batch>(int);
template Bound_function compiled_one<Bilens_batch>(int);
template Arc_function compiled_few<Bca_arcs>(int);
template Arc_function compiled_few<Spiral_fat_arc_arcs>(int);
template Arc_function compiled_few<Bilens_arcs>(int);

}  // namespace CGAL::Bounding_arcs::filter
