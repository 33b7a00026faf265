// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A region in hand: its arcs in doubles, as they are kept, handed out and written.  A side is points and bulges, p0, b,
// [joint, b,] p1; a bulge is the tangent of a quarter of the angle that an arc turns through, positive for a left turn,
// 0 for a segment, so that nothing is large where an arc is flat.

#ifndef CGAL_BOUNDING_ARCS_2_REGION_ARC_REGION_2_H
#define CGAL_BOUNDING_ARCS_2_REGION_ARC_REGION_2_H

#include <CGAL/Bounding_arcs_2/frame/Chord_frame_2.h>
#include <CGAL/Bounding_arcs_2/region/Contact_circle_2.h>
#include <CGAL/Bounding_arcs_2/region/thickness_bound.h>

#include <cstddef>

namespace CGAL::Bounding_arcs {

/// One side of a region between the region's ends: one arc with `bulges[0]`, or two that meet in `joint`.
struct Arc_side_2 {
  std::size_t size = 1;   ///< 1 or 2 arcs
  double bulges[2] = {};  ///< in [-1, 1]
  Xy<double> joint = {};  ///< of two arcs
};

/// A region's two sides in doubles, from the piece's start to its end; inner is the side of the centres of curvature.
struct Arc_region_2 {
  Xy<double> from, to;
  Arc_side_2 inner, outer;
  Region_form form = Region_form::BCA;  ///< the outer side of a spiral fat arc has a corner, other sides are smooth
};

/// The boundary that a region's points and bulges define.  Over a chord D the arc of bulge b leaves its start along D
/// turned by -2 atan b, (1 - b^2) D - 2 b perp(D) over (1 + b^2), with curvature 4 b / ((1 + b^2) |D|).
[[nodiscard]] inline Region_boundary_2<double> boundary_of(const Arc_region_2& region) {
  const auto piece = [](const Xy<double>& from, const Xy<double>& to, double b) {
    const Xy<double> chord = to - from, tangent = (1 - b * b) * chord - 2 * b * perp(chord);
    return Boundary_piece_2<double>{from, to, {from, perp(tangent), 4 * b}};
  };
  const auto chain = [&](const Arc_side_2& side) {
    if (side.size == 1) return Boundary_chain_2<double>(piece(region.from, region.to, side.bulges[0]));
    return Boundary_chain_2<double>(piece(region.from, side.joint, side.bulges[0]),
                                    piece(side.joint, region.to, side.bulges[1]));
  };
  return {chain(region.inner), chain(region.outer), region.form};
}

/// The region of a piece by itself: the construction's boundary seen from the piece's start and in units of its shape,
/// so that nothing leaves the range of doubles.
/// \param from, to the piece's ends as its neighbours have them
/// \guarantee bulges some u times the larger of themselves and their share of a side's length
template <class Construction, class Spiral>
[[nodiscard]] Arc_region_2 arc_region(const Construction& construction, const Spiral& spiral, double t0, double t1,
                                      const Xy<double>& from, const Xy<double>& to) {
  Chord_shape_2<double> shape = spiral.accurate_shape(t0, t1, shape_parts<Construction>());
  const double unit = shape.unit;
  shape.unit = 1;
  const Region_boundary_2<double> boundary = construction.boundary(frame_at_origin(shape));
  const auto side = [&](const Boundary_chain_2<double>& chain, bool is_smooth) {
    Arc_side_2 s;
    s.size = chain.size();
    for (std::size_t i = 0; i < s.size; ++i) s.bulges[i] = bulge(chain, i, is_smooth);
    if (s.size == 2) s.joint = from + unit * chain[0].to;
    return s;
  };
  const bool has_corner = boundary.form == Region_form::SPIRAL_FAT_ARC;
  return {from, to, side(boundary.inner, true), side(boundary.outer, !has_corner), boundary.form};
}

}  // namespace CGAL::Bounding_arcs

#endif
