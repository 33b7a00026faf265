// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Spiral fat arcs over a rational kernel: the circles are rational, the corner i and the touching point j are
// algebraic points of degree two, found as line-circle intersections; j lies on the rational polar line of the flat
// end.

#ifndef CGAL_BOUNDING_ARCS_2_REGION_INTERNAL_ALGEBRAIC_SPIRAL_FAT_ARC_H
#define CGAL_BOUNDING_ARCS_2_REGION_INTERNAL_ALGEBRAIC_SPIRAL_FAT_ARC_H

#include <CGAL/Bounding_arcs_2/frame/Chord_frame_2.h>
#include <CGAL/Bounding_arcs_2/region/Kernel_boundary.h>
#include <CGAL/Bounding_arcs_2/region/internal/circular_intersections.h>

#include <algorithm>

namespace CGAL::Bounding_arcs::internal {

/// The osculating circle at an end, free of square roots: normal perp(T) |T|^2, curvature 2 k / unit.
template <class FT>
[[nodiscard]] Contact_circle_2<FT> osculating_circle(const Chord_frame_2<FT>& frame, bool at_start) {
  const Chord_shape_2<FT>& f = frame.shape;
  const Xy<FT>& t = at_start ? f.tangent0 : f.tangent1;
  return {at_start ? frame.p0 : frame.p1, FT(dot(t, t) * f.unit) * perp(t),
          FT(FT(2) * (at_start ? f.curvature0 : f.curvature1))};
}

// The intersection of a line with a circle that is farther along `direction`, of two.
template <class CK, class FT>
[[nodiscard]] typename CK::Circular_arc_point_2 farther_intersection(const Xy<FT>& point, const Xy<FT>& direction,
                                                                     const typename CK::Circle_2& circle) {
  const typename CK::Line_2 line(kernel_point<CK>(point), typename CK::Vector_2(direction.x, direction.y));
  auto points = intersection_points<CK>(line, circle);  // two for a strict spiral, by the nesting of its circles
  const bool rising = direction.x > FT(0) || (direction.x == FT(0) && direction.y > FT(0));
  const auto less = [](const auto& p, const auto& q) { return CK().compare_xy_2_object()(p, q) == CGAL::SMALLER; };
  std::sort(points.begin(), points.end(), less);
  return rising ? points.back() : points.front();
}

// The inner chain: the tight end's circle to j, then the segment to the flat end.
// The polar line of the flat end q is (x - z)(q - z) = r^2, and j is its intersection on the right of z -> q where the
// tight circle is run through counterclockwise from the tight end.
template <class CK, class FT>
[[nodiscard]] std::vector<Kernel_piece_2<CK>> algebraic_inner_chain(const Chord_frame_2<FT>& frame) {
  using Arc_point = typename CK::Circular_arc_point_2;
  const bool first = frame.shape.tight_first, ccw = frame.shape.turn > 0;
  const auto p0 = kernel_point<CK>(frame.p0), p1 = kernel_point<CK>(frame.p1);
  if (first ? frame.shape.infinite0 : frame.shape.infinite1) return {{typename CK::Line_arc_2(p0, p1), false}};
  const Contact_circle_2<FT> osculating = osculating_circle(frame, first);
  const Xy<FT> z = osculating.center(), to_flat = (first ? frame.p1 : frame.p0) - z;
  const Xy<FT> foot = z + FT(osculating.squared_radius() / dot(to_flat, to_flat)) * to_flat;
  const auto circle = kernel_circle<CK>(osculating);
  const Arc_point j = farther_intersection<CK>(foot, FT(ccw == first ? -1 : 1) * perp(to_flat), circle);
  if (first) return {kernel_arc<CK>(circle, Arc_point(p0), j, ccw), {Algebraic_segment_2<CK>{j, Arc_point(p1)}, false}};
  return {{Algebraic_segment_2<CK>{Arc_point(p0), j}, false}, kernel_arc<CK>(circle, j, Arc_point(p1), ccw)};
}

// The outer chain: the tight end's tangent to i, then the flat end's osculating circle or, for curvature 0, line.
template <class CK, class FT>
[[nodiscard]] std::vector<Kernel_piece_2<CK>> algebraic_outer_chain(const Chord_frame_2<FT>& frame) {
  using Arc_point = typename CK::Circular_arc_point_2;
  using Line_arc = typename CK::Line_arc_2;
  const Chord_shape_2<FT>& f = frame.shape;
  const bool first = f.tight_first, ccw = f.turn > 0;
  const auto p0 = kernel_point<CK>(frame.p0), p1 = kernel_point<CK>(frame.p1);
  const Xy<FT>&tight = first ? frame.p0 : frame.p1, &flat = first ? frame.p1 : frame.p0;
  const Xy<FT> along = first ? f.tangent0 : -f.tangent1;
  const Contact_circle_2<FT> osculating = osculating_circle(frame, !first);
  if (osculating.is_line()) {  // two segments, and the corner is rational
    const Xy<FT> direction = first ? f.tangent1 : f.tangent0;
    const FT s = cross(Xy<FT>(flat - tight), direction) / cross(along, direction);
    const auto corner = kernel_point<CK>(Xy<FT>(tight + s * along));
    return {{Line_arc(p0, corner), false}, {Line_arc(corner, p1), false}};
  }
  const auto circle = kernel_circle<CK>(osculating);
  const typename CK::Line_2 tangent(kernel_point<CK>(tight), typename CK::Vector_2(along.x, along.y));
  const Arc_point i = farther_intersection<CK>(tight, along, circle);
  if (first) return {{Line_arc(tangent, Arc_point(p0), i), false}, kernel_arc<CK>(circle, i, Arc_point(p1), ccw)};
  return {kernel_arc<CK>(circle, Arc_point(p0), i, ccw), {Line_arc(tangent, i, Arc_point(p1)), false}};
}

/// \pre the frame is a strict spiral (shape.proper)
/// \source Barton and Elber 2011; j by pole and polar instead of two distances and a projection
template <class CK, class FT>
[[nodiscard]] Kernel_boundary_2<CK> algebraic_spiral_fat_arc(const Chord_frame_2<FT>& frame) {
  return {algebraic_inner_chain<CK>(frame), algebraic_outer_chain<CK>(frame)};
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
