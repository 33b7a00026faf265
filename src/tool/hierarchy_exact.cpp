// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hierarchy_implementation.h"

#include <CGAL/CORE_Expr.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

namespace bounding_arcs_tool::detail {

std::unique_ptr<Segmented_curve> segment_exact(const Curve_record& record) {
  using Rational = Circular<CGAL::Simple_cartesian<CGAL::Exact_rational>>;
  using Root = Circular<CGAL::Simple_cartesian<CORE::Expr>>;  // joints of spiral fat arcs and bilens hold square roots
  return std::make_unique<Segmented_curve_of<CGAL::Exact_rational, ba::Bca_traits_2<Rational>,
                                             ba::Spiral_fat_arc_traits_2<Root>, ba::Bilens_traits_2<Root>>>(record);
}

}  // namespace bounding_arcs_tool::detail
