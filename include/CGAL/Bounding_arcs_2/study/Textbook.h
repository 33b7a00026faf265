// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The paper's own steps (its section 3): lines intersected with lines, radii as distances, thickness as a sum and a
// difference of lengths, all from absolute points.  Constructions for the traits and for studies of their numerical
// stability; a thickness that is asked of a shape alone is computed with the start in the origin.

#ifndef CGAL_BOUNDING_ARCS_2_STUDY_TEXTBOOK_H
#define CGAL_BOUNDING_ARCS_2_STUDY_TEXTBOOK_H

#include <CGAL/Bounding_arcs_2/region/Bilens.h>
#include <CGAL/Bounding_arcs_2/region/Spiral_fat_arc.h>
#include <CGAL/Bounding_arcs_2/study/Region_figures.h>
#include <CGAL/Bounding_arcs_2/study/internal/textbook_steps.h>

namespace CGAL::Bounding_arcs {

/// Section 3.1: normals and the chord's bisector intersected.  Straight pieces are left to Bca.
struct Textbook_bca {
  static constexpr const char* NAME = Bca::NAME;
  static constexpr int ARCS_PER_REGION = Bca::ARCS_PER_REGION;
  static constexpr bool NEEDS_CURVATURE = Bca::NEEDS_CURVATURE;
  static constexpr bool NEEDS_CONTROL_POINTS = Bca::NEEDS_CONTROL_POINTS;
  static constexpr bool BOUNDARY_NEEDS_SQUARE_ROOT = Bca::BOUNDARY_NEEDS_SQUARE_ROOT;
  static constexpr bool HAS_BISECTORS = true;

  template <class NT> [[nodiscard]] static Region_figures<NT> figures(const Chord_frame_2<NT>& frame) {
    const Centers<NT> z = centers(frame);
    const NT r0 = study::distance(z.start, frame.p0), r1 = study::distance(z.end, frame.p1);
    const NT gap = study::distance(z.start, z.end);
    const NT thickness = frame.shape.tight_first ? NT(r0 + gap - r1) : NT(r1 + gap - r0);
    return {{{z.start, r0, false, perp(frame.shape.tangent0)}, {z.end, r1, false, perp(frame.shape.tangent1)}},
            {},
            thickness,
            Region_form::BCA,
            {z.middle}};
  }
  template <class NT> [[nodiscard]] static NT thickness(const Chord_frame_2<NT>& frame) {
    return frame.shape.turns_one_way ? figures(frame).thickness : Bca::thickness(frame.shape);
  }
  template <class NT> [[nodiscard]] static NT thickness(const Chord_shape_2<NT>& f) {
    return thickness(frame_at_origin(f));
  }
  template <class NT> [[nodiscard]] static Region_boundary_2<NT> boundary(const Chord_frame_2<NT>& frame) {
    const Chord_shape_2<NT>& f = frame.shape;
    if (!f.turns_one_way) return Bca::boundary(frame);
    const Centers<NT> z = centers(frame);
    const Boundary_chain_2<NT> at_start({frame.p0, frame.p1, study::circle_about(z.start, frame.p0, f.turn)});
    const Boundary_chain_2<NT> at_end({frame.p0, frame.p1, study::circle_about(z.end, frame.p1, f.turn)});
    return f.tight_first ? Region_boundary_2<NT>{at_end, at_start, Region_form::BCA}
                         : Region_boundary_2<NT>{at_start, at_end, Region_form::BCA};
  }

 private:
  template <class NT> struct Centers {
    Xy<NT> start, end;
    Line_figure<NT> middle;
  };
  template <class NT> [[nodiscard]] static Centers<NT> centers(const Chord_frame_2<NT>& frame) {
    const auto middle = study::bisector(frame.p0, frame.p1);
    return {study::intersection(study::line_across(frame.p0, frame.shape.tangent0), middle),
            study::intersection(study::line_across(frame.p1, frame.shape.tangent1), middle), middle};
  }
};

namespace study {

/// What the two constructions from osculating circles share; they step back to Textbook_bca where those are not there.
/// Method has figures() and boundary_of(frame, ends, figures).
template <class Method, class Stable> struct Textbook_osculating {
  static constexpr const char* NAME = Stable::NAME;
  static constexpr int ARCS_PER_REGION = Stable::ARCS_PER_REGION;
  static constexpr bool NEEDS_CURVATURE = Stable::NEEDS_CURVATURE;
  static constexpr bool NEEDS_CONTROL_POINTS = Stable::NEEDS_CONTROL_POINTS;
  static constexpr bool BOUNDARY_NEEDS_SQUARE_ROOT = Stable::BOUNDARY_NEEDS_SQUARE_ROOT;

  template <class NT> [[nodiscard]] static NT thickness(const Chord_frame_2<NT>& frame) {
    return has_osculating_circles(frame.shape) ? Method::figures(frame).thickness : Textbook_bca::thickness(frame);
  }
  template <class NT> [[nodiscard]] static NT thickness(const Chord_shape_2<NT>& f) {
    return thickness(frame_at_origin(f));
  }
  template <class NT> [[nodiscard]] static Region_boundary_2<NT> boundary(const Chord_frame_2<NT>& frame) {
    if (!has_osculating_circles(frame.shape)) return Textbook_bca::boundary(frame);
    return Method::boundary_of(frame, textbook_ends(frame), Method::figures(frame));
  }
};

}  // namespace study

/// Section 3.2: distances, similar triangles and a projection.
struct Textbook_spiral_fat_arc : study::Textbook_osculating<Textbook_spiral_fat_arc, Spiral_fat_arc> {
  static constexpr bool HAS_BISECTORS = false;
  template <class NT> [[nodiscard]] static Region_figures<NT> figures(const Chord_frame_2<NT>& frame) {
    using study::distance;
    const auto e = study::textbook_ends(frame);
    const Xy<NT> z = e.tight + e.tight_radius * e.tight_normal, c = e.flat + e.flat_radius * e.flat_normal;
    const NT r = e.tight_radius, d = distance(z, e.flat), l = square_root(NT(d * d - r * r));
    const Xy<NT> back = z - e.flat, foot = e.flat + NT(l * l / (d * d)) * back;
    const NT side(cross(e.tight_tangent, e.tight_normal) > NT(0) ? 1 : -1);
    const Xy<NT> j = foot + NT(side * l * r / (d * d)) * perp(back);
    const Xy<NT> from_center = e.tight - c;
    const Xy<NT> p = e.tight - dot(from_center, e.tight_tangent) * e.tight_tangent;
    const NT height = distance(c, p), run = square_root(NT(e.flat_radius * e.flat_radius - height * height));
    const Xy<NT> i = p + run * e.tight_tangent;
    NT thickness = distance(i, z) - r;
    // the outer arc over the inner segment, where it has a tangent parallel to it
    const Xy<NT> line = study::unit_vector(e.flat - j);
    const NT start = cross(line, perp(i - c));  // the arc's first tangent against the segment; its last turns inwards
    const NT deviation = e.flat_radius - NT(side * cross(line, c - j));
    if (start < NT(0) && thickness < deviation) thickness = deviation;
    const NT left(frame.shape.turn);
    return {{{z, r, false, left * e.tight_normal}, {c, e.flat_radius, false, left * e.flat_normal}},
            {j, i},
            thickness,
            Region_form::SPIRAL_FAT_ARC};
  }
  template <class NT>
  [[nodiscard]] static Region_boundary_2<NT> boundary_of(const Chord_frame_2<NT>& frame,
                                                         const study::Textbook_ends<NT>& e,
                                                         const Region_figures<NT>& g) {
    const int turn = frame.shape.turn;
    const Xy<NT> segment = frame.shape.tight_first ? e.flat - g.joints[0] : g.joints[0] - e.flat;
    const auto inner = chain<NT>(frame, e, g.joints[0], study::circle_about(g.circles[0].center, e.tight, turn),
                                 {e.flat, perp(segment), NT(0)});
    const auto outer = chain<NT>(frame, e, g.joints[1], {e.tight, NT(turn) * e.tight_normal, NT(0)},
                                 study::circle_about(g.circles[1].center, e.flat, turn));
    return {inner, outer, Region_form::SPIRAL_FAT_ARC};
  }
};

/// Section 3.3: the auxiliary points z' and c', bisectors and normals intersected.
struct Textbook_bilens : study::Textbook_osculating<Textbook_bilens, Bilens> {
  static constexpr bool HAS_BISECTORS = true;
  template <class NT> [[nodiscard]] static Region_figures<NT> figures(const Chord_frame_2<NT>& frame) {
    using study::distance;
    const auto e = study::textbook_ends(frame);
    const Xy<NT> z = e.tight + e.tight_radius * e.tight_normal, c = e.flat + e.flat_radius * e.flat_normal;
    const Xy<NT> z_mark = e.flat + e.tight_radius * e.flat_normal, c_mark = e.tight + e.flat_radius * e.tight_normal;
    const Line_figure<NT> from_z = study::bisector(z, z_mark), from_c = study::bisector(c, c_mark);
    const Xy<NT> z_bar = study::intersection(from_z, study::line_across(e.flat, e.flat_tangent));
    const Xy<NT> c_bar = study::intersection(from_c, study::line_across(e.tight, e.tight_tangent));
    const NT inner = distance(z_bar, e.flat), outer = distance(c_bar, e.tight);
    const Xy<NT> inner_joint = z_bar + inner * study::unit_vector(z - z_bar);
    const Xy<NT> outer_joint = c + e.flat_radius * study::unit_vector(c_bar - c);
    const NT left(frame.shape.turn);
    return {{{c_bar, outer, false, left * e.tight_normal}, {z_bar, inner, false, left * e.flat_normal}},
            {inner_joint, outer_joint},
            NT(outer + distance(c_bar, z_bar) - inner),
            Region_form::BILENS,
            {from_c, from_z}};
  }
  template <class NT>
  [[nodiscard]] static Region_boundary_2<NT> boundary_of(const Chord_frame_2<NT>& frame,
                                                         const study::Textbook_ends<NT>& e,
                                                         const Region_figures<NT>& g) {
    const auto circle = [&](const Xy<NT>& center, const Xy<NT>& point) {
      return study::circle_about(center, point, frame.shape.turn);
    };
    const Xy<NT> z = e.tight + e.tight_radius * e.tight_normal, c = e.flat + e.flat_radius * e.flat_normal;
    return {chain(frame, e, g.joints[0], circle(z, e.tight), circle(g.circles[1].center, e.flat)),
            chain(frame, e, g.joints[1], circle(g.circles[0].center, e.tight), circle(c, e.flat)), Region_form::BILENS};
  }
};

}  // namespace CGAL::Bounding_arcs

#endif
