// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Must not compile. The compiler's message names the way out of each; compile_fail.sh looks for that.

#include <CGAL/Algebraic_kernel_for_circles_2_2.h>
#include <CGAL/Bounding_arcs_2/region/Bilens_traits_2.h>
#include <CGAL/Bounding_arcs_2/spiral/Jet_spiral_2.h>
#include <CGAL/Bounding_arcs_2/tree/Region_hierarchy_2.h>
#include <CGAL/Circular_kernel_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <vector>

namespace ba = CGAL::Bounding_arcs;

// A number type without square roots.
using Number_type = CGAL::Exact_rational;
using Kernel =
    CGAL::Circular_kernel_2<CGAL::Simple_cartesian<Number_type>, CGAL::Algebraic_kernel_for_circles_2_2<Number_type>>;
const ba::Bilens_traits_2<Kernel> lenses;

const ba::Bounding_arc_tree_2 of_many(std::vector<ba::Bezier_curve_2<double>>{});

struct Own_curve {};
const ba::Bounding_arc_tree_2 of_own(std::vector<ba::Jet_spiral_2<Own_curve>>{});

using Regions = ba::Region_hierarchy_2<CGAL::Exact_predicates_inexact_constructions_kernel>;
const auto count = &Regions::number_of_nodes;
