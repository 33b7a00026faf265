// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The figures whose bounds are proven, by the names that they have in scripts.

#ifndef BOUNDING_ARCS_TEST_FRAME_FIGURES_H
#define BOUNDING_ARCS_TEST_FRAME_FIGURES_H

#include <CGAL/Bounding_arcs_2/region/Bilens.h>
#include <CGAL/Bounding_arcs_2/region/Spiral_fat_arc.h>

#include <map>
#include <string>

namespace bounding_arcs_test {

/// A number, and what its error is measured by: itself, or the length of its vector.
template <class NT> struct Figure {
  Figure(const NT& v) : value(v), size(v) {}  // NOLINT: a figure by itself
  Figure(const NT& v, const NT& s) : value(v), size(s) {}
  NT value, size;
};

/// \pre the shape is proper, with its tight end first
template <class NT> std::map<std::string, Figure<NT>> frame_figures(const CGAL::Bounding_arcs::Chord_shape_2<NT>& f) {
  using namespace CGAL::Bounding_arcs;
  const Chord_angles_2<NT> g = chord_angles(f);
  const Tight_frame_2<NT> t = tight_frame(f);
  Chord_frame_2<NT> frame;
  frame.shape = f;
  const Contact_circle_2<NT> circle = Bca::boundary(frame).outer[0].support;
  const NT radius = square_root(circle.squared_radius());
  const NT ahead0 = dot(f.tangent0, f.chord), ahead1 = dot(f.tangent1, f.chord);
  return {{"n0", g.length0},
          {"n1", g.length1},
          {"c", g.chord},
          {"d0", NT(g.length0 * g.chord + ahead0)},
          {"d1", NT(g.length1 * g.chord + ahead1)},
          {"bulge0", g.bulge0},
          {"bulge1", g.bulge1},
          {"change", bulge_change(f, g.length0, g.length1, g.chord)},
          {"thickness", Bca::thickness(f)},
          {"center_x", {circle.center().x, radius}},
          {"center_y", {circle.center().y, radius}},
          {"squared_radius", circle.squared_radius()},
          {"sin_tight", t.sin_tight},
          {"cos_tight", t.cos_tight},
          {"sin_delta", t.sin_delta},
          {"cos_delta", t.cos_delta},
          {"cos_mean", t.cos_mean},
          {"sin_difference", t.sin_difference},
          {"k_tight", t.k_tight},
          {"k_flat", t.k_flat},
          {"a", t.a},
          {"b", t.b},
          {"ratio_a", NT(t.sin_delta / t.a)},
          {"ratio_b", NT(t.sin_delta / t.b)},
          {"contact_flat", contact_flat(t)},
          {"sfa_thickness", Spiral_fat_arc::thickness(f)},
          {"bilens_thickness", Bilens::thickness(f)}};
}

}  // namespace bounding_arcs_test

#endif
