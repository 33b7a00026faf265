// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Closed chains of arcs as polygons of CGAL's Boolean set operations: chains of a fit, offsets, regions.

#ifndef CGAL_BOUNDING_ARCS_2_EXCHANGE_GENERAL_POLYGON_H
#define CGAL_BOUNDING_ARCS_2_EXCHANGE_GENERAL_POLYGON_H

#include <CGAL/Bounding_arcs_2/exchange/circle_segment_curve.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/offset/Offset_2.h>

#include <CGAL/Gps_circle_segment_traits_2.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <cstddef>
#include <list>
#include <optional>
#include <stdexcept>
#include <vector>

namespace CGAL::Bounding_arcs {

/// General_polygon_2 and General_polygon_with_holes_2 of arcs and segments.
template <class Kernel = CGAL::Exact_predicates_exact_constructions_kernel>
using Arc_polygon_2 = typename Gps_circle_segment_traits_2<Kernel>::Polygon_2;
/// A polygon of arcs and segments with holes.
template <class Kernel = CGAL::Exact_predicates_exact_constructions_kernel>
using Arc_polygon_with_holes_2 = typename Gps_circle_segment_traits_2<Kernel>::Polygon_with_holes_2;

/// The polygon that boundary pieces over an exact field run round, counterclockwise whichever way they do.
/// \pre the pieces do not meet but at their ends
/// \throws std::invalid_argument unless each piece starts where the one before ends
/// \guarantee exact
template <class Kernel = CGAL::Exact_predicates_exact_constructions_kernel>
[[nodiscard]] Arc_polygon_2<Kernel> general_polygon(const std::vector<Boundary_piece_2<typename Kernel::FT>>& pieces) {
  Arc_polygon_2<Kernel> polygon;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const auto& p = pieces[i];
    if (!(p.to == pieces[(i + 1) % pieces.size()].from))
      throw std::invalid_argument(
          expected("piece " + text_of(i), "an end where the next piece starts", "another place"));
    if (p.from == p.to) continue;
    const auto insert = [&](const auto& part) { polygon.push_back(part); };
    x_monotone_parts<Kernel>(circle_segment_curve<Kernel>(p), boost::make_function_output_iterator(insert));
  }
  if (!polygon.is_empty() && polygon.orientation() == CGAL::CLOCKWISE) polygon.reverse_orientation();
  return polygon;
}

/// Returns the polygon that arcs run round: Arc_2 or what has their members (Arc_chain::Arc), in a range.
template <class Kernel = CGAL::Exact_predicates_exact_constructions_kernel, class Arcs>
[[nodiscard]] Arc_polygon_2<Kernel> polygon_of_arcs(const Arcs& arcs) {
  std::vector<Boundary_piece_2<typename Kernel::FT>> pieces;
  for (const auto& arc : arcs) pieces.push_back(exact_piece<typename Kernel::FT>({arc.from, arc.to, arc.bulge}));
  return general_polygon<Kernel>(pieces);
}

/// The region between the two sides of an exact boundary, as BCA have over rational numbers.
/// \return nothing where the sides are one: a straight or circular piece has no area
/// \guarantee exact
template <class Kernel = CGAL::Exact_predicates_exact_constructions_kernel, class NT>
[[nodiscard]] std::optional<Arc_polygon_2<Kernel>> region_polygon(const Region_boundary_2<NT>& region) {
  using FT = typename Kernel::FT;
  using Piece = Boundary_piece_2<FT>;
  const auto is_same = [](const Piece& a, const Piece& b) {
    return a.is_segment() ? b.is_segment() : !b.is_segment() && a.support.center() == b.support.center();
  };
  std::vector<Piece> pieces;
  for (const auto& p : region.outer) pieces.push_back(piece_over<FT>(p));
  std::vector<Piece> back;
  for (const auto& p : region.inner) back.push_back(piece_over<FT>(p));
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
    polygons[i] = polygon_of_arcs<Kernel>(arcs);
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

}  // namespace CGAL::Bounding_arcs

#endif
