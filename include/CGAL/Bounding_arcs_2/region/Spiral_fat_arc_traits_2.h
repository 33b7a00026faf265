// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Spiral fat arcs as CGAL traits; over kernels without square roots the joints are Circular_arc_point_2.

#ifndef CGAL_BOUNDING_ARCS_2_REGION_SPIRAL_FAT_ARC_TRAITS_2_H
#define CGAL_BOUNDING_ARCS_2_REGION_SPIRAL_FAT_ARC_TRAITS_2_H

#include <CGAL/Bounding_arcs_2/number/Root_number.h>
#include <CGAL/Bounding_arcs_2/region/Bounding_region_traits_2.h>
#include <CGAL/Bounding_arcs_2/region/Spiral_fat_arc.h>
#include <CGAL/Bounding_arcs_2/region/internal/algebraic_spiral_fat_arc.h>

namespace CGAL::Bounding_arcs {
/// The construction with its boundary over rational kernels, which needs the circular kernel's intersections.
template <class Construction> struct With_algebraic_boundary : Construction {
  With_algebraic_boundary(const Construction& c = {}) : Construction(c) {}  // NOLINT: the same construction
  template <class CK, class FT>
  [[nodiscard]] Kernel_boundary_2<CK> algebraic_boundary(const Chord_frame_2<FT>& frame) const {
    // the form is the one that the construction takes where there are square roots
    const Chord_frame_2<Root_number> root_frame{{}, {}, convert_shape<Root_number>(frame.shape)};
    if (Construction::boundary(root_frame).form == Region_form::SPIRAL_FAT_ARC)
      return internal::algebraic_spiral_fat_arc<CK>(frame);
    const Region_boundary_2<FT> b = Bca::boundary(frame);
    return {kernel_chain<CK>(b.inner), kernel_chain<CK>(b.outer)};
  }
};

/// Spiral fat arcs: regions between an arc with a segment and another segment with an arc. Over kernels without square
/// roots joints are Circular_arc_point_2.
/// Two arcs and two segments. \tparam Construction Spiral_fat_arc, or Near_circular_to_bca<Spiral_fat_arc>
/// \code
/// using Linear = CGAL::Simple_cartesian<double>;
/// using Kernel = CGAL::Circular_kernel_2<Linear, CGAL::Algebraic_kernel_for_circles_2_2<double>>;
/// const Region_hierarchy_2<Spiral_fat_arc_traits_2<Kernel>> tree(drawing, 1e-6);
/// std::cout << tree.number_of_leaves() << " regions\n";
/// \endcode
/// \cgalModels{BoundingRegionTraits_2}
template <class CircularKernel, class Construction = Spiral_fat_arc>
class Spiral_fat_arc_traits_2 : public Bounding_region_traits_2<CircularKernel, With_algebraic_boundary<Construction>> {
 public:
  using Bounding_region_traits_2<CircularKernel, With_algebraic_boundary<Construction>>::Bounding_region_traits_2;
};

/// Compiled in the library.
extern template Thickness_bound bound_exactly(const Spiral_fat_arc&, const Chord_shape_2<Exact_rational>&, double);
/// Compiled in the library.
extern template Thickness_bound bound_exactly(const With_algebraic_boundary<Spiral_fat_arc>&,
                                              const Chord_shape_2<Exact_rational>&, double);

}  // namespace CGAL::Bounding_arcs

#endif
