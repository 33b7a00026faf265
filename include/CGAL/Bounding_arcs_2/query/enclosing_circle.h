// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The smallest circle about a drawing.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_ENCLOSING_CIRCLE_H
#define CGAL_BOUNDING_ARCS_2_QUERY_ENCLOSING_CIRCLE_H

#include <CGAL/Bounding_arcs_2/internal/query/Circle_search.h>
#include <CGAL/Bounding_arcs_2/query/measures.h>

#include <algorithm>
#include <optional>

namespace CGAL::Bounding_arcs {

/// A circle about a drawing.
struct Enclosing_circle {
  Xy<double> centre;
  Measure_bounds radius;  ///< of the smallest circle; about this centre all curves are within the upper bound
};

/// The smallest circle that all curves are inside of.
/// \param tolerance how far the bounds may be apart, no less than some ulp
/// \return nothing for an empty drawing
/// \guarantee certified
/// \complexity n log n, and pieces that come near the circle, as the root of 1 / tolerance where they run along it
[[nodiscard]] inline std::optional<Enclosing_circle> smallest_enclosing_circle(const Curve_index_2& index,
                                                                               double tolerance) {
  check_tolerance(tolerance);
  if (index.empty()) return std::nullopt;
  const CGAL::Bbox_2& box = index.boxes().box();
  constexpr double ROUGH = 0x1p-7;  // of the extent: what is well inside is looked at no more
  const double rough = ROUGH * (std::max)(box.xmax() - box.xmin(), box.ymax() - box.ymin());
  const internal::Circle_search search(index, internal::Hull_samples(index, rough), tolerance / 2);
  return Enclosing_circle{search.centre(), {search.lower(), search.upper()}};
}

}  // namespace CGAL::Bounding_arcs

#endif
