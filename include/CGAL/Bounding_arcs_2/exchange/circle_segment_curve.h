// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Arcs as the curves of CGAL's arrangements and of Boolean set operations, Arr_circle_segment_traits_2.  Ends and
// bulges in doubles are rational numbers, and so are the center and the squared radius of the circle that they define:
// nothing is rounded.

#ifndef CGAL_BOUNDING_ARCS_2_EXCHANGE_CIRCLE_SEGMENT_CURVE_H
#define CGAL_BOUNDING_ARCS_2_EXCHANGE_CIRCLE_SEGMENT_CURVE_H

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/region/Arc_region_2.h>
#include <CGAL/Bounding_arcs_2/region/Kernel_boundary.h>
#include <CGAL/Bounding_arcs_2/region/variant.h>

#include <CGAL/Arr_circle_segment_traits_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <cmath>
#include <stdexcept>

namespace CGAL::Bounding_arcs {

// The circle or line through the ends of an arc, over a field: five doubles are rational numbers, and so are the center
// and the squared radius.  All that goes to CGAL is made of these pieces.

/// The piece of the arc's circle or line between its ends, over a field; of an arc in doubles exactly.
/// \throws std::invalid_argument if a number is none
template <class FT> [[nodiscard]] Boundary_piece_2<FT> exact_piece(const Arc_2& arc) {
  for (const double x : {arc.from.x, arc.from.y, arc.to.x, arc.to.y, arc.bulge})
    if (!std::isfinite(x)) throw std::invalid_argument(expected("arc", "finite coordinates and bulge", x));
  return piece_on_chord(Xy<FT>{FT(arc.from.x), FT(arc.from.y)}, Xy<FT>{FT(arc.to.x), FT(arc.to.y)}, FT(arc.bulge));
}
namespace internal {
/// \throws std::invalid_argument if the piece is a point, which has no circle
template <class FT> void require_two_ends(const Boundary_piece_2<FT>& p) {
  if (p.from == p.to) throw std::invalid_argument(expected("piece", "two different ends", "equal ones"));
}
}  // namespace internal

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
  internal::require_two_ends(p);
  if (p.is_segment()) return Curve(internal::kernel_point<Kernel>(p.from), internal::kernel_point<Kernel>(p.to));
  const auto circle = internal::kernel_circle<Kernel>(p.support, p.is_ccw() ? CGAL::COUNTERCLOCKWISE : CGAL::CLOCKWISE);
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

/// Writes the x-monotone parts of a curve: one, two or three, in the order in which the traits hand them out. They are
/// the same with CGAL 5 and 6.
/// \tparam Traits of arrangements of arcs
template <class Traits = Arr_circle_segment_traits_2<CGAL::Exact_predicates_exact_constructions_kernel>,
          class OutputIterator>
OutputIterator x_monotone_parts(const typename Traits::Curve_2& curve, OutputIterator out) {
  const auto keep = [&](const auto& object) {
    if (const auto part = value_as<typename Traits::X_monotone_curve_2>(object)) *out++ = *part;
  };
  Traits().make_x_monotone_2_object()(curve, boost::make_function_output_iterator(keep));
  return out;
}

}  // namespace CGAL::Bounding_arcs

#endif
