// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The concept ChordShapeSource, see BoundingRegionTraits_2.h.

#ifndef BOUNDING_ARCS_CONCEPT_CHORD_SHAPE_SOURCE_H
#define BOUNDING_ARCS_CONCEPT_CHORD_SHAPE_SOURCE_H

#include <CGAL/Bounding_arcs_2/frame/Chord_frame_2.h>

/// \cgalConcept
/// One curve piece that can tell its chord shape over several number types: what `bound_thickness_2_object()` of
/// BoundingRegionTraits_2 is asked about. The tree wraps each piece of a SpiralSegment_2 in one.
/// \cgalHasModel{Piece_source}
struct ChordShapeSource {
  /// A type with exact field operations and comparisons, asked for over kernels that are not floating and for exact
  /// decisions only. `Bounded_double` says that there is no exact form.
  using Exact_number_type = CGAL::Exact_rational;

  /// For NT = `Bounded_double` under floating kernels, and for Exact_number_type.
  ///
  /// The members `square_change`, `sine_change`, `turn`, `turns_one_way`, `tight_first` and `proper` of a shape are set
  /// by `orient(shape)` from the others.
  /// \param parts whether curvatures and control points are wanted; other members are always filled in
  template <class NT>
  [[nodiscard]] CGAL::Bounding_arcs::Chord_shape_2<NT> shape(const CGAL::Bounding_arcs::Shape_parts& parts) const;
};

#endif
