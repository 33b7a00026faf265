// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Closed chains of arcs as polygons of CGAL's Boolean set operations: chains of a fit, offsets, regions. The areas of
// such polygons are no algebraic numbers, and told between doubles.

#ifndef CGAL_BOUNDING_ARCS_2_EXCHANGE_GENERAL_POLYGON_H
#define CGAL_BOUNDING_ARCS_2_EXCHANGE_GENERAL_POLYGON_H

#include <CGAL/Bounding_arcs_2/exchange/circle_segment_curve.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/number/strict_math.h>
#include <CGAL/Bounding_arcs_2/offset/Offset_2.h>
#include <CGAL/Bounding_arcs_2/query/measures.h>

#include <CGAL/Gps_circle_segment_traits_2.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/assertions.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <cstddef>
#include <list>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace CGAL::Bounding_arcs {

/// General_polygon_2 and General_polygon_with_holes_2 of arcs and segments.
template <class Kernel = CGAL::Exact_predicates_exact_constructions_kernel>
using Arc_polygon_2 = typename Gps_circle_segment_traits_2<Kernel>::Polygon_2;
/// A polygon of arcs and segments with holes.
template <class Kernel = CGAL::Exact_predicates_exact_constructions_kernel>
using Arc_polygon_with_holes_2 = typename Gps_circle_segment_traits_2<Kernel>::Polygon_with_holes_2;

/// The polygon that a range of arcs runs round, counterclockwise whichever way they do.
/// \param arcs Arc_2 or what has their members (Arc_chain::Arc), or Boundary_piece_2<Kernel::FT>
/// \pre the arcs do not meet but at their ends
/// \throws std::invalid_argument unless each arc starts where the one before ends
/// \guarantee exact
template <class Kernel = CGAL::Exact_predicates_exact_constructions_kernel, class Arcs>
[[nodiscard]] Arc_polygon_2<Kernel> general_polygon(const Arcs& arcs) {
  using FT = typename Kernel::FT;
  std::vector<Boundary_piece_2<FT>> pieces;
  for (const auto& arc : arcs)
    if constexpr (std::is_same_v<std::decay_t<decltype(arc)>, Boundary_piece_2<FT>>) pieces.push_back(arc);
    else pieces.push_back(exact_piece<FT>({arc.from, arc.to, arc.bulge}));
  Arc_polygon_2<Kernel> polygon;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const auto& p = pieces[i];
    if (!(p.to == pieces[(i + 1) % pieces.size()].from))
      throw std::invalid_argument(
          expected("piece " + text_of(i), "an end where the next piece starts", "another place"));
    if (p.from == p.to) continue;
    const auto insert = [&](const auto& part) { polygon.push_back(part); };
    x_monotone_parts<Arr_circle_segment_traits_2<Kernel>>(circle_segment_curve<Kernel>(p),
                                                          boost::make_function_output_iterator(insert));
  }
  if (!polygon.is_empty() && polygon.orientation() == CGAL::CLOCKWISE) polygon.reverse_orientation();
  return polygon;
}

/// The region between the two sides of an exact boundary, as BCA have over rational numbers.
/// \return nothing where the sides are one: a straight or circular piece has no area
/// \guarantee exact
template <class Kernel = CGAL::Exact_predicates_exact_constructions_kernel, class NT>
[[nodiscard]] std::optional<Arc_polygon_2<Kernel>> general_polygon(const Region_boundary_2<NT>& region) {
  using FT = typename Kernel::FT;
  using Piece = Boundary_piece_2<FT>;
  const auto is_same = [](const Piece& a, const Piece& b) {
    return a.is_segment() ? b.is_segment() : !b.is_segment() && a.support.center() == b.support.center();
  };
  std::vector<Piece> pieces;
  for (const auto& p : region.outer) pieces.push_back(p.template over<FT>());
  std::vector<Piece> back;
  for (const auto& p : region.inner) back.push_back(p.template over<FT>());
  if (pieces.size() == 1 && back.size() == 1 && is_same(pieces[0], back[0])) return std::nullopt;
  for (auto p = back.rbegin(); p != back.rend(); ++p)
    pieces.push_back({p->to, p->from, {p->support.point, -p->support.normal, FT(-p->support.curvature)}});
  return general_polygon<Kernel>(pieces);
}

/// What the closed chains of an offset enclose, each part with its holes. Open chains are left out.
/// \guarantee exact: of the chains as they are, whose distance from the curves `error` bounds
template <class Kernel = CGAL::Exact_predicates_exact_constructions_kernel>
[[nodiscard]] std::vector<Arc_polygon_with_holes_2<Kernel>> offset_polygons(const Offset& offset) {
  std::vector<Arc_polygon_2<Kernel>> polygons(offset.chains.size());
  std::vector<std::list<Arc_polygon_2<Kernel>>> holes(offset.chains.size());
  for (std::size_t i = 0; i < offset.chains.size(); ++i) {
    const Offset::Chain& chain = offset.chains[i];
    if (!chain.is_closed) continue;
    std::vector<Arc_2> arcs;
    for (const Offset::Piece& piece : chain.pieces) arcs.push_back(piece.arc);
    polygons[i] = general_polygon<Kernel>(arcs);
    if (chain.is_ccw || !chain.parent) continue;
    holes[*chain.parent].push_back(polygons[i]);
    holes[*chain.parent].back().reverse_orientation();
  }
  std::vector<Arc_polygon_with_holes_2<Kernel>> parts;
  for (std::size_t i = 0; i < offset.chains.size(); ++i)
    if (offset.chains[i].is_closed && offset.chains[i].is_ccw)
      parts.emplace_back(polygons[i], holes[i].begin(), holes[i].end());
  return parts;
}

namespace internal {

// The area along arcs of CGAL's circle segment traits, in intervals.

using Area_interval = CGAL::Interval_nt<true>;

template <class NT> [[nodiscard]] Area_interval to_area_interval(const NT& x) {
  return Area_interval(CGAL::to_interval(x));
}

/// The area between an arc with bulge b >= 0 and its chord, over the chord's square: with R and the angle 4 atan b
///   ((1 + b^2)^2 atan b - b (1 - b^2)) / (8 b^2) = b/3 + b^3/15 - b^5/105 + ... = sum over k >= 1 of
//   (-1)^k b^(2k-1) / ((2k+1)(2k-1)(2k-3)),
/// whose signs alternate from the second term on. For longer arcs a triangle is taken off, and two arcs are left.
[[nodiscard]] inline Area_interval over_square_of_chord(const Area_interval& b) {
  constexpr double SHORT = 0.25;
  const Area_interval square = CGAL::square(b);
  if (b.sup() > SHORT) {
    const Area_interval half = b / (Area_interval(1) + CGAL::sqrt(Area_interval(1) + square));
    return b / Area_interval(4) +
           Area_interval(2) * (Area_interval(1) + square) / Area_interval(4) * over_square_of_chord(half);
  }
  constexpr int TERMS = 13;  // the next one is below 2^-60 of the first
  Area_interval sum(0), power = b;
  for (int k = 1; k <= TERMS; ++k) {
    const double factor = (2.0 * k + 1) * (2 * k - 1) * (2 * k - 3);
    sum += power / Area_interval(k % 2 == 0 ? factor : -factor);
    power *= square;
  }
  return sum + Area_interval(0, 1) * power;  // the rest has the sign of the next term, and is smaller
}

/// Twice what is to the left of a part that is at most half a circle, seen from an origin.
template <class Part>
[[nodiscard]] Area_interval twice_area_along(const Part& part, const Area_interval& x0, const Area_interval& y0) {
  const Area_interval x = to_area_interval(part.source().x()) - x0, y = to_area_interval(part.source().y()) - y0,
                      u = to_area_interval(part.target().x()) - x0, v = to_area_interval(part.target().y()) - y0;
  const Area_interval triangle = x * v - y * u;
  if (part.orientation() == CGAL::COLLINEAR) return triangle;
  const Area_interval square = CGAL::square(u - x) + CGAL::square(v - y);  // of the chord
  const Area_interval squared_radius = to_area_interval(part.supporting_circle().squared_radius());
  const Area_interval above = CGAL::sqrt(squared_radius - square / Area_interval(4));  // 0 for what is below 0
  Area_interval bulge = CGAL::sqrt(square) / (Area_interval(2) * (CGAL::sqrt(squared_radius) + above));
  bulge = Area_interval(bulge.inf(), (std::min)(bulge.sup(), 1.0));
  const Area_interval segment = Area_interval(2) * square * over_square_of_chord(bulge);
  return part.orientation() == CGAL::COUNTERCLOCKWISE ? triangle + segment : triangle - segment;
}

template <class Polygon> [[nodiscard]] Area_interval twice_area(const Polygon& polygon) {
  Area_interval sum(0);
  if (polygon.is_empty()) return sum;
  const auto& corner = polygon.curves_begin()->source();
  const Area_interval x0(CGAL::to_double(corner.x())), y0(CGAL::to_double(corner.y()));
  for (auto part = polygon.curves_begin(); part != polygon.curves_end(); ++part) sum += twice_area_along(*part, x0, y0);
  return sum;
}

}  // namespace internal

/// The area of an Arc_polygon_2: positive if it runs counterclockwise.
/// \guarantee certified; the bounds are some ulp of the coordinates times the perimeter apart
template <class Traits> [[nodiscard]] Measure_bounds polygon_area(const CGAL::General_polygon_2<Traits>& polygon) {
  const auto area = internal::twice_area(polygon) / CGAL::Interval_nt<true>(2);
  return {area.inf(), area.sup()};
}
/// The area of an Arc_polygon_with_holes_2, whose holes run clockwise. \pre it is bounded
template <class Polygon>
[[nodiscard]] Measure_bounds polygon_area(const CGAL::General_polygon_with_holes_2<Polygon>& polygon) {
  CGAL_precondition(!polygon.is_unbounded());
  CGAL::Interval_nt<true> sum = internal::twice_area(polygon.outer_boundary());
  for (auto hole = polygon.holes_begin(); hole != polygon.holes_end(); ++hole) sum += internal::twice_area(*hole);
  sum /= CGAL::Interval_nt<true>(2);
  return {sum.inf(), sum.sup()};
}

}  // namespace CGAL::Bounding_arcs

#endif
