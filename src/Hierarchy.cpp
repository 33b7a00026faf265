// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Hierarchy.h"

#include <algorithm>
#include <cmath>

namespace bounding_arcs_tool {

std::unique_ptr<Segmented_curve> segment(const Curve_record& record, Kernel kernel) {
  switch (kernel) {
    case Kernel::DOUBLE: return detail::segment_double(record);
    case Kernel::FILTERED: return detail::segment_filtered(record);
    case Kernel::EXACT: break;
  }
  return detail::segment_exact(record);
}

Output_piece as_written(const Output_piece& arc) {
  constexpr double ROUNDING = 0x1p-51;  // of a radius, in what is computed here
  const auto distance = [](const Xy<double>& p, const Xy<double>& q) { return std::hypot(p.x - q.x, p.y - q.y); };
  const double r = arc.radius, half = distance(arc.from, arc.to) / 2;
  const double missed = std::max(std::fabs(distance(arc.from, arc.center) - r), std::fabs(distance(arc.to, arc.center) - r));
  const double height = half * half / (r + std::sqrt(std::max(0.0, (r - half) * (r + half))));
  if (missed + ROUNDING * r < height) return arc;
  return {arc.from, arc.to, {}, 0, true};
}

const char* name_of(Method method) {
  return method == Method::BCA ? "bca" : (method == Method::SFA ? "sfa" : "bilens");
}

const char* name_of(Kernel kernel) {
  return kernel == Kernel::DOUBLE ? "double" : (kernel == Kernel::FILTERED ? "filtered" : "exact");
}

}  // namespace bounding_arcs_tool
