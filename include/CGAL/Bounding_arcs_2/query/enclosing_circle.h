// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The smallest circle about a drawing.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_ENCLOSING_CIRCLE_H
#define CGAL_BOUNDING_ARCS_2_QUERY_ENCLOSING_CIRCLE_H

#include <CGAL/Bounding_arcs_2/query/measures.h>

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
[[nodiscard]] std::optional<Enclosing_circle> smallest_enclosing_circle(const Curve_index_2& index, double tolerance);

}  // namespace CGAL::Bounding_arcs

#ifndef BOUNDING_ARCS_KERNELS
#include <CGAL/Bounding_arcs_2/internal/query/enclosing_circle_impl.h>
#endif

#endif
