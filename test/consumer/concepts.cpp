// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The concepts of the manual ask for all that the library uses of their models: it compiles over what they declare.
// Nothing is linked, as nothing is defined.

#include <CGAL/Bounding_arcs_2.h>

#include <CGAL/Simple_cartesian.h>

#include "../../doc/concepts/BoundableCurve_2.h"
#include "../../doc/concepts/BoundingRegionTraits_2.h"
#include "../../doc/concepts/ChordShapeSource.h"
#include "../../doc/concepts/Construction.h"
#include "../../doc/concepts/SpiralSegment_2.h"

#include <vector>

using namespace CGAL::Bounding_arcs;
using Linear_kernel = CGAL::Simple_cartesian<double>;
using Kernel = CGAL::Circular_kernel_2<Linear_kernel, CGAL::Algebraic_kernel_for_circles_2_2<double>>;
using Rational_linear_kernel = CGAL::Simple_cartesian<CGAL::Exact_rational>;
using Rational_kernel =
    CGAL::Circular_kernel_2<Rational_linear_kernel, CGAL::Algebraic_kernel_for_circles_2_2<CGAL::Exact_rational>>;

template <class Tree, class Spiral> void use_tree(const std::vector<Spiral>& spirals) {
  Tree tree(spirals, 1e-3, {}, typename Tree::Traits());
  tree.replace(0, 1, spirals);
  tree.for_each_leaf([&](const Node_handle& h) {
    (void)tree.box(h);
    (void)tree.thickness(h);
    (void)tree.region(h);
  });
  (void)tree.bound();
  (void)tree.number_of_arcs();
}

template <class AnyKernel> void use_construction(const Chord_frame_2<typename AnyKernel::FT>& frame) {
  const Bounding_region_traits_2<AnyKernel, Construction> traits;
  const auto region = traits.construct_bounding_region_2_object()(frame);
  (void)traits.compare_thickness_2_object()(region, 1e-3);
  (void)traits.bound_thickness_2_object()(ChordShapeSource(), 1e-3);
  (void)traits.construct_region_boundary_2_object()(region);
  (void)traits.construct_boundary_2_object()(region);
  (void)traits.construct_bbox_2_object()(region);
}

void use_concepts() {
  use_tree<Region_hierarchy_2<BoundingRegionTraits_2, SpiralSegment_2>>(std::vector<SpiralSegment_2>());
  use_tree<Region_hierarchy_2<BoundingRegionTraits_2, Jet_spiral_2<BoundableCurve_2>>>(
      std::vector<Jet_spiral_2<BoundableCurve_2>>());
  use_tree<Region_hierarchy_2<BoundingRegionTraits_2, Bezier_spiral_2<double>>>(std::vector<Bezier_spiral_2<double>>());
  use_tree<Region_hierarchy_2<Bounding_region_traits_2<Kernel, Construction>, SpiralSegment_2>>(
      std::vector<SpiralSegment_2>());
  use_construction<Kernel>({});
  use_construction<Rational_kernel>({});
}
