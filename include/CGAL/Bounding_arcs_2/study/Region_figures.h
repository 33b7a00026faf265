// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The numbers that a region consists of, in one order for every formula, so that formulas can be compared.

#ifndef CGAL_BOUNDING_ARCS_2_STUDY_REGION_FIGURES_H
#define CGAL_BOUNDING_ARCS_2_STUDY_REGION_FIGURES_H

#include <CGAL/Bounding_arcs_2/frame/Chord_frame_2.h>
#include <CGAL/Bounding_arcs_2/number/stable_norm.h>
#include <CGAL/Bounding_arcs_2/region/Contact_circle_2.h>

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

}  // namespace CGAL::Bounding_arcs

#endif
