// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Trees over each kind of kernel.

#ifndef BOUNDING_ARCS_TEST_KERNEL_TREES_H
#define BOUNDING_ARCS_TEST_KERNEL_TREES_H

#include <CGAL/Bounding_arcs_2.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

namespace bounding_arcs_test {

template <class K>
using Tree_over = CGAL::Bounding_arcs::Bounding_arc_tree_2<CGAL::Bounding_arcs::Bca_traits_2<
    CGAL::Circular_kernel_2<K, CGAL::Algebraic_kernel_for_circles_2_2<typename K::FT>>>>;
using Double_tree = Tree_over<CGAL::Simple_cartesian<double>>;
using Exact_tree = Tree_over<CGAL::Simple_cartesian<CGAL::Exact_rational>>;
using Filtered_tree = CGAL::Bounding_arcs::Bounding_arc_tree_2<>;

}  // namespace bounding_arcs_test

#endif
