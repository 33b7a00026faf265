// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A library function over Bounding Arcs, with its compiled kernels.

#include "regions.h"

// Before Circular_kernel_2: it makes the kernel compile over fundamental number types.
#include <CGAL/Root_of_traits.h>

#include <CGAL/Algebraic_kernel_for_circles_2_2.h>
#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/region/Bca_traits_2.h>
#include <CGAL/Bounding_arcs_2/spiral/Bezier_spiral_2.h>
#include <CGAL/Bounding_arcs_2/tree/Region_hierarchy_2.h>
#include <CGAL/Circular_kernel_2.h>
#include <CGAL/Simple_cartesian.h>

using namespace CGAL::Bounding_arcs;
using Linear_kernel = CGAL::Simple_cartesian<double>;
using Kernel = CGAL::Circular_kernel_2<Linear_kernel, CGAL::Algebraic_kernel_for_circles_2_2<double>>;

std::size_t number_of_regions(double eps) {
  const Bezier_curve_2<double> curve({{0, 0.6}, {6.4, 3}, {-2.4, 3.4}, {3, 0}});
  const Region_hierarchy_2<Bca_traits_2<Kernel>, Bezier_spiral_2<double>> tree(spiral_segments(curve), eps);
  return tree.status() == Build_status::COMPLETE ? tree.number_of_leaves() : 0;
}
