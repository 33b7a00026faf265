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

#ifndef BOUNDING_ARCS_STUDY_REGIONS_IN_HAND_H
#define BOUNDING_ARCS_STUDY_REGIONS_IN_HAND_H

#include <CGAL/Bounding_arcs_2/number/stable_norm.h>
#include <CGAL/Bounding_arcs_2/region/Bilens.h>
#include <CGAL/Bounding_arcs_2/region/Fat_arc_2.h>
#include <CGAL/Bounding_arcs_2/region/Spiral_fat_arc.h>
#include <CGAL/Bounding_arcs_2/study/boxes_and_hulls.h>
#include <CGAL/Bounding_arcs_2/study/fat_arcs.h>
#include "../library/tree/Segment_hierarchy.h"

#include <CGAL/Bbox_2.h>

#include <boost/container/static_vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

/// The piece is in the box, and both of its ends are given.
struct Piece_box_2 {
  CGAL::Bbox_2 box;
  Xy<double> from, to;
};

/// The piece is within `radius` of a convex polygon, counterclockwise, and both of its ends are given.
struct Convex_region_2 {
  static constexpr std::size_t MOST_POINTS = 15;  ///< more points are given as the box along the chord that holds them
  boost::container::static_vector<Xy<double>, MOST_POINTS + 1> points;  ///< one more while a hull is made
  double radius = 0;
  Xy<double> from, to;
};

[[nodiscard]] inline double half_width(const Piece_box_2& p) {
  return 0.5 * (std::min)(p.box.xmax() - p.box.xmin(), p.box.ymax() - p.box.ymin());
}
[[nodiscard]] inline double half_width(const Convex_region_2& p) {
  double height = 0;
  const Xy<double> chord = p.to - p.from;
  const double length = euclidean_norm(chord);
  for (const Xy<double>& q : p.points) height = (std::max)(height, std::fabs(cross(chord, q - p.from)));
  return p.radius + (length > 0 ? 0.5 * height / length : 0);
}

/// What is added to lengths that are sums and products of coordinates no larger than this.
[[nodiscard]] inline double rounding_of_lengths(double size) { return 32 * HALF_ULP * size; }

/// The distance from a segment.
[[nodiscard]] inline double distance_from_segment(const Xy<double>& q, const Xy<double>& a, const Xy<double>& b) {
  const Xy<double> side = b - a, way = q - a;
  const double square = dot(side, side), share = square > 0 ? std::clamp(dot(way, side) / square, 0.0, 1.0) : 0;
  return euclidean_norm(way - share * side);
}
/// An upper bound of the distance from the nearer end of a piece, which is a point of it.
[[nodiscard]] inline double distance_from_ends(const Xy<double>& q, const Xy<double>& from, const Xy<double>& to) {
  return (std::min)(euclidean_norm(q - from), euclidean_norm(q - to));
}

[[nodiscard]] inline Bracket distance_bounds(const Xy<double>& q, const Piece_box_2& p) {
  const double dx = (std::max)({p.box.xmin() - q.x, q.x - p.box.xmax(), 0.0}),
               dy = (std::max)({p.box.ymin() - q.y, q.y - p.box.ymax(), 0.0});
  const double diagonal = p.box.xmax() - p.box.xmin() + p.box.ymax() - p.box.ymin(),
               upper = distance_from_ends(q, p.from, p.to);
  const double room = rounding_of_lengths(upper + diagonal);
  return {(std::max)(0.0, stable_norm(Xy<double>{dx, dy}) - room), upper + diagonal * 0x1p-40 + room};
}
[[nodiscard]] inline double least_distance(const Piece_box_2& p, const Piece_box_2& q) {
  const double dx = (std::max)({p.box.xmin() - q.box.xmax(), q.box.xmin() - p.box.xmax(), 0.0}),
               dy = (std::max)({p.box.ymin() - q.box.ymax(), q.box.ymin() - p.box.ymax(), 0.0});
  return stable_norm(Xy<double>{dx, dy}) * ROUNDED_DOWN<8>;
}
[[nodiscard]] inline bool are_apart(const Piece_box_2& p, const Piece_box_2& q) { return !do_overlap(p.box, q.box); }

/// The distance of a point from the polygon, 0 inside; one without an area has no inside.
[[nodiscard]] inline double distance_from_polygon(const Xy<double>& q, const Convex_region_2& p) {
  bool is_inside = false;
  for (std::size_t i = 2; i < p.points.size(); ++i)
    is_inside = is_inside || cross(p.points[i - 1] - p.points[0], p.points[i] - p.points[0]) > 0;
  double least = HUGE_VAL;
  for (std::size_t i = 0; i < p.points.size(); ++i) {
    const Xy<double>&a = p.points[i], &b = p.points[(i + 1) % p.points.size()];
    is_inside = is_inside && cross(b - a, q - a) >= 0;
    least = (std::min)(least, distance_from_segment(q, a, b));
  }
  return is_inside ? 0 : least;
}
[[nodiscard]] inline Bracket distance_bounds(const Xy<double>& q, const Convex_region_2& p) {
  const double upper = distance_from_ends(q, p.from, p.to) + p.radius,
               room = rounding_of_lengths(upper + euclidean_norm(p.to - p.from));
  return {(std::max)(0.0, distance_from_polygon(q, p) - p.radius - room), upper + room};
}
/// How far all of q is at least beyond a side of p, of all sides the largest.
[[nodiscard]] inline double separation(const Convex_region_2& p, const Convex_region_2& q) {
  double most = 0;
  for (std::size_t i = 0; i < p.points.size(); ++i) {
    const Xy<double>&a = p.points[i], &b = p.points[(i + 1) % p.points.size()];
    const double length = euclidean_norm(b - a);
    if (!(length > 0)) continue;
    double least = HUGE_VAL;
    for (const Xy<double>& c : q.points) least = (std::min)(least, cross(c - a, b - a));
    most = (std::max)(most, least / length);
  }
  return most;
}
/// The distance between polygons that a side of one keeps apart, by that of corners of each from sides of the other.
[[nodiscard]] inline double least_distance(const Convex_region_2& p, const Convex_region_2& q) {
  const double radii = p.radius + q.radius,
               size = euclidean_norm(p.from - q.from) + euclidean_norm(p.to - p.from) + euclidean_norm(q.to - q.from);
  if (!(separation(p, q) > 0) && !(separation(q, p) > 0)) return 0;
  double least = HUGE_VAL;
  for (const Xy<double>& c : q.points) least = (std::min)(least, distance_from_polygon(c, p));
  for (const Xy<double>& c : p.points) least = (std::min)(least, distance_from_polygon(c, q));
  return (std::max)(0.0, least - radii - rounding_of_lengths(size));
}
[[nodiscard]] inline bool are_apart(const Convex_region_2& p, const Convex_region_2& q) {
  const double radii = p.radius + q.radius,
               size = euclidean_norm(p.from - q.from) + euclidean_norm(p.to - p.from) + euclidean_norm(q.to - q.from);
  return (std::max)(separation(p, q), separation(q, p)) > radii + rounding_of_lengths(size);
}

/// The first `size` parts hold the piece, one after the other.
struct Fat_chain_2 {
  Fat_arc_2 parts[2];
  std::size_t size = 1;

  [[nodiscard]] const Fat_arc_2* begin() const { return parts; }
  [[nodiscard]] const Fat_arc_2* end() const { return parts + size; }
};

[[nodiscard]] inline double half_width(const Fat_chain_2& chain) { return chain.parts[0].radius; }

/// Bounds of the distance from a point to the piece.
[[nodiscard]] inline Bracket distance_bounds(const Xy<double>& q, const Fat_chain_2& chain) {
  Bracket least{HUGE_VAL, HUGE_VAL};
  for (const Fat_arc_2& part : chain) {
    const Bracket d = distance_bounds(q, part);
    least = {(std::min)(least.lower, d.lower), (std::min)(least.upper, d.upper)};
  }
  return least;
}
/// A lower bound of the distance of two pieces.
[[nodiscard]] inline double least_distance(const Fat_chain_2& a, const Fat_chain_2& b) {
  double least = HUGE_VAL;
  for (const Fat_arc_2& p : a)
    for (const Fat_arc_2& q : b) least = (std::min)(least, least_distance(p, q));
  return least;
}
/// Whether two pieces for certain have no common point; false may mean that it is not known.
[[nodiscard]] inline bool are_apart(const Fat_chain_2& a, const Fat_chain_2& b) {
  for (const Fat_arc_2& p : a)
    for (const Fat_arc_2& q : b)
      if (!are_apart(p, q)) return false;
  return true;
}

}  // namespace CGAL::Bounding_arcs

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

/// Regions of segments are kept, those of pieces made where a search asks for them, and both are counted.
/// \tparam Region_ of a piece in hand: searches are compiled once for all kinds that have one form
template <class Region_> class Region_hierarchy : public Segment_hierarchy {
 public:
  using Region = Region_;
  using Make = Region (*)(const Segment_hierarchy&, const Spiral_piece_2&);

  Region_hierarchy(const Segment_hierarchy& curves, Make make) : Segment_hierarchy(curves), make_(make) {
    regions_.reserve(number_of_segments());
    for (std::uint32_t i = 0; i < number_of_segments(); ++i) regions_.push_back(make(*this, piece(i)));
  }
  [[nodiscard]] const Region& region(std::uint32_t segment) const {
    ++asked_;
    return regions_[segment];
  }
  [[nodiscard]] Region region(const Spiral_piece_2& piece) const {
    ++asked_;
    return make_(*this, piece);
  }
  /// How many regions were asked for.
  [[nodiscard]] std::size_t asked() const { return asked_; }

 private:
  Make make_;
  std::vector<Region> regions_;
  mutable std::size_t asked_ = 0;
};

}  // namespace CGAL::Bounding_arcs::study

#endif
