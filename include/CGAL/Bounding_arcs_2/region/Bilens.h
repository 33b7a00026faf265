// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bilens (Kurnosenko 2013): two biarcs, the tightest of those that touch a spiral at both ends.  The inner one starts
// on the tight end's osculating circle, the outer one ends on the flat end's.

#ifndef CGAL_BOUNDING_ARCS_2_REGION_BILENS_H
#define CGAL_BOUNDING_ARCS_2_REGION_BILENS_H

#include <CGAL/Bounding_arcs_2/region/Bca.h>
#include <CGAL/Bounding_arcs_2/region/Tight_frame_2.h>

namespace CGAL::Bounding_arcs {

/// The bilens construction as a function of the chord frame; where the ends do not make a strict spiral (arcs, lines,
/// slivers past a vertex) it steps back to BCA.
struct Bilens {
  static constexpr const char* NAME = "bilens";
  static constexpr int ARCS_PER_REGION = 4;
  static constexpr bool NEEDS_CURVATURE = true;
  static constexpr bool NEEDS_CONTROL_POINTS = false;
  static constexpr bool BOUNDARY_NEEDS_SQUARE_ROOT = true;

  /// The deviation between the two contact circles that are not osculating, from their Lie product
  /// e = 4 (K_B - K1)(K_A - sin alpha0) = 4 q (a b - q) / (a b).
  template <class NT>
  [[nodiscard]] static NT thickness(const Chord_shape_2<NT>& f) {
    const Tight_frame_2<NT> t = internal::tight_frame(f);
    if (!t.usable) return Bca::thickness(f);
    const NT q = t.sin_delta * t.sin_delta;
    const NT outer = contact_tight(t), inner = contact_flat(t);
    const NT product = t.infinite ? NT(NT(4) * q) : NT(NT(4) * q * (t.a * t.b - q) / (t.a * t.b));
    const NT change = NT(2) * t.sin_delta * t.cos_mean +
                      (t.infinite ? NT(q / t.b) : NT(q * (t.a + t.b) / (t.a * t.b)));
    const NT thickness = NT(t.chord / NT(2) * product /
                            (change + internal::square_root(NT(change * change + outer * inner * product))));
    // The bilens lies within the BCA, which bounds it where rounding takes the differences of curvature.
    return internal::limited(thickness, [&] { return Bca::thickness(f); });
  }

  template <class NT>
  [[nodiscard]] static Region_boundary_2<NT> boundary(const Chord_frame_2<NT>& frame) {
    const Chord_shape_2<NT>& f = frame.shape;
    const Tight_frame_2<NT> t = internal::tight_frame(f);
    if (!t.usable) return Bca::boundary(frame);
    const internal::Tight_axes<NT> axes = internal::tight_axes(frame);
    const NT outer_k = contact_tight(t);
    // A biarc's joint is where the tangent has turned by the angle of tangent K sin d : x sin d from the tight end.
    const NT outer_x = t.sin_delta * t.cos_delta / t.b + t.cos_tight;
    const auto circle = [&](const Xy<NT>& p, const Xy<NT>& n, const NT& k) {
      return internal::contact(p, n, k, f.turn, t.chord);
    };
    const auto outer = internal::chain(frame, axes, joint(t, axes, outer_x, outer_k),
                                       circle(axes.tight, axes.normal_tight, outer_k),
                                       circle(axes.flat, axes.normal_flat, t.k_flat));
    const Contact_circle_2<NT> inner_flat = circle(axes.flat, axes.normal_flat, contact_flat(t));
    if (t.infinite)  // the osculating circle is the end point itself
      return {Boundary_chain_2<NT>({frame.p0, frame.p1, inner_flat}), outer, Region_form::BILENS};
    const NT inner_x = t.a * t.cos_delta / t.sin_delta + t.cos_tight;
    const auto inner = internal::chain(frame, axes, joint(t, axes, inner_x, t.k_tight),
                                       circle(axes.tight, axes.normal_tight, t.k_tight), inner_flat);
    return {inner, outer, Region_form::BILENS};
  }

 private:
  // K of the contact circle at the tight end that touches the flat end's osculating circle.
  template <class NT>
  [[nodiscard]] static NT contact_tight(const Tight_frame_2<NT>& t) {
    return NT(t.sin_tight + t.sin_delta * t.sin_delta / t.b);
  }
  // K of the contact circle at the flat end that touches the tight end's osculating circle.
  template <class NT>
  [[nodiscard]] static NT contact_flat(const Tight_frame_2<NT>& t) {
    return t.infinite ? t.sin_flat : NT(t.sin_flat - t.sin_delta * t.sin_delta / t.a);
  }
  template <class NT>
  [[nodiscard]] static Xy<NT> joint(const Tight_frame_2<NT>& t, const internal::Tight_axes<NT>& axes, const NT& x,
                                    const NT& k) {
    const NT scale = t.chord / (k * k + x * x);
    return axes.tight + (NT(scale * x) * axes.along + NT(scale * k) * axes.inward_tight);
  }
};

}  // namespace CGAL::Bounding_arcs

#endif
