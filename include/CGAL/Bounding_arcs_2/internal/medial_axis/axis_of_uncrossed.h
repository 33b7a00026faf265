// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The axis of curves that are known not to cross.

#ifndef CGAL_BOUNDING_ARCS_2_INTERNAL_MEDIAL_AXIS_AXIS_OF_UNCROSSED_H
#define CGAL_BOUNDING_ARCS_2_INTERNAL_MEDIAL_AXIS_AXIS_OF_UNCROSSED_H

#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>
#include <CGAL/Bounding_arcs_2/query/Curve_index_2.h>

namespace CGAL::Bounding_arcs::internal {

// Of curves that do not cross; they may touch where convex corners of regions meet.
// \tparam Index Curve_index_2; a parameter, so that the library may have it compiled
template <class Index>
[[nodiscard]] Medial_axis_2 axis_of_uncrossed(const Index& index, const Medial_axis_options& options);

}  // namespace CGAL::Bounding_arcs::internal

#ifdef BOUNDING_ARCS_KERNELS
namespace CGAL::Bounding_arcs::internal {
extern template Medial_axis_2 axis_of_uncrossed(const Curve_index_2&, const Medial_axis_options&);
}  // namespace CGAL::Bounding_arcs::internal
#else
#include <CGAL/Bounding_arcs_2/internal/medial_axis/axis_of_uncrossed_impl.h>
#endif

#endif
