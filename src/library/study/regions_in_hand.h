// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// All eight kinds of region as a search has them in hand: made in doubles from a piece of a segment, two samples and,
// for four of the kinds, its control points.
//
//                 made from                      in hand
//  BCA            directions at the ends         a fat arc
//  SFA, bilens    these and curvatures           one or two fat arcs, about the curve half a thickness outside of the
//                                                inner side: what is between the sides is within half a thickness
//  fat arc        control points                 a fat arc
//  fat biarc      control points                 two fat arcs
//  box            the ends                       a box along the axes
//  oriented box   directions at the ends         a rectangle over the chord, as high as the outer bounding arc
//  hull           control points                 a convex polygon
//
// Radii have room for rounding: a share of 2^-44 of the chord beside the segment's own error. For BCA that is derived
// (tree/Spiral_piece_2.h), for the others it is measured only: they are here to be compared with. Where a kind is not
// defined, as on lines, or comes out thicker, it steps back to BCA.

#ifndef BOUNDING_ARCS_LIBRARY_STUDY_REGIONS_IN_HAND_H
#define BOUNDING_ARCS_LIBRARY_STUDY_REGIONS_IN_HAND_H

#include <CGAL/Bounding_arcs_2/region/Bilens.h>
#include <CGAL/Bounding_arcs_2/region/Spiral_fat_arc.h>
#include <CGAL/Bounding_arcs_2/study/Axis_box.h>
#include <CGAL/Bounding_arcs_2/study/Control_hull.h>
#include <CGAL/Bounding_arcs_2/study/Fat_biarc.h>
#include <CGAL/Bounding_arcs_2/study/Oriented_box.h>
#include <CGAL/Bounding_arcs_2/study/Three_point_fat_arc.h>
#include "../tree/Segment_hierarchy.h"
#include "Convex_region_2.h"
#include "Fat_chain_2.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::study {

/// The frame of a piece from its samples, unit tangents for derivatives: curvatures are the bounds that make regions
/// larger.
[[nodiscard]] inline Chord_frame_2<double> frame_of(const Spiral_piece_2& piece) {
  const Spiral_sample &p = piece.first, &q = piece.last;
  const bool turns_left = cross(p.tangent, q.tangent) >= 0, is_first_tight = p.most_curvature >= q.most_curvature;
  const double sign = turns_left ? 1 : -1, k0 = is_first_tight ? p.most_curvature : p.least_curvature,
               k1 = is_first_tight ? q.least_curvature : q.most_curvature;
  return chord_frame(End_jet_2<double>{p.point, p.tangent, (sign * k0) * perp(p.tangent)},
                     End_jet_2<double>{q.point, q.tangent, (sign * k1) * perp(q.tangent)});
}
/// Returns that frame with the control points of the piece, seen from its start.
[[nodiscard]] inline Chord_frame_2<double> frame_with_control_points(const Segment_hierarchy& curves,
                                                                     const Spiral_piece_2& piece) {
  Chord_frame_2<double> frame = frame_of(piece);
  const Bezier_curve_2<double> part =
      curves.bezier(curves.bezier_of(piece.segment)).subcurve(piece.first.t, piece.last.t);
  for (const Xy<double>& p : part.control_points()) frame.shape.control_points.push_back(p - frame.p0);
  frame.shape.control_points.front() = {};
  frame.shape.control_points.back() = frame.shape.chord;
  frame.shape.weights = part.weights();
  return frame;
}

/// A fat arc beside its chain form: how much larger radii are for rounding.
[[nodiscard]] inline double room_in_hand(const Segment_hierarchy& curves, const Spiral_piece_2& piece) {
  constexpr double OF_CHORD = 0x1p-44;
  return curves.error(piece.segment) + OF_CHORD * euclidean_norm(piece.last.point - piece.first.point);
}
/// Whether directions and curvatures at both ends have bounds.
[[nodiscard]] inline bool has_ends(const Spiral_piece_2& piece) {
  constexpr double GOOD = 0x1p-30;
  return piece.first.tangent_error <= GOOD && piece.last.tangent_error <= GOOD &&
         std::isfinite(piece.first.most_curvature + piece.last.most_curvature);
}

/// A chain, or BCA where that has no larger radius or the chain is not finite.
[[nodiscard]] inline Fat_chain_2 thinner(const Fat_chain_2& chain, const Fat_arc_2& bca) {
  const Arc_2 &a = chain.parts[0].arc, &b = chain.parts[chain.size - 1].arc;
  const double sum =
      chain.parts[0].radius + a.bulge + b.bulge + a.from.x + a.from.y + a.to.x + a.to.y + b.to.x + b.to.y;
  if (!std::isfinite(sum) || !(chain.parts[0].radius <= bca.radius)) return {{bca, {}}, 1};
  return chain;
}

/// The curve half a thickness outside of the inner side, whose joint is smooth, and that radius.
template <class Construction>
[[nodiscard]] Fat_chain_2 chain_beside_inner(const Segment_hierarchy& curves, const Spiral_piece_2& piece) {
  const Fat_arc_2 bca = curves.region(piece);
  if (!has_ends(piece)) return {{bca, {}}, 1};
  const Chord_frame_2<double> frame = frame_of(piece);
  if (!frame.shape.proper) return {{bca, {}}, 1};
  const double half = 0.5 * Construction::thickness(frame.shape);
  const Region_boundary_2<double> boundary = Construction::boundary(frame);
  if (boundary.form == Region_form::BCA) return {{bca, {}}, 1};
  const auto outside = [&](const Contact_circle_2<double>& circle, const Xy<double>& p) {
    const Xy<double> n = circle.normal_at(p);
    return p - (frame.shape.turn * half / euclidean_norm(n)) * n;
  };
  const double radius = half + room_in_hand(curves, piece);
  Fat_chain_2 chain;
  chain.size = boundary.inner.size();
  for (std::size_t i = 0; i < chain.size; ++i) {
    const Boundary_piece_2<double>& p = boundary.inner[i];
    const Xy<double> from = i == 0 ? outside(p.support, p.from) : chain.parts[0].arc.to;
    chain.parts[i] = {{from, outside(p.support, p.to), bulge(boundary.inner, i, true)}, radius};
  }
  return thinner(chain, bca);
}

/// The middle of a strip, and half its width.
template <class Construction>
[[nodiscard]] Fat_chain_2 middle_of_strip(const Segment_hierarchy& curves, const Spiral_piece_2& piece) {
  const Fat_arc_2 bca = curves.region(piece);
  if (!has_ends(piece) || bca.arc.bulge == 0) return {{bca, {}}, 1};
  const Chord_frame_2<double> frame = frame_with_control_points(curves, piece);
  const Region_outline_2<double> outline = Construction::boundary(frame);
  if (outline.form != Outline_form::STRIP) return {{bca, {}}, 1};
  Fat_chain_2 chain;
  chain.size = outline.inner.size() - 2;
  const double radius = 0.5 * Construction::thickness(frame.shape) + room_in_hand(curves, piece);
  for (std::size_t i = 0; i < chain.size; ++i) {
    const Boundary_piece_2<double>&p = outline.inner[i + 1], &q = outline.outer[i + 1];
    const Xy<double> from = i == 0 ? 0.5 * (p.from + q.from) : chain.parts[0].arc.to;
    chain.parts[i] = {{from, 0.5 * (p.to + q.to), bulge(q)}, radius};
  }
  return thinner(chain, bca);
}

/// The rectangle over the chord that holds the two bounding arcs.
[[nodiscard]] inline Convex_region_2 box_over_chord(const Fat_arc_2& bca) {
  const Xy<double> chord = bca.arc.to - bca.arc.from, apex = (-0.5 * bca.arc.bulge) * perp(chord);
  const bool is_left = bca.arc.bulge < 0;
  const Xy<double>&p = bca.arc.from, &q = bca.arc.to;
  Convex_region_2 region{{p, q, q + apex, p + apex}, bca.radius, p, q};
  if (!is_left) std::reverse(region.points.begin(), region.points.end());
  return region;
}

/// The convex hull of the piece's control points.
[[nodiscard]] inline Convex_region_2 hull_in_hand(const Segment_hierarchy& curves, const Spiral_piece_2& piece) {
  const Bezier_curve_2<double> part =
      curves.bezier(curves.bezier_of(piece.segment)).subcurve(piece.first.t, piece.last.t);
  if (part.control_points().size() > Convex_region_2::MOST_POINTS || !has_ends(piece))
    return box_over_chord(curves.region(piece));
  std::vector<Xy<double>> sorted = part.control_points();
  const auto is_before = [](const Xy<double>& p, const Xy<double>& q) {
    return p.x < q.x || (p.x == q.x && p.y < q.y);
  };
  std::sort(sorted.begin(), sorted.end(), is_before);
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  Convex_region_2 region{{}, room_in_hand(curves, piece), piece.first.point, piece.last.point};
  for (const bool is_upper : {false, true}) {  // Andrew 1979
    const std::size_t first = region.points.size();
    for (const Xy<double>& p : sorted) {
      while (region.points.size() > first + 1 &&
             cross(region.points.back() - region.points[region.points.size() - 2], p - region.points.back()) <= 0)
        region.points.pop_back();
      region.points.push_back(p);
    }
    if (sorted.size() > 1) region.points.pop_back();  // where the other chain starts
    if (!is_upper) std::reverse(sorted.begin(), sorted.end());
  }
  return region;
}

/// The region of a piece as a search has it.
template <class Construction>
[[nodiscard]] auto region_in_hand(const Segment_hierarchy& curves, const Spiral_piece_2& piece) {
  if constexpr (std::is_same_v<Construction, Bca>) return curves.region(piece);
  else if constexpr (std::is_same_v<Construction, Spiral_fat_arc> || std::is_same_v<Construction, Bilens>)
    return chain_beside_inner<Construction>(curves, piece);
  else if constexpr (std::is_same_v<Construction, Three_point_fat_arc> || std::is_same_v<Construction, Fat_biarc>)
    return middle_of_strip<Construction>(curves, piece);
  else if constexpr (std::is_same_v<Construction, Axis_box>)
    return Piece_box_2{curves.box(piece), piece.first.point, piece.last.point};
  else if constexpr (std::is_same_v<Construction, Oriented_box>) return box_over_chord(curves.region(piece));
  else return hull_in_hand(curves, piece);
}

}  // namespace CGAL::Bounding_arcs::study

#endif
