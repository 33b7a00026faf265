// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Arcs as the curves of CGAL's other traits for them, Arr_circular_line_arc_traits_2, which are Circular_arc_2 and
// Line_arc_2 of a circular kernel.  Their circles are those of circle_segment_curve.h; that Circular_arc_2 always runs
// counterclockwise, that its constructors look at nothing, and that that from a bulge divides by it, is seen to here.

#ifndef CGAL_BOUNDING_ARCS_2_EXCHANGE_CIRCULAR_LINE_CURVE_H
#define CGAL_BOUNDING_ARCS_2_EXCHANGE_CIRCULAR_LINE_CURVE_H

// Before Circular_kernel_2: it makes the kernel compile over fundamental number types.
#include <CGAL/Root_of_traits.h>

#include <CGAL/Exact_circular_kernel_2.h>

#include <CGAL/Arr_circular_line_arc_traits_2.h>

#include <CGAL/Bounding_arcs_2/exchange/circle_segment_curve.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/region/Kernel_boundary.h>

#include <stdexcept>
#include <type_traits>
#include <variant>

namespace CGAL::Bounding_arcs {

/// A piece of a region's boundary in the kernel's types as a curve. The direction of the piece is not kept: segments
/// run as they do, arcs counterclockwise.
/// \tparam CircularKernel over exact numbers
/// \throws std::invalid_argument if it is a tangent segment between algebraic points, on a line that is not rational
/// \guarantee exact
template <class CircularKernel>
[[nodiscard]] typename Arr_circular_line_arc_traits_2<CircularKernel>::Curve_2 circular_line_curve(
    const Kernel_piece_2<CircularKernel>& piece) {
  static_assert(!std::is_floating_point_v<typename CircularKernel::FT>, "circles in floating numbers miss the ends");
  if (const auto* arc = std::get_if<typename CircularKernel::Circular_arc_2>(&piece.curve)) return *arc;
  if (const auto* segment = std::get_if<typename CircularKernel::Line_arc_2>(&piece.curve)) return *segment;
  throw std::invalid_argument(expected("piece", "a segment on a rational line", "a tangent between algebraic points"));
}
/// Converts a boundary piece over the kernel's numbers; a bulge of 0 is a segment.
/// \throws std::invalid_argument if the ends are equal
template <class CircularKernel = CGAL::Exact_circular_kernel_2>
[[nodiscard]] typename Arr_circular_line_arc_traits_2<CircularKernel>::Curve_2 circular_line_curve(
    const Boundary_piece_2<typename CircularKernel::FT>& p) {
  internal::require_two_ends(p);
  return circular_line_curve(kernel_piece<CircularKernel>(p));
}
/// Converts an arc that ends and a bulge tell. \throws std::invalid_argument also if a number is none
template <class CircularKernel = CGAL::Exact_circular_kernel_2>
[[nodiscard]] typename Arr_circular_line_arc_traits_2<CircularKernel>::Curve_2 circular_line_curve(const Arc_2& arc) {
  return circular_line_curve<CircularKernel>(exact_piece<typename CircularKernel::FT>(arc));
}

}  // namespace CGAL::Bounding_arcs

#endif
