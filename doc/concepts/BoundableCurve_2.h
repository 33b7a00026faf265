// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The concept BoundableCurve_2, see BoundingRegionTraits_2.h.

#ifndef BOUNDING_ARCS_CONCEPT_BOUNDABLE_CURVE_2_H
#define BOUNDING_ARCS_CONCEPT_BOUNDABLE_CURVE_2_H

#include <CGAL/Bounding_arcs_2/frame/Chord_frame_2.h>

/// \cgalConcept
/// A curve over `double` that tells its derivatives: the argument of Jet_spiral_2, which makes a spiral segment of it.
/// Copyable. A clothoid is the example own_curve.cpp.
///
/// The caller answers for [first, last] being a spiral. Chord differences are taken between two jets, so short pieces
/// lose digits; the error bound follows, and a tree ends in `RESOLUTION_REACHED` rather than with wrong thicknesses.
/// There is no exact form of such a curve: use a kernel over `Simple_cartesian` of a floating type.
struct BoundableCurve_2 {
  /// The point and the first two derivatives at t. `first` is not zero, and may be the derivative by any parameter that
  /// runs the same way, also another one at every t; `second` is the second one by that same parameter, and is used
  /// for spiral fat arcs and bilens only.
  [[nodiscard]] CGAL::Bounding_arcs::End_jet_2<double> jet(double t) const;
};

#endif
