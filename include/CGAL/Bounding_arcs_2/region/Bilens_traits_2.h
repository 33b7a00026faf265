// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bilens as CGAL traits, for kernels over a number type with square roots.

#ifndef CGAL_BOUNDING_ARCS_2_REGION_BILENS_TRAITS_2_H
#define CGAL_BOUNDING_ARCS_2_REGION_BILENS_TRAITS_2_H

#include <CGAL/Bounding_arcs_2/region/Bilens.h>
#include <CGAL/Bounding_arcs_2/region/Bounding_region_traits_2.h>

namespace CGAL::Bounding_arcs {

/// Bilens: regions between two biarcs. The traits are for kernels over a number type with square roots.
/// \tparam Construction Bilens, or Near_circular_to_bca<Bilens>
/// \code
/// using Linear = CGAL::Simple_cartesian<double>;
/// using Kernel = CGAL::Circular_kernel_2<Linear, CGAL::Algebraic_kernel_for_circles_2_2<double>>;
/// const Region_hierarchy_2<Bilens_traits_2<Kernel>> regions(tree, 1e-6);
/// std::cout << regions.number_of_leaves() << " regions\n";
/// \endcode
/// \cgalModels{BoundingRegionTraits_2}
template <class CircularKernel, class Construction = Bilens>
class Bilens_traits_2 : public Bounding_region_traits_2<CircularKernel, Construction> {
  static_assert(has_square_root_v<typename CircularKernel::FT>,
                "Bilens_traits_2: the contact circles of a bilens are not rational. Use a Circular_kernel_2 over a "
                "number type with square roots: Simple_cartesian<double>, Simple_cartesian<CORE::Expr> or "
                "Exact_predicates_exact_constructions_kernel_with_sqrt.");

 public:
  using Bounding_region_traits_2<CircularKernel, Construction>::Bounding_region_traits_2;
};

namespace internal {
/// Compiled in the library.
extern template Thickness_bound bound_exactly(const Bilens&, const Chord_shape_2<Exact_rational>&, double);
}  // namespace internal

}  // namespace CGAL::Bounding_arcs

#endif
