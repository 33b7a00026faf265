// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The concept SpiralSegment_2, see BoundingRegionTraits_2.h.

#ifndef BOUNDING_ARCS_CONCEPT_SPIRAL_SEGMENT_2_H
#define BOUNDING_ARCS_CONCEPT_SPIRAL_SEGMENT_2_H

#include <CGAL/Bounding_arcs_2/frame/Chord_frame_2.h>

/// \cgalConcept
/// A curve piece that is monotone in x, y, tangent angle and curvature, and the chord shapes of its parts: the second
/// argument of Region_hierarchy_2. Copyable.
///
/// The curve below a node is taken to lie in the box of its two end points, each widened by point_error(): monotony is
/// relied on. An eps below twice point_error() + cut_error() counts as not resolved. verify_region, outside_bound and
/// certified regions take Bezier_spiral_2 only.
/// \cgalHasModel{Bezier_spiral_2\, Jet_spiral_2}
struct SpiralSegment_2 {
  /// Passed on as that of a ChordShapeSource.
  using Exact_number_type = CGAL::Exact_rational;

  [[nodiscard]] double first() const;  ///< where the parameters begin
  [[nodiscard]] double last() const;   ///< where they end

  /// A point of some number type that converts to intervals; the same bits whichever piece asks.
  [[nodiscard]] CGAL::Bounding_arcs::Xy<double> point(double t) const;
  /// A bound of the error of a coordinate of point(), 0 for exact points.
  [[nodiscard]] double point_error() const;
  /// How far the curve may run beside the ends within the rounding of their parameters, or 0.
  [[nodiscard]] double cut_error() const;

  /// For the number types that a ChordShapeSource is asked for.
  template <class T>
  [[nodiscard]] CGAL::Bounding_arcs::Chord_shape_2<T> shape(double t0, double t1,
                                                            const CGAL::Bounding_arcs::Shape_parts& parts) const;
  /// For the number type of the traits.
  template <class T>
  [[nodiscard]] CGAL::Bounding_arcs::Chord_frame_2<T> frame(double t0, double t1,
                                                            const CGAL::Bounding_arcs::Shape_parts& parts) const;
};

#endif
