// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Trees of each kind of numbers and decisions.

#ifndef BOUNDING_ARCS_TEST_KERNEL_TREES_H
#define BOUNDING_ARCS_TEST_KERNEL_TREES_H

#include <CGAL/Bounding_arcs_2.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

namespace bounding_arcs_test {

/// A tree of curves over the numbers of a kernel, with decisions of a kind.
template <class K, CGAL::Bounding_arcs::Decisions DECISIONS>
class Tree_over : public CGAL::Bounding_arcs::Bounding_arc_tree_2 {
 public:
  using Kernel = K;
  using FT = typename K::FT;
  using Point_2 = typename K::Point_2;

  template <class Curves> explicit Tree_over(const Curves& curves) : Bounding_arc_tree_2(curves, DECISIONS) {}
  explicit Tree_over(const CGAL::Bounding_arcs::Drawing_2<double>& drawing)
      : Bounding_arc_tree_2(drawing.over<FT>(), DECISIONS) {}
};
using Double_tree = Tree_over<CGAL::Simple_cartesian<double>, CGAL::Bounding_arcs::Decisions::DOUBLE>;
using Filtered_tree =
    Tree_over<CGAL::Exact_predicates_inexact_constructions_kernel, CGAL::Bounding_arcs::Decisions::EXACT>;
using Exact_tree = Tree_over<CGAL::Simple_cartesian<CGAL::Exact_rational>, CGAL::Bounding_arcs::Decisions::EXACT>;

}  // namespace bounding_arcs_test

#endif
