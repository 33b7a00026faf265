// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Hierarchy.h"

namespace bounding_arcs_tool {

std::unique_ptr<Segmented_curve> segment(const Curve_record& record, Kernel kernel) {
  switch (kernel) {
    case Kernel::DOUBLE: return detail::segment_double(record);
    case Kernel::FILTERED: return detail::segment_filtered(record);
    case Kernel::EXACT: break;
  }
  return detail::segment_exact(record);
}

const char* name_of(Method method) {
  return method == Method::BCA ? "bca" : (method == Method::SFA ? "sfa" : "bilens");
}

const char* name_of(Kernel kernel) {
  return kernel == Kernel::DOUBLE ? "double" : (kernel == Kernel::FILTERED ? "filtered" : "exact");
}

}  // namespace bounding_arcs_tool
