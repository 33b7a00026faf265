// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The numbers that a region consists of, in one order for every formula, so that formulas can be compared.

#ifndef CGAL_BOUNDING_ARCS_2_REGION_REGION_FIGURES_H
#define CGAL_BOUNDING_ARCS_2_REGION_REGION_FIGURES_H

#include <CGAL/Bounding_arcs_2/region/Contact_circle_2.h>
#include <CGAL/Bounding_arcs_2/spiral/Chord_frame_2.h>

#include <cstddef>
#include <vector>

namespace CGAL::Bounding_arcs {

/// Two circles, two joints and the thickness of a region:
///   BCA      circles touching at the start and at the end; no joints
///   SFA      osculating circles at the tight and at the flat end; joints j (inner) and i (outer)
///   bilens   contact circles at the tight and at the flat end; joints of the inner and of the outer boundary
template <class NT>
struct Region_figures {
  std::vector<Xy<NT>> centers;
  std::vector<NT> radii;
  std::vector<Xy<NT>> joints;
  NT thickness{0};
  Region_form form = Region_form::BCA;
};

/// The figures of a region from its boundary and thickness, as the constructions of this library make them.
/// \pre no circle of the region is a line, and the construction did not step back to another form
template <class Construction, class NT>
[[nodiscard]] Region_figures<NT> region_figures(const Construction& construction, const Chord_frame_2<NT>& frame) {
  const Region_boundary_2<NT> b = construction.boundary(frame);
  const bool first = frame.shape.tight_first;
  const auto at_tight = [&](const Boundary_chain_2<NT>& chain) { return chain[first || chain.size() == 1 ? 0 : 1].support; };
  const auto at_flat = [&](const Boundary_chain_2<NT>& chain) { return chain[first && chain.size() == 2 ? 1 : 0].support; };
  std::vector<Contact_circle_2<NT>> circles;
  if (b.form == Region_form::BCA) circles = {first ? at_tight(b.outer) : at_flat(b.inner), first ? at_flat(b.inner) : at_tight(b.outer)};
  else if (b.form == Region_form::SPIRAL_FAT_ARC) circles = {at_tight(b.inner), at_flat(b.outer)};
  else circles = {at_tight(b.outer), at_flat(b.inner)};
  Region_figures<NT> figures;
  figures.form = b.form;
  for (const Contact_circle_2<NT>& c : circles) {
    figures.centers.push_back(c.center());
    figures.radii.push_back(NT(internal::square_root(dot(c.normal, c.normal)) / internal::absolute(c.curvature)));
  }
  if (b.form != Region_form::BCA) figures.joints = {b.inner[0].to, b.outer[0].to};
  figures.thickness = construction.thickness(frame.shape);
  return figures;
}

}  // namespace CGAL::Bounding_arcs

#endif
