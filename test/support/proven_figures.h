// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The figures whose error bounds are proven, by the names that they have in scripts.

#ifndef BOUNDING_ARCS_TEST_PROVEN_FIGURES_H
#define BOUNDING_ARCS_TEST_PROVEN_FIGURES_H

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>
#include <CGAL/Bounding_arcs_2/region/Bilens.h>
#include <CGAL/Bounding_arcs_2/tree/Bezier_evaluator.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace bounding_arcs_test {

/// A number, and what its error is measured by: itself, or a length.
template <class NT> struct Figure {
  Figure(const NT& v) : value(v), size(v) {}  // NOLINT: a figure by itself
  Figure(const NT& v, const NT& s) : value(v), size(s) {}
  NT value, size;
};
template <class NT> using Figures = std::map<std::string, Figure<NT>>;

/// \pre the shape is proper, with its tight end first
template <class NT> Figures<NT> frame_figures(const CGAL::Bounding_arcs::Chord_shape_2<NT>& f) {
  using namespace CGAL::Bounding_arcs;
  const Chord_angles_2<NT> g = f.angles();
  const Tight_frame_2<NT> t = tight_frame(f);
  Chord_frame_2<NT> frame;
  frame.shape = f;
  const Contact_circle_2<NT> circle = Bca::boundary(frame).outer[0].support,
                             lens_circle = Bilens::boundary(frame).outer[0].support;
  const Xy<NT> center = circle.center(), lens_center = lens_circle.center();
  const NT radius = euclidean_norm(center), lens_radius = euclidean_norm(lens_center);
  return {{"n0", g.length0},
          {"n1", g.length1},
          {"c", g.chord},
          {"d0", NT(g.length0 * g.chord + dot(f.tangent0, f.chord))},
          {"d1", NT(g.length1 * g.chord + dot(f.tangent1, f.chord))},
          {"bulge0", g.bulge0},
          {"bulge1", g.bulge1},
          {"change", f.bulge_change(g.length0, g.length1, g.chord)},
          {"thickness", Bca::thickness(f)},
          {"center_x", {center.x, radius}},
          {"center_y", {center.y, radius}},
          {"squared_radius", circle.squared_radius()},
          {"sin_tight", t.sin_tight},
          {"cos_tight", {t.cos_tight, NT(1)}},
          {"sin_delta", t.sin_delta},
          {"sin_difference", t.sin_difference},
          {"k_tight", t.k_tight},
          {"k_flat", t.k_flat},
          {"a", t.a},
          {"b", t.b},
          {"ratio_a", NT(t.sin_delta / t.a)},
          {"ratio_b", NT(t.sin_delta / t.b)},
          {"contact_flat", t.contact_flat()},
          {"lens_curvature", lens_circle.curvature},
          {"lens_center_x", {lens_center.x, lens_radius}},
          {"lens_center_y", {lens_center.y, lens_radius}},
          {"bilens_thickness", Bilens::thickness(f)}};
}

/// Of a point whose foot is on the arc.
template <class NT>
Figures<NT> arc_figures(const CGAL::Bounding_arcs::Xy<NT>& q, const CGAL::Bounding_arcs::Xy<NT>& from,
                        const CGAL::Bounding_arcs::Xy<NT>& to, const NT& bulge) {
  using namespace CGAL::Bounding_arcs;
  const Arc_view<NT> v = view(q, from, to, bulge);
  return {
      {"curvature", curvature(to - from, bulge)},
      {"distance", {distance_to_circle(v, v.apart, bulge), (std::max)(euclidean_norm(v.u0), euclidean_norm(v.u1))}}};
}

/// \pre coordinates are at most 1
template <class NT> Figures<NT> cubic_figures(const CGAL::Bounding_arcs::Xy<NT>* points, const NT& t) {
  const auto jet = CGAL::Bounding_arcs::Bezier_evaluator::cubic_jet(points, t);
  NT largest = 0;
  for (int i = 0; i < 4; ++i) largest = (std::max)(largest, NT(std::fabs(points[i].x)));
  return {{"point", {jet.point.x, largest}}, {"first", {jet.first.x, largest}}, {"second", {jet.second.x, largest}}};
}

}  // namespace bounding_arcs_test

#endif
