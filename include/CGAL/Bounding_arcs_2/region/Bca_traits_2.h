// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bounding circular arcs as CGAL traits; every kernel carries them.

#ifndef CGAL_BOUNDING_ARCS_2_REGION_BCA_TRAITS_2_H
#define CGAL_BOUNDING_ARCS_2_REGION_BCA_TRAITS_2_H

// Before Circular_kernel_2: it makes the kernel compile over fundamental number types.
#include <CGAL/Root_of_traits.h>

#include <CGAL/Algebraic_kernel_for_circles_2_2.h>
#include <CGAL/Circular_kernel_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Bounding_arcs_2/region/Bca.h>
#include <CGAL/Bounding_arcs_2/region/Bounding_region_traits_2.h>

namespace CGAL::Bounding_arcs {

/// Bounding circular arcs: regions between two arcs over the chord. The traits are for every kernel.
/// \tparam Construction Bca, or Near_linear_to_chord
/// \code
/// using Linear = CGAL::Simple_cartesian<double>;
/// using Kernel = CGAL::Circular_kernel_2<Linear, CGAL::Algebraic_kernel_for_circles_2_2<double>>;
/// const Region_hierarchy_2<Bca_traits_2<Kernel>> regions(tree, 1e-6);
/// regions.for_each_leaf([&](const Node_handle& leaf) {
///   const auto boundary = Bca_traits_2<Kernel>().construct_region_boundary_2_object()(regions.region(leaf));
/// });
/// \endcode
/// \cgalModels{BoundingRegionTraits_2}
template <class CircularKernel, class Construction = Bca>
class Bca_traits_2 : public Bounding_region_traits_2<CircularKernel, Construction> {
 public:
  using Bounding_region_traits_2<CircularKernel, Construction>::Bounding_region_traits_2;
};

namespace internal {
/// Compiled in the library.
extern template Thickness_bound bound_exactly(const Bca&, const Chord_shape_2<Exact_rational>&, double);
}  // namespace internal

/// The traits of regions that name none: bounding circular arcs over doubles, with exact predicates.
/// \code
/// const Region_hierarchy_2<Default_traits_2> regions(tree, 1e-6);  // or Region_hierarchy_2 regions(tree, 1e-6)
/// const auto nearest = closest_point(regions, Default_traits_2::Kernel::Point_2(1, 1), 1e-6);
/// \endcode
/// \cgalModels{BoundingRegionTraits_2}
class Default_traits_2
    : public Bca_traits_2<CGAL::Circular_kernel_2<CGAL::Exact_predicates_inexact_constructions_kernel,
                                                  CGAL::Algebraic_kernel_for_circles_2_2<double>>> {};

}  // namespace CGAL::Bounding_arcs

#endif
