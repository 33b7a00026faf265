// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Spiral fat arcs (Barton and Elber 2011).  Inner: along the tight end's osculating circle to j, then the tangent
// segment to the flat end.  Outer: along the tight end's tangent to i, then the flat end's osculating circle.

#ifndef CGAL_BOUNDING_ARCS_2_REGION_SPIRAL_FAT_ARC_H
#define CGAL_BOUNDING_ARCS_2_REGION_SPIRAL_FAT_ARC_H

#include <CGAL/Bounding_arcs_2/region/Bca.h>
#include <CGAL/Bounding_arcs_2/region/Tight_frame_2.h>

#include <limits>

namespace CGAL::Bounding_arcs {

/// The SFA construction as a function of the chord frame; where the ends do not make a strict spiral it steps back
/// to BCA.
struct Spiral_fat_arc {
  static constexpr const char* NAME = "sfa";
  static constexpr int ARCS_PER_REGION = 2;
  static constexpr bool NEEDS_CURVATURE = true;
  static constexpr bool NEEDS_CONTROL_POINTS = false;
  static constexpr bool BOUNDARY_NEEDS_SQUARE_ROOT = true;

  /// The larger of the distance from i to the inner circle and, where the outer arc has a tangent parallel to the
  /// inner segment, its height over that segment.  Every outer point lies this close to the inner boundary: along the
  /// outer arc the distance to the inner circle has no inner maximum, as the circles are nested.
  template <class NT>
  [[nodiscard]] static NT thickness(const Chord_shape_2<NT>& f) {
    const Tight_frame_2<NT> t = internal::tight_frame(f);
    if (!t.usable) return Bca::thickness(f);
    const NT reach = corner_distance(t), stretch = tangent_ratio(t);
    const NT at_corner = t.infinite ? reach : corner_height(t, reach);
    // tan of half the angle between segment and flat end's tangent, and of half the turning of the outer arc
    const NT tilt = (stretch * t.sin_mean - t.sin_delta) / (t.cos_delta + stretch * t.cos_mean);
    const NT sin_turn = NT(2) * t.sin_mean * t.cos_mean, cos_turn = t.cos_mean * t.cos_mean - t.sin_mean * t.sin_mean;
    const NT rise = t.chord * t.sin_flat - reach * sin_turn, run = t.chord * t.cos_flat - reach * cos_turn;
    if (internal::certainly_less(NT(rise), NT(tilt * run))) return at_corner;  // no such tangent: i is the farthest
    if constexpr (internal::is_interval_v<NT>)
      if (!internal::certainly_less(NT(tilt * run), rise)) return NT(0, std::numeric_limits<double>::infinity());
    const NT height = t.chord * tilt * tilt / (t.k_flat * (NT(1) + tilt * tilt));
    return internal::larger(at_corner, height);
  }

  template <class NT>
  [[nodiscard]] static Region_boundary_2<NT> boundary(const Chord_frame_2<NT>& frame) {
    const Chord_shape_2<NT>& f = frame.shape;
    const Tight_frame_2<NT> t = internal::tight_frame(f);
    if (!t.usable) return Bca::boundary(frame);
    const internal::Tight_axes<NT> axes = internal::tight_axes(frame);
    const Xy<NT> corner = axes.tight + corner_distance(t) * axes.along;
    const auto outer = internal::chain<NT>(frame, axes, corner, {axes.tight, axes.normal_tight, NT(0)},
                                           internal::contact(axes.flat, axes.normal_flat, t.k_flat, f.turn, t.chord));
    if (t.infinite)  // the osculating circle is the end point itself
      return {Boundary_chain_2<NT>({frame.p0, frame.p1, {frame.p0, perp(f.chord), NT(0)}}), outer,
              Region_form::SPIRAL_FAT_ARC};
    const NT half_turn = t.sin_tight / (t.cos_tight + tangent_ratio(t));  // tangent of it, from the tight end to j
    const NT scale = t.chord * half_turn / (t.k_tight * (NT(1) + half_turn * half_turn));
    const Xy<NT> joint = axes.tight + scale * (axes.along + half_turn * axes.inward_tight);
    const Xy<NT> segment = f.tight_first ? axes.flat - joint : joint - axes.flat;
    const auto inner = internal::chain<NT>(
        frame, axes, joint, internal::contact(axes.tight, axes.normal_tight, t.k_tight, f.turn, t.chord),
        {axes.flat, perp(segment), NT(0)});
    return {inner, outer, Region_form::SPIRAL_FAT_ARC};
  }

 private:
  // |p_tight i|, the root of K1 s^2 + beta c s - b c^2 = 0 without cancellation.
  template <class NT>
  [[nodiscard]] static NT corner_distance(const Tight_frame_2<NT>& t) {
    const NT beta = NT(2) * (t.sin_delta * t.cos_delta + t.b * t.cos_tight);
    return NT(NT(2) * t.chord * t.b / (beta + internal::square_root(NT(beta * beta + NT(4) * t.k_flat * t.b))));
  }
  // The distance of i from the tight end's circle: less than |p_tight i|^2 K0 / c, where |p_tight i| < c sqrt(b / K1).
  template <class NT>
  [[nodiscard]] static NT corner_height(const Tight_frame_2<NT>& t, const NT& reach) {
    const NT bend = NT(2) * t.k_tight / t.chord * reach;
    const NT height = bend * reach / (NT(1) + internal::square_root(NT(NT(1) + bend * bend)));
    return internal::limited(height, [&] { return NT(t.chord * t.b * t.k_tight / t.k_flat); });
  }
  // tangent length from the flat end to the tight end's osculating circle, over the chord: sqrt(a / K0)
  template <class NT>
  [[nodiscard]] static NT tangent_ratio(const Tight_frame_2<NT>& t) {
    return t.infinite ? NT(1) : internal::square_root(NT(t.a / t.k_tight));
  }
};

}  // namespace CGAL::Bounding_arcs

#endif
