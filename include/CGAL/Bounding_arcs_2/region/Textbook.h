// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The paper's own steps (its section 3): lines intersected with lines, radii as distances, thickness as a sum and a
// difference of lengths, all from absolute points.  For studies of their numerical stability; nothing else uses them.

#ifndef CGAL_BOUNDING_ARCS_2_REGION_TEXTBOOK_H
#define CGAL_BOUNDING_ARCS_2_REGION_TEXTBOOK_H

#include <CGAL/Bounding_arcs_2/region/Region_figures.h>

namespace CGAL::Bounding_arcs {
namespace internal {

/// a x + b y + c = 0
template <class NT>
struct Textbook_line {
  NT a, b, c;
};

template <class NT>
[[nodiscard]] Textbook_line<NT> line_across(const Xy<NT>& point, const Xy<NT>& normal) {
  return {normal.x, normal.y, NT(-dot(normal, point))};
}

template <class NT>
[[nodiscard]] Textbook_line<NT> bisector(const Xy<NT>& p, const Xy<NT>& q) {
  return line_across(NT(NT(1) / NT(2)) * (p + q), q - p);
}

template <class NT>
[[nodiscard]] Xy<NT> intersection(const Textbook_line<NT>& l, const Textbook_line<NT>& m) {
  const NT d = l.a * m.b - m.a * l.b;
  return {NT((l.b * m.c - m.b * l.c) / d), NT((m.a * l.c - l.a * m.c) / d)};
}

template <class NT>
[[nodiscard]] NT distance(const Xy<NT>& p, const Xy<NT>& q) {
  const Xy<NT> v = q - p;
  return square_root(dot(v, v));
}

template <class NT>
[[nodiscard]] Xy<NT> unit_vector(const Xy<NT>& v) {
  const NT n = square_root(dot(v, v));
  return {NT(v.x / n), NT(v.y / n)};
}

/// The ends in the order tight, flat, with T pointing into the segment's direction and n towards the centres.
template <class NT>
struct Textbook_ends {
  Xy<NT> tight, flat, tight_tangent, flat_tangent, tight_normal, flat_normal;
  NT tight_radius, flat_radius;
};

template <class NT>
[[nodiscard]] Textbook_ends<NT> textbook_ends(const Chord_frame_2<NT>& frame) {
  const Chord_shape_2<NT>& f = frame.shape;
  const Xy<NT> u0 = unit_vector(f.tangent0), u1 = unit_vector(f.tangent1);
  const auto radius = [&](const NT& curvature, const Xy<NT>& t) {
    const NT n = square_root(dot(t, t));
    return NT(f.unit * n * n * n / (NT(2) * absolute(curvature)));
  };
  const NT turn(f.turn);
  const NT r0 = radius(f.curvature0, f.tangent0), r1 = radius(f.curvature1, f.tangent1);
  if (f.tight_first) return {frame.p0, frame.p1, u0, u1, turn * perp(u0), turn * perp(u1), r0, r1};
  return {frame.p1, frame.p0, -u1, -u0, turn * perp(u1), turn * perp(u0), r1, r0};
}

}  // namespace internal

/// Section 3.1: normals and the chord's bisector intersected.
struct Textbook_bca {
  static constexpr const char* NAME = "bca";
  template <class NT>
  [[nodiscard]] static Region_figures<NT> figures(const Chord_frame_2<NT>& frame) {
    const auto middle = internal::bisector(frame.p0, frame.p1);
    const Xy<NT> z0 = internal::intersection(internal::line_across(frame.p0, frame.shape.tangent0), middle);
    const Xy<NT> z1 = internal::intersection(internal::line_across(frame.p1, frame.shape.tangent1), middle);
    const NT r0 = internal::distance(z0, frame.p0), r1 = internal::distance(z1, frame.p1);
    const NT gap = internal::distance(z0, z1);
    const NT thickness = frame.shape.tight_first ? NT(r0 + gap - r1) : NT(r1 + gap - r0);
    return {{z0, z1}, {r0, r1}, {}, thickness, Region_form::BCA};
  }
};

/// Section 3.2: distances, similar triangles and a projection.
struct Textbook_spiral_fat_arc {
  static constexpr const char* NAME = "sfa";
  template <class NT>
  [[nodiscard]] static Region_figures<NT> figures(const Chord_frame_2<NT>& frame) {
    using internal::distance;
    const auto e = internal::textbook_ends(frame);
    const Xy<NT> z = e.tight + e.tight_radius * e.tight_normal, c = e.flat + e.flat_radius * e.flat_normal;
    const NT r = e.tight_radius, d = distance(z, e.flat), l = internal::square_root(NT(d * d - r * r));
    const Xy<NT> back = z - e.flat, foot = e.flat + NT(l * l / (d * d)) * back;
    const NT side(cross(e.tight_tangent, e.tight_normal) > NT(0) ? 1 : -1);
    const Xy<NT> j = foot + NT(side * l * r / (d * d)) * perp(back);
    const Xy<NT> from_center = e.tight - c;
    const Xy<NT> p = e.tight - dot(from_center, e.tight_tangent) * e.tight_tangent;
    const NT height = distance(c, p), run = internal::square_root(NT(e.flat_radius * e.flat_radius - height * height));
    const Xy<NT> i = p + run * e.tight_tangent;
    NT thickness = distance(i, z) - r;
    // the outer arc over the inner segment, where it has a tangent parallel to it
    const Xy<NT> line = internal::unit_vector(e.flat - j);
    const NT start = cross(line, perp(i - c));  // the arc's first tangent against the segment; its last turns inwards
    const NT deviation = e.flat_radius - NT(side * cross(line, c - j));
    if (start < NT(0) && thickness < deviation) thickness = deviation;
    return {{z, c}, {r, e.flat_radius}, {j, i}, thickness, Region_form::SPIRAL_FAT_ARC};
  }
};

/// Section 3.3: the auxiliary points z' and c', bisectors and normals intersected.
struct Textbook_bilens {
  static constexpr const char* NAME = "bilens";
  template <class NT>
  [[nodiscard]] static Region_figures<NT> figures(const Chord_frame_2<NT>& frame) {
    using internal::distance;
    const auto e = internal::textbook_ends(frame);
    const Xy<NT> z = e.tight + e.tight_radius * e.tight_normal, c = e.flat + e.flat_radius * e.flat_normal;
    const Xy<NT> z_mark = e.flat + e.tight_radius * e.flat_normal, c_mark = e.tight + e.flat_radius * e.tight_normal;
    const Xy<NT> z_bar = internal::intersection(internal::bisector(z, z_mark), internal::line_across(e.flat, e.flat_tangent));
    const Xy<NT> c_bar = internal::intersection(internal::bisector(c, c_mark), internal::line_across(e.tight, e.tight_tangent));
    const NT inner = distance(z_bar, e.flat), outer = distance(c_bar, e.tight);
    const Xy<NT> inner_joint = z_bar + inner * internal::unit_vector(z - z_bar);
    const Xy<NT> outer_joint = c + e.flat_radius * internal::unit_vector(c_bar - c);
    return {{c_bar, z_bar}, {outer, inner}, {inner_joint, outer_joint}, NT(outer + distance(c_bar, z_bar) - inner), Region_form::BILENS};
  }
};

}  // namespace CGAL::Bounding_arcs

#endif
