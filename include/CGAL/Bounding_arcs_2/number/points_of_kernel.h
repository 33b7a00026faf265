// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Ranges of points of any kernel as vectors of a number type.

#ifndef CGAL_BOUNDING_ARCS_2_NUMBER_POINTS_OF_KERNEL_H
#define CGAL_BOUNDING_ARCS_2_NUMBER_POINTS_OF_KERNEL_H

#include <CGAL/Bounding_arcs_2/number/Xy.h>
#include <CGAL/Bounding_arcs_2/number/convert.h>

#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

namespace internal {
/// What is in a range.
template <class Range> using Element_of = std::decay_t<decltype(*std::begin(std::declval<const Range&>()))>;
/// The representation of what is in a range: there is one of points of a kernel only.
template <class Range> using Kernel_of_range = typename Element_of<Range>::R;

/// Returns a point of a kernel, or what has x() and y(), over another number type: exactly where that holds it, else as
/// CGAL::to_double rounds it.
template <class NT, class Point> [[nodiscard]] Xy<NT> point_of_kernel(const Point& p) {
  return {convert<NT>(p.x()), convert<NT>(p.y())};
}
/// Returns all points of a range in this way.
template <class NT, class Points> [[nodiscard]] std::vector<Xy<NT>> points_of_kernel(const Points& points) {
  std::vector<Xy<NT>> result;
  for (const auto& p : points) result.push_back(point_of_kernel<NT>(p));
  return result;
}
}  // namespace internal

}  // namespace CGAL::Bounding_arcs

#endif
