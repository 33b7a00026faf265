// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The boundary of a region whose sides may have any number of pieces: polygons about a curve, and strips between
// offsets of arcs.  Boundaries of at most two pieces a side are Region_boundary_2.
//
//      ____arc____              a strip: from the curve's start along a normal to an offset arc, along it and back
//    a|           |b            along a normal to the curve's end; arcs are offsets of those of the other side, so that
//   p0|___________|p1           their joints have a normal in common, too

#ifndef CGAL_BOUNDING_ARCS_2_REGION_REGION_OUTLINE_2_H
#define CGAL_BOUNDING_ARCS_2_REGION_REGION_OUTLINE_2_H

#include <CGAL/Bounding_arcs_2/region/side_of_region.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

/// What the sides of an outline are made of.
enum class Outline_form {
  BCA,      ///< one arc a side: stepped back to bounding circular arcs
  POLYGON,  ///< segments only, convex
  STRIP     ///< a segment, one or two arcs, a segment a side
};

/// The two sides of a region, each from the piece's start to its end; inner is the side of the curve's centers.
template <class NT> struct Region_outline_2 {
  std::vector<Boundary_piece_2<NT>> inner, outer;
  Outline_form form = Outline_form::BCA;
  bool inner_is_left = true;  ///< of the curve's direction
};

/// The segment from one point to another as a boundary's piece.
template <class NT> [[nodiscard]] Boundary_piece_2<NT> segment_between(const Xy<NT>& from, const Xy<NT>& to) {
  return {from, to, {from, perp(to - from), NT(0)}};
}

/// The chain of segments through points, equal neighbours taken as one.
template <class NT> [[nodiscard]] std::vector<Boundary_piece_2<NT>> chain_through(const std::vector<Xy<NT>>& points) {
  std::vector<Boundary_piece_2<NT>> chain;
  for (std::size_t i = 1; i < points.size(); ++i)
    if (points[i - 1] != points[i]) chain.push_back(segment_between(points[i - 1], points[i]));
  if (chain.empty()) chain.push_back(segment_between(points.front(), points.back()));
  return chain;
}

/// A region between a left and a right chain.
template <class NT>
[[nodiscard]] Region_outline_2<NT> outline_between(std::vector<Boundary_piece_2<NT>> left,
                                                   std::vector<Boundary_piece_2<NT>> right, Outline_form form,
                                                   int turn) {
  if (turn < 0) return {std::move(right), std::move(left), form, false};
  return {std::move(left), std::move(right), form, true};
}

/// The outline of a region of one arc a side.
template <class NT> [[nodiscard]] Region_outline_2<NT> outline_of(const Region_boundary_2<NT>& region, int turn) {
  return {{region.inner.begin(), region.inner.end()},
          {region.outer.begin(), region.outer.end()},
          Outline_form::BCA,
          turn >= 0};
}

/// The edges of a polygon that have the region to their left, as (from, to): without those that both sides share, which
/// lie inside.
template <class NT>
[[nodiscard]] std::vector<std::pair<Xy<NT>, Xy<NT>>> edges_around(const Region_outline_2<NT>& outline) {
  const auto &left = outline.inner_is_left ? outline.inner : outline.outer,
             &right = outline.inner_is_left ? outline.outer : outline.inner;
  const auto is_shared = [](const Boundary_piece_2<NT>& a, const Boundary_piece_2<NT>& b) {
    return a.from == b.from && a.to == b.to;
  };
  const bool shares_ends = left.size() > 1 && right.size() > 1;
  const std::size_t first = shares_ends && is_shared(left.front(), right.front()) ? 1 : 0,
                    last = shares_ends && is_shared(left.back(), right.back()) ? 1 : 0;
  std::vector<std::pair<Xy<NT>, Xy<NT>>> edges;
  for (std::size_t i = first; i + last < right.size(); ++i) edges.emplace_back(right[i].from, right[i].to);
  for (std::size_t i = first; i + last < left.size(); ++i) edges.emplace_back(left[i].to, left[i].from);
  return edges;
}

/// The direction in which a piece leaves `from` or comes to `to`, of any length: a point of the piece.
template <class NT> [[nodiscard]] Xy<NT> direction_at(const Boundary_piece_2<NT>& piece, const Xy<NT>& point) {
  return -perp(piece.support.normal_at(point));
}

/// The bulge of a piece by itself, see Boundary_chain_2. Needs square roots. \pre its support's point is one of its
/// ends
template <class NT> [[nodiscard]] NT bulge(const Boundary_piece_2<NT>& piece) {
  return bulge(Boundary_chain_2<NT>(piece), 0, true);
}

/// Where a point lies against the region: of a polygon by the side of each edge, of a strip by the normals at its ends,
/// the joints' normal and the side of the arcs between.
/// \guarantee exact where the outline's numbers are; over double as good as they are
template <class NT>
[[nodiscard]] CGAL::Bounded_side bounded_side(const Region_outline_2<NT>& outline, const Xy<NT>& q) {
  if (outline.form == Outline_form::BCA)
    return bounded_side(
        Region_boundary_2<NT>{Boundary_chain_2<NT>(outline.inner[0]), Boundary_chain_2<NT>(outline.outer[0])}, q);
  bool is_inside = true;
  const auto is_beyond = [&](const NT& side) {
    const int sign = sign_of(side);
    is_inside = is_inside && sign > 0;
    return sign < 0;
  };
  if (outline.form == Outline_form::POLYGON) {
    for (const auto& [from, to] : edges_around(outline))
      if (is_beyond(cross(to - from, q - from))) return CGAL::ON_UNBOUNDED_SIDE;
  } else {
    const auto& outer = outline.outer;
    const std::size_t last = outer.size() - 2;
    const Xy<NT>&start = outer.front().from, &end = outer.back().to;
    if (is_beyond(dot(direction_at(outer[1], outer[1].from), q - start)) ||
        is_beyond(dot(direction_at(outer[last], outer[last].to), end - q)))
      return CGAL::ON_UNBOUNDED_SIDE;
    const bool is_past_joint =
        last == 2 && dot(direction_at(outer[1], outer[1].to), q - outer[1].to) > NT(0);  // the joint's normal
    const std::size_t arc = is_past_joint ? 2 : 1;
    const NT sign(outline.inner_is_left ? 1 : -1);
    if (is_beyond(NT(sign * outer[arc].support.side(q))) || is_beyond(NT(-sign * outline.inner[arc].support.side(q))))
      return CGAL::ON_UNBOUNDED_SIDE;
  }
  return is_inside ? CGAL::ON_BOUNDED_SIDE : CGAL::ON_BOUNDARY;
}

}  // namespace CGAL::Bounding_arcs

#endif
