// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Kernels, traits and spirals that tests build trees of.

#ifndef BOUNDING_ARCS_TEST_TREES_H
#define BOUNDING_ARCS_TEST_TREES_H

#include "random_spirals.h"

#include <CGAL/Bounding_arcs_2.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace bounding_arcs_test {

namespace ba = CGAL::Bounding_arcs;

template <class LinearKernel>
using Circular =
    CGAL::Circular_kernel_2<LinearKernel, CGAL::Algebraic_kernel_for_circles_2_2<typename LinearKernel::FT>>;
using Kernel = Circular<CGAL::Simple_cartesian<double>>;
using Filtered = Circular<CGAL::Exact_predicates_inexact_constructions_kernel>;
using Bca_tree = ba::Region_hierarchy_2<ba::Bca_traits_2<Kernel>, Spiral>;
#ifdef BOUNDING_ARCS_FEW_CASES  // each method and each kernel
using All_traits =
    testing::Types<ba::Bca_traits_2<Kernel>, ba::Spiral_fat_arc_traits_2<Filtered>, ba::Bilens_traits_2<Kernel>>;
#else
using All_traits =
    testing::Types<ba::Bca_traits_2<Kernel>, ba::Spiral_fat_arc_traits_2<Kernel>, ba::Bilens_traits_2<Kernel>,
                   ba::Bca_traits_2<Filtered>, ba::Spiral_fat_arc_traits_2<Filtered>, ba::Bilens_traits_2<Filtered>>;
#endif

/// A piece whose thickness can be bounded on its own.
using Spiral_source = ba::Piece_source<Spiral>;

inline ba::Build_options nodes_of_kind(ba::Build_options::Nodes kind) {
  ba::Build_options options;
  options.nodes = kind;
  return options;
}

/// All spiral segments of some random curves.
inline std::vector<Spiral> random_spirals(unsigned seed, int curves) {
  std::mt19937 random(seed);
  std::vector<Spiral> spirals;
  for (int i = 0; i < curves; ++i)
    for (const Spiral& s : ba::spiral_segments(random_curve(random))) spirals.push_back(s);
  return spirals;
}

}  // namespace bounding_arcs_test

#endif
