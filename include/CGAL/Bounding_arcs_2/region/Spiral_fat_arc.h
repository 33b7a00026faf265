// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Spiral fat arcs (Barton and Elber 2011).  Inner: along the tight end's osculating circle to j, then the tangent
// segment to the flat end.  Outer: along the tight end's tangent to i, then the flat end's osculating circle.
// Derivation: doc/numerics.md; that the curve is inside: verify/verify_region.h.

#ifndef CGAL_BOUNDING_ARCS_2_REGION_SPIRAL_FAT_ARC_H
#define CGAL_BOUNDING_ARCS_2_REGION_SPIRAL_FAT_ARC_H

#include <CGAL/Bounding_arcs_2/frame/Tight_frame_2.h>
#include <CGAL/Bounding_arcs_2/region/Bca.h>
#include <CGAL/Bounding_arcs_2/region/Tight_axes.h>

#include <algorithm>

namespace CGAL::Bounding_arcs {

/// The SFA construction as a function of the chord frame; where the ends do not make a strict spiral it steps back
/// to BCA.
/// \cgalModels{Construction}
struct Spiral_fat_arc {
  static constexpr const char* NAME = "sfa";
  static constexpr int ARCS_PER_REGION = 2;
  static constexpr bool NEEDS_CURVATURE = true;
  static constexpr bool NEEDS_CONTROL_POINTS = false;
  static constexpr bool BOUNDARY_NEEDS_SQUARE_ROOT = true;

  /// The larger of the distance from i to the inner circle and, where the outer arc has a tangent parallel to the
  /// inner segment, its height over that segment.  Every outer point lies this close to the inner boundary: along the
  /// outer arc the distance to the inner circle has no inner maximum, as the circles are nested.
  template <class NT> [[nodiscard]] static NT thickness(const Chord_shape_2<NT>& f) {
    const Tight_frame_2<NT> t = tight_frame(f);
    if (!t.usable) return Bca::thickness(f);
    const NT ratio = corner_ratio(t), stretch = tangent_ratio(t), reach = t.chord * ratio;
    const NT at_corner = t.infinite ? reach : corner_height(t, ratio);
    // tan of half the angle between segment and flat end's tangent, and of half the turning of the outer arc
    const NT tilt = segment_tilt(t, stretch);
    const NT sin_turn = NT(2) * t.sin_mean * t.cos_mean, cos_turn = t.cos_mean * t.cos_mean - t.sin_mean * t.sin_mean;
    const NT rise = t.chord * t.sin_flat - reach * sin_turn, run = t.chord * t.cos_flat - reach * cos_turn;
    if (certainly_less(rise, NT(tilt * run))) return at_corner;  // no such tangent: i is the farthest
    const NT height = t.chord * tilt * (tilt / (t.k_flat * (NT(1) + tilt * tilt)));
    // one of the two where this is open: an enclosure holds both, a bounded number is no less than either
    if (!certainly_less(NT(tilt * run), rise)) return joined(at_corner, larger(at_corner, height));
    return larger(at_corner, height);
  }

  template <class NT> [[nodiscard]] static Region_boundary_2<NT> boundary(const Chord_frame_2<NT>& frame) {
    const Chord_shape_2<NT>& f = frame.shape;
    const Tight_frame_2<NT> t = tight_frame(f);
    if (!t.usable) return Bca::boundary(frame);
    const internal::Tight_axes<NT> axes = internal::tight_axes(frame);
    const Xy<NT> corner = axes.tight + NT(t.chord * corner_ratio(t)) * axes.along;
    const auto outer = chain<NT>(frame, axes, corner, {axes.tight, axes.normal_tight, NT(0)},
                                 internal::contact(axes.flat, axes.normal_flat, t.k_flat, f.turn, t.chord));
    if (t.infinite)  // the osculating circle is the end point itself
      return {Boundary_chain_2<NT>({frame.p0, frame.p1, {frame.p0, perp(f.chord), NT(0)}}), outer,
              Region_form::SPIRAL_FAT_ARC};
    const NT stretch = tangent_ratio(t);
    const Xy<NT> direction = segment_direction(t, axes, stretch);
    const Xy<NT> joint =
        f.tight_first ? touching_point(t, axes, stretch) : axes.flat + NT(t.chord * stretch) * direction;
    const Xy<NT> segment = NT(f.tight_first ? -1 : 1) * direction;
    const auto inner =
        chain<NT>(frame, axes, joint, internal::contact(axes.tight, axes.normal_tight, t.k_tight, f.turn, t.chord),
                  {axes.flat, perp(segment), NT(0)});
    return {inner, outer, Region_form::SPIRAL_FAT_ARC};
  }

 private:
  // |p_tight i| over the chord, the root of (K1 / b) s^2 + 2 beta s - 1 = 0 without cancellation.
  template <class NT> [[nodiscard]] static NT corner_ratio(const Tight_frame_2<NT>& t) {
    const NT beta = t.sin_difference / (NT(2) * t.b) + t.cos_tight;
    return NT(NT(1) / (beta + square_root(NT(beta * beta + t.k_flat / t.b))));
  }
  // The distance of i from the tight end's circle: less than |p_tight i|^2 K0 / c, where |p_tight i| < c sqrt(b / K1).
  template <class NT> [[nodiscard]] static NT corner_height(const Tight_frame_2<NT>& t, const NT& ratio) {
    const NT bend = NT(2) * t.k_tight * ratio;
    const NT height = t.chord * (bend * ratio) / (NT(1) + square_root(NT(NT(1) + bend * bend)));
    return limited(height, [&] { return NT(t.chord * t.b * t.k_tight / t.k_flat); });
  }
  // tan of half the angle by which the inner segment turns off the flat end's tangent, (s sin m - sin delta) over the
  // second factor below with s the stretch. Its square s^2 sin^2 m - sin^2 delta is s^2 sin alpha0 times K_B, the
  // contact circle's at the flat end, since sin^2 m - sin^2 delta = sin alpha0 sin alpha1 and s^2 (a + sin alpha0) = a.
  template <class NT> [[nodiscard]] static NT segment_tilt(const Tight_frame_2<NT>& t, const NT& stretch) {
    const NT run = t.cos_delta + stretch * t.cos_mean, rise = stretch * t.sin_tight * t.contact_flat();
    // without sin delta it is larger, and bounded where rounding takes sin delta and the stretch
    return limited(NT(stretch * rise / ((stretch * t.sin_mean + t.sin_delta) * run)),
                   [&] { return NT(rise / (t.sin_mean * run)); });
  }
  // The unit vector from the flat end along the inner segment.
  template <class NT>
  [[nodiscard]] static Xy<NT> segment_direction(const Tight_frame_2<NT>& t, const internal::Tight_axes<NT>& axes,
                                                const NT& stretch) {
    const NT tilt = segment_tilt(t, stretch), square = NT(1) + tilt * tilt;
    return NT((NT(1) - tilt * tilt) / square) * axes.back + NT(NT(2) * tilt / square) * axes.inward_flat;
  }
  // j from the tight end, by half the angle that the inner arc turns through.
  template <class NT>
  [[nodiscard]] static Xy<NT> touching_point(const Tight_frame_2<NT>& t, const internal::Tight_axes<NT>& axes,
                                             const NT& stretch) {
    const NT half_turn = t.sin_tight / (t.cos_tight + stretch);
    const NT scale = t.chord * half_turn / (t.k_tight * (NT(1) + half_turn * half_turn));
    return axes.tight + scale * (axes.along + half_turn * axes.inward_tight);
  }
  // tangent length from the flat end to the tight end's osculating circle, over the chord: sqrt(a / K0)
  template <class NT> [[nodiscard]] static NT tangent_ratio(const Tight_frame_2<NT>& t) {
    return t.infinite ? NT(1) : square_root(NT(t.a / t.k_tight));
  }
};

}  // namespace CGAL::Bounding_arcs

#endif
