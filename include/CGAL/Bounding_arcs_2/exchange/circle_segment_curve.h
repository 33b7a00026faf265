// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Arcs as the curves of CGAL's arrangements and of Boolean set operations, Arr_circle_segment_traits_2.  Ends and
// bulges in doubles are rational numbers, and so are the center and the squared radius of the circle that they define:
// nothing is rounded.

#ifndef CGAL_BOUNDING_ARCS_2_EXCHANGE_CIRCLE_SEGMENT_CURVE_H
#define CGAL_BOUNDING_ARCS_2_EXCHANGE_CIRCLE_SEGMENT_CURVE_H

#include <CGAL/Bounding_arcs_2/exchange/internal/exact_piece.h>
#include <CGAL/Bounding_arcs_2/exchange/internal/write_x_monotone.h>
#include <CGAL/Bounding_arcs_2/region/Kernel_boundary.h>

#include <CGAL/Arr_circle_segment_traits_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

namespace CGAL::Bounding_arcs {

// GCC takes a circle that CGAL's filter leaves unset for one that is used.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

/// A boundary piece as a curve, which runs from `from` to `to` in its direction; a bulge of 0 is a segment.
/// \tparam Kernel over rational numbers
/// \throws std::invalid_argument if the ends are equal
/// \guarantee exact
template <class Kernel = CGAL::Exact_predicates_exact_constructions_kernel>
[[nodiscard]] typename Arr_circle_segment_traits_2<Kernel>::Curve_2 circle_segment_curve(
    const Boundary_piece_2<typename Kernel::FT>& p) {
  using Traits = Arr_circle_segment_traits_2<Kernel>;
  using Curve = typename Traits::Curve_2;
  require_two_ends(p);
  if (p.is_segment()) return Curve(kernel_point<Kernel>(p.from), kernel_point<Kernel>(p.to));
  const auto circle = kernel_circle<Kernel>(p.support, p.is_ccw() ? CGAL::COUNTERCLOCKWISE : CGAL::CLOCKWISE);
  return Curve(circle, typename Traits::Point_2(p.from.x, p.from.y), typename Traits::Point_2(p.to.x, p.to.y));
}
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

/// Converts an arc that ends and a bulge tell. \throws std::invalid_argument also if a number is none
template <class Kernel = CGAL::Exact_predicates_exact_constructions_kernel>
[[nodiscard]] typename Arr_circle_segment_traits_2<Kernel>::Curve_2 circle_segment_curve(const Arc_2& arc) {
  return circle_segment_curve<Kernel>(exact_piece<typename Kernel::FT>(arc));
}

/// Writes the x-monotone parts of a curve, in its order and direction: one, two or three. They are the same with CGAL 5
/// and 6.
template <class Kernel = CGAL::Exact_predicates_exact_constructions_kernel, class OutputIterator>
OutputIterator x_monotone_parts(const typename Arr_circle_segment_traits_2<Kernel>::Curve_2& curve,
                                OutputIterator out) {
  return internal::write_x_monotone<Arr_circle_segment_traits_2<Kernel>>(curve, out);
}

}  // namespace CGAL::Bounding_arcs

#endif
