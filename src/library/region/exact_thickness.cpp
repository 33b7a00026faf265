// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Thickness against eps over rationals, the last resort of kernels over double, once for all programs.

#include <CGAL/Root_of_traits.h>

#include <CGAL/Algebraic_kernel_for_circles_2_2.h>
#include <CGAL/Circular_kernel_2.h>

#include <CGAL/Bounding_arcs_2/region/Bca_traits_2.h>
#include <CGAL/Bounding_arcs_2/region/Bilens_traits_2.h>
#include <CGAL/Bounding_arcs_2/region/Spiral_fat_arc_traits_2.h>

namespace CGAL::Bounding_arcs {

template Thickness_bound internal::bound_exactly(const Bca&, const Chord_shape_2<Exact_rational>&, double);
template Thickness_bound internal::bound_exactly(const Spiral_fat_arc&, const Chord_shape_2<Exact_rational>&, double);
template Thickness_bound internal::bound_exactly(const internal::With_algebraic_boundary<Spiral_fat_arc>&,
                                                 const Chord_shape_2<Exact_rational>&, double);
template Thickness_bound internal::bound_exactly(const Bilens&, const Chord_shape_2<Exact_rational>&, double);

}  // namespace CGAL::Bounding_arcs
