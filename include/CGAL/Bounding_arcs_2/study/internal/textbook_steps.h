// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the paper's own steps are made of: lines, their intersections, distances, and the two ends as the paper has
// them.

#ifndef CGAL_BOUNDING_ARCS_2_STUDY_INTERNAL_TEXTBOOK_STEPS_H
#define CGAL_BOUNDING_ARCS_2_STUDY_INTERNAL_TEXTBOOK_STEPS_H

#include <CGAL/Bounding_arcs_2/region/Tight_axes.h>
#include <CGAL/Bounding_arcs_2/study/Region_figures.h>

namespace CGAL::Bounding_arcs {
namespace study {

template <class NT> [[nodiscard]] Line_figure<NT> line_across(const Xy<NT>& point, const Xy<NT>& normal) {
  return {normal.x, normal.y, NT(-dot(normal, point))};
}

template <class NT> [[nodiscard]] Line_figure<NT> bisector(const Xy<NT>& p, const Xy<NT>& q) {
  return line_across(NT(NT(1) / NT(2)) * (p + q), q - p);
}

template <class NT> [[nodiscard]] Xy<NT> intersection(const Line_figure<NT>& l, const Line_figure<NT>& m) {
  const NT d = l.a * m.b - m.a * l.b;
  return {NT((l.b * m.c - m.b * l.c) / d), NT((m.a * l.c - l.a * m.c) / d)};
}

template <class NT> [[nodiscard]] NT distance(const Xy<NT>& p, const Xy<NT>& q) {
  const Xy<NT> v = q - p;
  return square_root(dot(v, v));
}

template <class NT> [[nodiscard]] Xy<NT> unit_vector(const Xy<NT>& v) {
  const NT n = square_root(dot(v, v));
  return {NT(v.x / n), NT(v.y / n)};
}

/// The ends in the order tight, flat, with T pointing into the segment's direction and n towards the centers.
template <class NT> struct Textbook_ends {
  Xy<NT> tight, flat, tight_tangent, flat_tangent, tight_normal, flat_normal;
  NT tight_radius, flat_radius;
};

template <class NT> [[nodiscard]] Textbook_ends<NT> textbook_ends(const Chord_frame_2<NT>& frame) {
  const Chord_shape_2<NT>& f = frame.shape;
  const Xy<NT> u0 = unit_vector(f.tangent0), u1 = unit_vector(f.tangent1);
  const auto radius = [&](const NT& curvature, const Xy<NT>& t) {
    const NT n = square_root(dot(t, t));
    return NT(f.unit * n * n * n / (NT(2) * absolute(curvature)));
  };
  const NT turn = NT(f.turn);
  const NT r0 = radius(f.curvature0, f.tangent0), r1 = radius(f.curvature1, f.tangent1);
  if (f.tight_first) return {frame.p0, frame.p1, u0, u1, turn * perp(u0), turn * perp(u1), r0, r1};
  return {frame.p1, frame.p0, -u1, -u0, turn * perp(u1), turn * perp(u0), r1, r0};
}

/// The circle about a center through a point, run by a curve that turns left (+1) or right (-1).
template <class NT>
[[nodiscard]] Contact_circle_2<NT> circle_about(const Xy<NT>& center, const Xy<NT>& point, int turn) {
  return {point, NT(turn) * (center - point), NT(turn)};
}

/// tight end -> joint -> flat end, in the curve's direction.
template <class NT>
[[nodiscard]] Boundary_chain_2<NT> chain(const Chord_frame_2<NT>& frame, const Textbook_ends<NT>& e,
                                         const Xy<NT>& joint, const Contact_circle_2<NT>& at_tight,
                                         const Contact_circle_2<NT>& at_flat) {
  Tight_axes<NT> axes;
  axes.tight = e.tight;
  axes.flat = e.flat;
  return chain(frame, axes, joint, at_tight, at_flat);
}

/// Whether both osculating circles are circles: neither lines nor points, and of different radii.
template <class NT> [[nodiscard]] bool has_osculating_circles(const Chord_shape_2<NT>& f) {
  return f.proper && !f.infinite0 && !f.infinite1 && f.curvature0 != NT(0) && f.curvature1 != NT(0);
}

}  // namespace study
}  // namespace CGAL::Bounding_arcs

#endif
