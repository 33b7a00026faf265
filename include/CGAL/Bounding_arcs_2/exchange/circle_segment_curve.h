// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Arcs as the curves of CGAL's arrangements and of Boolean set operations, Arr_circle_segment_traits_2.  Ends and
// bulges in doubles are rational numbers, and so are the centre and the squared radius of the circle that they define:
// nothing is rounded.

#ifndef CGAL_BOUNDING_ARCS_2_EXCHANGE_CIRCLE_SEGMENT_CURVE_H
#define CGAL_BOUNDING_ARCS_2_EXCHANGE_CIRCLE_SEGMENT_CURVE_H

#include <CGAL/Bounding_arcs_2/internal/variant.h>
#include <CGAL/Bounding_arcs_2/region/Arc_2.h>
#include <CGAL/Bounding_arcs_2/region/Arc_region_2.h>

#include <CGAL/Arr_circle_segment_traits_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <cmath>
#include <stdexcept>
#include <type_traits>

namespace CGAL::Bounding_arcs {

/// The piece in the numbers of an exact kernel.
template <class FT, class NT> [[nodiscard]] Boundary_piece_2<FT> piece_over(const Boundary_piece_2<NT>& p) {
  static_assert(!std::is_floating_point_v<NT>, "a boundary in floating numbers misses its ends; hand over its arcs");
  const auto point = [](const Xy<NT>& q) { return Xy<FT>{FT(q.x), FT(q.y)}; };
  return {point(p.from), point(p.to), {point(p.support.point), point(p.support.normal), FT(p.support.curvature)}};
}
/// The piece of the arc's circle or line between its ends, over a field; of an arc in doubles exactly.
/// \throws std::invalid_argument if a number is none
template <class FT> [[nodiscard]] Boundary_piece_2<FT> exact_piece(const Arc_2& arc) {
  for (const double x : {arc.from.x, arc.from.y, arc.to.x, arc.to.y, arc.bulge})
    if (!std::isfinite(x)) throw std::invalid_argument("an arc has a coordinate or bulge that is not a number");
  return piece_on_chord(Xy<FT>{FT(arc.from.x), FT(arc.from.y)}, Xy<FT>{FT(arc.to.x), FT(arc.to.y)}, FT(arc.bulge));
}

// GCC takes a circle that CGAL's filter leaves unset for one that is used.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

/// A boundary piece as a curve, which runs from `from` to `to` in its direction; a bulge of 0 is a segment.
/// \tparam Kernel over rational numbers
/// \pre the ends differ
/// \guarantee exact
template <class Kernel = CGAL::Exact_predicates_exact_constructions_kernel>
[[nodiscard]] typename Arr_circle_segment_traits_2<Kernel>::Curve_2 circle_segment_curve(
    const Boundary_piece_2<typename Kernel::FT>& p) {
  using Traits = Arr_circle_segment_traits_2<Kernel>;
  using Curve = typename Traits::Curve_2;
  using Point = typename Kernel::Point_2;
  if (p.is_segment()) return Curve(Point(p.from.x, p.from.y), Point(p.to.x, p.to.y));
  const auto center = p.support.center();
  const typename Kernel::Circle_2 circle(Point(center.x, center.y), p.support.squared_radius(),
                                         p.is_ccw() ? CGAL::COUNTERCLOCKWISE : CGAL::CLOCKWISE);
  return Curve(circle, typename Traits::Point_2(p.from.x, p.from.y), typename Traits::Point_2(p.to.x, p.to.y));
}
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

/// The same of an arc by its ends and bulge. \throws std::invalid_argument if a number is none
template <class Kernel = CGAL::Exact_predicates_exact_constructions_kernel>
[[nodiscard]] typename Arr_circle_segment_traits_2<Kernel>::Curve_2 circle_segment_curve(const Arc_2& arc) {
  return circle_segment_curve<Kernel>(exact_piece<typename Kernel::FT>(arc));
}

/// Writes the x-monotone parts of a curve, in its order and direction: one, two or three. The same with CGAL 5 and 6.
template <class Kernel = CGAL::Exact_predicates_exact_constructions_kernel, class OutputIterator>
OutputIterator x_monotone_parts(const typename Arr_circle_segment_traits_2<Kernel>::Curve_2& curve,
                                OutputIterator out) {
  using Traits = Arr_circle_segment_traits_2<Kernel>;
  using Part = typename Traits::X_monotone_curve_2;
  const auto keep = [&](const auto& object) {
    if (const Part* part = internal::get_if<Part>(object)) *out++ = *part;
  };
  Traits().make_x_monotone_2_object()(curve, boost::make_function_output_iterator(keep));
  return out;
}

}  // namespace CGAL::Bounding_arcs

#endif
