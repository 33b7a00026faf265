// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Fallback policies: the switches to a simpler region of the paper's section 4.3, as wrappers of a construction.
// The plain constructions do not need them; with a policy the choice is made for each region.

#include <CGAL/Bounding_arcs_2.h>

#include <CGAL/Simple_cartesian.h>

#include <cstdio>

using namespace CGAL::Bounding_arcs;
using Kernel = CGAL::Circular_kernel_2<CGAL::Simple_cartesian<double>, CGAL::Algebraic_kernel_for_circles_2_2<double>>;

template <class Traits> void report(const char* name, const Traits& traits) {
  const Bezier_curve_2<double> curve({{0, 0.6}, {6.4, 3}, {-2.4, 3.4}, {3, 0}});
  const Region_hierarchy_2<Traits> regions(Bounding_arc_tree_2(curve), 1e-4, {}, traits);
  int bca = 0, bilens = 0, chord = 0;
  regions.for_each_leaf([&](const Node_handle& h) {
    const Region_node node = regions.node(h);
    const Region_form form = regions.traits().construct_region_boundary_2_object()(regions.region(node)).form;
    bca += form == Region_form::BCA;
    bilens += form == Region_form::BILENS;
    chord += form == Region_form::CHORD_AND_CIRCLE;
  });
  std::printf("%-33s %3zu leaves: %3d bca, %3d bilens, %3d chord and circle\n", name, regions.number_of_leaves(), bca,
              bilens, chord);
}

int main() {
  report("bilens", Bilens_traits_2<Kernel>());
  using Near_circular = Near_circular_to_bca<Bilens>;
  report("bilens, near-circular to bca", Bilens_traits_2<Kernel, Near_circular>(Near_circular{{}, 0.05}));
  report("bca", Bca_traits_2<Kernel>());
  report("bca, near-linear to chord", Bca_traits_2<Kernel, Near_linear_to_chord>(Near_linear_to_chord{{}, 0.02}));
}
