// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lines and rays as far as a drawing reaches; compiled in the library with what query/shapes.h has.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_INTERNAL_LINES_H
#define CGAL_BOUNDING_ARCS_2_QUERY_INTERNAL_LINES_H

#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>
#include <CGAL/Bounding_arcs_2/number/Exact_number.h>
#include <CGAL/Bounding_arcs_2/tree/Drawing_hierarchy.h>

namespace CGAL::Bounding_arcs::internal {

[[nodiscard]] Drawing_2<Exact_rational> ray_drawing(const Drawing_hierarchy& curves, const Xy<double>& from,
                                                    const Xy<double>& direction);
[[nodiscard]] Drawing_2<Exact_rational> line_drawing(const Drawing_hierarchy& curves, const Xy<double>& through,
                                                     const Xy<double>& direction);

}  // namespace CGAL::Bounding_arcs::internal

#endif
