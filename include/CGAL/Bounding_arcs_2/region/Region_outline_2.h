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

#include <CGAL/Bounding_arcs_2/region/Contact_circle_2.h>

#include <CGAL/enum.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

// Where a point lies against a region, by signs only: caps of arcs over their own chords, and the triangle between two.

namespace internal {
/// The sign of where q lies against one piece and its chord: +1 strictly between them, 0 on the piece, -1 elsewhere.
template <class NT> [[nodiscard]] int side_of_cap(const Boundary_piece_2<NT>& piece, const Xy<NT>& q) {
  const Xy<NT> chord = piece.to - piece.from, v = q - piece.from;
  const int chord_side = sign_of(cross(chord, v));
  if (piece.is_segment()) {
    const NT along = dot(chord, v);
    return chord_side == 0 && !(along < NT(0)) && !(dot(chord, chord) < along) ? 0 : -1;
  }
  const int turn = piece.is_ccw() ? 1 : -1;
  if (turn * chord_side > 0) return -1;
  const int circle_side = turn * sign_of(piece.support.side(q));
  if (circle_side < 0) return -1;
  if (circle_side == 0) return 0;
  return 1;
}

/// +1 strictly between a chain and its chord (the chord included), 0 on the chain, -1 beyond.
template <class NT> [[nodiscard]] int side_of_chain(const Boundary_chain_2<NT>& chain, const Xy<NT>& q) {
  int side = -1;
  for (const Boundary_piece_2<NT>& piece : chain) {
    const int cap = side_of_cap(piece, q);
    if (cap == 0) return 0;
    if (cap > 0) side = 1;
  }
  if (side > 0 || chain.size() == 1) return side;
  const Xy<NT>&p = chain[0].from, &j = chain[0].to, &r = chain[1].to;
  const int orientation = sign_of(cross(j - p, r - p));
  const int a = orientation * sign_of(cross(j - p, q - p)), b = orientation * sign_of(cross(r - j, q - j)),
            c = orientation * sign_of(cross(p - r, q - r));
  return orientation != 0 && a >= 0 && b >= 0 && c >= 0 ? 1 : -1;
}
}  // namespace internal

/// Inside, on the boundary of, or outside the closed region between inner and outer boundary.
/// \guarantee exact where the boundary's coordinates are; over double as good as they are
template <class NT>
[[nodiscard]] CGAL::Bounded_side bounded_side(const Region_boundary_2<NT>& region, const Xy<NT>& q) {
  const int outer = internal::side_of_chain(region.outer, q), inner = internal::side_of_chain(region.inner, q);
  const Boundary_piece_2<NT>&first = region.outer[0], &second = region.inner[0];
  const bool opposite = !first.is_segment() && !second.is_segment() && first.is_ccw() != second.is_ccw();
  if (opposite) {  // a sliver past an inflection: the two arcs lie on different sides of the chord
    if (outer == 0 || inner == 0) return CGAL::ON_BOUNDARY;
    return outer > 0 || inner > 0 ? CGAL::ON_BOUNDED_SIDE : CGAL::ON_UNBOUNDED_SIDE;
  }
  if (outer == 0 || inner == 0) {
    // the other chain decides whether this boundary point is one of the region's
    const int other = outer == 0 ? -inner : outer;
    return other < 0 ? CGAL::ON_UNBOUNDED_SIDE : CGAL::ON_BOUNDARY;
  }
  return outer > 0 && inner < 0 ? CGAL::ON_BOUNDED_SIDE : CGAL::ON_UNBOUNDED_SIDE;
}

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

/// Whether a construction's regions are outlines.
template <class Construction>
inline constexpr bool has_outline_v =
    std::is_same_v<decltype(std::declval<const Construction&>().boundary(std::declval<const Chord_frame_2<double>&>())),
                   Region_outline_2<double>>;

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

namespace internal {
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
}  // namespace internal

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
    for (const auto& [from, to] : internal::edges_around(outline))
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
