// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The paper's own steps (its section 3): lines intersected with lines, radii as distances, thickness as a sum and a
// difference of lengths, all from absolute points.  Constructions for the traits and for studies of their numerical
// stability; a thickness that is asked of a shape alone is computed with the start in the origin.

#ifndef CGAL_BOUNDING_ARCS_2_STUDY_TEXTBOOK_H
#define CGAL_BOUNDING_ARCS_2_STUDY_TEXTBOOK_H

#include <CGAL/Bounding_arcs_2/frame/Chord_frame_2.h>
#include <CGAL/Bounding_arcs_2/number/stable_norm.h>
#include <CGAL/Bounding_arcs_2/region/Bilens.h>
#include <CGAL/Bounding_arcs_2/region/Contact_circle_2.h>
#include <CGAL/Bounding_arcs_2/region/Spiral_fat_arc.h>
#include <CGAL/Bounding_arcs_2/region/Tight_axes.h>

#include <cmath>
#include <type_traits>
#include <vector>

namespace CGAL::Bounding_arcs {
namespace study {

// For floating types also where the square is out of range.
template <class NT> [[nodiscard]] NT length(const Xy<NT>& v) {
  if constexpr (std::is_floating_point_v<NT>) return stable_norm(v);
  else return square_root(dot(v, v));
}

}  // namespace study

/// a x + b y + c = 0
template <class NT> struct Line_figure { NT a, b, c; };

/// A circle of a region; center and radius mean nothing where it is a line.
template <class NT> struct Circle_figure {
  Xy<NT> center;
  NT radius{0};
  bool is_line = false;
  Xy<NT> normal = {};  ///< to the curve's left where the circle touches it, of any length
};

/// Circles, joints and the thickness of a region:
///   BCA      circles touching at the start and at the end; no joints
///   SFA      osculating circles at the tight and at the flat end; joints j (inner) and i (outer)
///   bilens   contact circles at the tight and at the flat end; joints of the inner and of the outer boundary
/// Where the curvature at the tight end is infinite the inner boundary is one piece, and a joint is missing; for SFA
/// the first circle is then the chord's line.
template <class NT> struct Region_figures {
  std::vector<Circle_figure<NT>> circles;
  std::vector<Xy<NT>> joints;
  NT thickness{0};
  Region_form form = Region_form::BCA;
  std::vector<Line_figure<NT>> bisectors = {};  ///< the lines that the construction intersects with normals, if any
};

/// The figures of a region from its boundary.
/// \pre the boundary has the form of one of the three methods
template <class NT>
[[nodiscard]] Region_figures<NT> region_figures(const Region_boundary_2<NT>& b, const NT& thickness, bool tight_first) {
  const auto at_tight = [&](const Boundary_chain_2<NT>& chain) {
    return chain[tight_first || chain.size() == 1 ? 0 : 1].support;
  };
  const auto at_flat = [&](const Boundary_chain_2<NT>& chain) {
    return chain[tight_first && chain.size() == 2 ? 1 : 0].support;
  };
  std::vector<Contact_circle_2<NT>> circles;
  if (b.form == Region_form::BCA)
    circles = {(tight_first ? b.outer : b.inner)[0].support, (tight_first ? b.inner : b.outer)[0].support};
  else if (b.form == Region_form::SPIRAL_FAT_ARC) circles = {at_tight(b.inner), at_flat(b.outer)};
  else circles = {at_tight(b.outer), at_flat(b.inner)};
  Region_figures<NT> figures;
  figures.form = b.form;
  figures.thickness = thickness;
  for (const Contact_circle_2<NT>& c : circles) {
    if (c.is_line()) figures.circles.push_back({{}, NT(0), true, c.normal});
    else
      figures.circles.push_back({c.center(),
                                 study::length(Xy<NT>{NT(c.normal.x / c.curvature), NT(c.normal.y / c.curvature)}),
                                 false, c.normal});
  }
  for (const Boundary_chain_2<NT>* chain : {&b.inner, &b.outer})
    if (chain->size() == 2) figures.joints.push_back((*chain)[0].to);
  return figures;
}

/// The figures of a construction of this library.
template <class Construction, class NT>
[[nodiscard]] Region_figures<NT> region_figures(const Construction& construction, const Chord_frame_2<NT>& frame) {
  return region_figures(construction.boundary(frame), NT(construction.thickness(frame.shape)), frame.shape.tight_first);
}

/// The figures that traits give over their kernel.
template <class Traits>
[[nodiscard]] Region_figures<typename Traits::FT> region_figures_of_traits(
    const Traits& traits, const Chord_frame_2<typename Traits::FT>& frame) {
  const auto region = traits.construct_bounding_region_2_object()(frame);
  return region_figures(traits.construct_region_boundary_2_object()(region),
                        traits.compute_thickness_2_object()(region), frame.shape.tight_first);
}

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
  internal::Tight_axes<NT> axes;
  axes.tight = e.tight;
  axes.flat = e.flat;
  return chain(frame, axes, joint, at_tight, at_flat);
}

/// Whether both osculating circles are circles: neither lines nor points, and of different radii.
template <class NT> [[nodiscard]] bool has_osculating_circles(const Chord_shape_2<NT>& f) {
  return f.proper && !f.infinite0 && !f.infinite1 && f.curvature0 != NT(0) && f.curvature1 != NT(0);
}

}  // namespace study

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
  template <class NT> [[nodiscard]] static NT thickness(const Chord_shape_2<NT>& f) { return thickness(f.at_origin()); }
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
  template <class NT> [[nodiscard]] static NT thickness(const Chord_shape_2<NT>& f) { return thickness(f.at_origin()); }
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
