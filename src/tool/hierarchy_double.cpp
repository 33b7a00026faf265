// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hierarchy_implementation.h"

#include <CGAL/Simple_cartesian.h>

namespace bounding_arcs_tool::detail {

std::unique_ptr<Segmented_curve> segment_double(const Curve_record& record) {
  using K = Circular<CGAL::Simple_cartesian<double>>;
  return std::make_unique<
      Segmented_curve_of<double, ba::Bca_traits_2<K>, ba::Spiral_fat_arc_traits_2<K>, ba::Bilens_traits_2<K>>>(record);
}

}  // namespace bounding_arcs_tool::detail
