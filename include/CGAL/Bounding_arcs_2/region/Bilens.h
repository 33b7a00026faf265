// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bilens (Kurnosenko 2013): two biarcs, the tightest of those that touch a spiral at both ends.  The inner one starts
// on the tight end's osculating circle, the outer one ends on the flat end's.  Derivation: doc/numerics.md; that the
// curve is inside: verify/verify_region.h.

#ifndef CGAL_BOUNDING_ARCS_2_REGION_BILENS_H
#define CGAL_BOUNDING_ARCS_2_REGION_BILENS_H

#include <CGAL/Bounding_arcs_2/frame/Tight_frame_2.h>
#include <CGAL/Bounding_arcs_2/region/Bca.h>
#include <CGAL/Bounding_arcs_2/region/Tight_axes.h>

namespace CGAL::Bounding_arcs {

/// The bilens construction as a function of the chord frame; where the ends do not make a strict spiral (arcs, lines,
/// slivers past a vertex) it steps back to BCA.
/// \cgalModels{Construction}
struct Bilens {
  static constexpr const char* NAME = "bilens";
  static constexpr int ARCS_PER_REGION = 4;
  static constexpr bool NEEDS_CURVATURE = true;
  static constexpr bool NEEDS_CONTROL_POINTS = false;
  static constexpr bool BOUNDARY_NEEDS_SQUARE_ROOT = true;

  /// The deviation between the two contact circles that are not osculating, from their Lie product
  /// e = 4 (K_B - K1)(K_A - sin alpha0) = 4 q (1 - q / (a b)), q = sin^2 delta.
  template <class NT> [[nodiscard]] static NT thickness(const Chord_shape_2<NT>& f) {
    const Tight_frame_2<NT> t = tight_frame(f);
    if (!t.usable) return Bca::thickness(f);
    // with r_a = sin delta / a, r_b = sin delta / b, 0 < r_a r_b <= 1, one factor sin delta comes out of everything
    const NT ratio_a = t.infinite ? NT(0) : NT(t.sin_delta / t.a), ratio_b = t.sin_delta / t.b;
    const NT room = NT(4) * (NT(1) - ratio_a * ratio_b), change = NT(2) * t.cos_mean + ratio_a + ratio_b;
    const NT product = contact_tight(t) * t.contact_flat();
    const NT thickness =
        NT(t.chord / NT(2) * t.sin_delta * room / (change + square_root(NT(change * change + product * room))));
    // The bilens lies within the BCA, which bounds it where rounding takes the differences of curvature.
    return limited(thickness, [&] { return Bca::thickness(f); });
  }

  template <class NT> [[nodiscard]] static Region_boundary_2<NT> boundary(const Chord_frame_2<NT>& frame) {
    const Chord_shape_2<NT>& f = frame.shape;
    const Tight_frame_2<NT> t = tight_frame(f);
    if (!t.usable) return Bca::boundary(frame);
    const internal::Tight_axes<NT> axes = internal::tight_axes(frame);
    const NT outer_k = contact_tight(t), inner_k = t.contact_flat(), ratio_b = t.sin_delta / t.b;
    const auto circle = [&](const Xy<NT>& p, const Xy<NT>& n, const NT& k) {
      return internal::contact(p, n, k, f.turn, t.chord);
    };
    const bool from_tight = f.tight_first;  // p0 is the tight end
    const NT outer_x = from_tight ? NT(ratio_b * t.cos_delta + t.cos_tight) : NT(t.cos_delta / ratio_b + t.cos_flat);
    const auto outer =
        chain(frame, axes, internal::biarc_joint(axes, t.chord, from_tight, outer_x, from_tight ? outer_k : t.k_flat),
              circle(axes.tight, axes.normal_tight, outer_k), circle(axes.flat, axes.normal_flat, t.k_flat));
    const Contact_circle_2<NT> inner_flat = circle(axes.flat, axes.normal_flat, inner_k);
    if (t.infinite)  // the osculating circle is the end point itself
      return {Boundary_chain_2<NT>({frame.p0, frame.p1, inner_flat}), outer, Region_form::BILENS};
    const NT ratio_a = t.sin_delta / t.a;
    const NT inner_x = from_tight ? NT(t.cos_delta / ratio_a + t.cos_tight) : NT(ratio_a * t.cos_delta + t.cos_flat);
    const auto inner =
        chain(frame, axes, internal::biarc_joint(axes, t.chord, from_tight, inner_x, from_tight ? t.k_tight : inner_k),
              circle(axes.tight, axes.normal_tight, t.k_tight), inner_flat);
    return {inner, outer, Region_form::BILENS};
  }

 private:
  // K of the contact circle at the tight end that touches the flat end's osculating circle.
  template <class NT> [[nodiscard]] static NT contact_tight(const Tight_frame_2<NT>& t) {
    return NT(t.sin_tight + t.sin_delta * (t.sin_delta / t.b));
  }
};

}  // namespace CGAL::Bounding_arcs

#endif
