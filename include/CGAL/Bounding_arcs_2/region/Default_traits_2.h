// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The traits of a tree that names none: bounding circular arcs over doubles, with exact predicates.

#ifndef CGAL_BOUNDING_ARCS_2_REGION_DEFAULT_TRAITS_2_H
#define CGAL_BOUNDING_ARCS_2_REGION_DEFAULT_TRAITS_2_H

// Before Circular_kernel_2: it makes the kernel compile over fundamental number types.
#include <CGAL/Root_of_traits.h>

#include <CGAL/Algebraic_kernel_for_circles_2_2.h>
#include <CGAL/Circular_kernel_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Bounding_arcs_2/region/Bca_traits_2.h>

namespace CGAL::Bounding_arcs {

/// The traits of a tree that names none: bounding circular arcs over doubles, with exact predicates.
/// \code
/// const Region_hierarchy_2<Default_traits_2> tree(drawing);  // or Bounding_arc_tree_2 tree(drawing)
/// const Default_traits_2::Kernel::Point_2 nearest = closest_point(tree, {1, 1})->point;
/// \endcode
/// \cgalModels{BoundingRegionTraits_2}
class Default_traits_2
    : public Bca_traits_2<CGAL::Circular_kernel_2<CGAL::Exact_predicates_inexact_constructions_kernel,
                                                  CGAL::Algebraic_kernel_for_circles_2_2<double>>> {};

}  // namespace CGAL::Bounding_arcs

#endif
