// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The concept Construction, see BoundingRegionTraits_2.h.

#ifndef BOUNDING_ARCS_CONCEPT_CONSTRUCTION_H
#define BOUNDING_ARCS_CONCEPT_CONSTRUCTION_H

#include <CGAL/Bounding_arcs_2/region/Arc_region_2.h>
#include <CGAL/Bounding_arcs_2/region/Kernel_boundary.h>

/// \cgalConcept
/// A kind of region as formulas of the chord frame: all that there is to write for a new one, as
/// Bounding_region_traits_2 makes traits of it. Copyable. Its functions may be static.
///
/// `thickness` is called with the kernel's number type, `Bounded_double`, `Double_double`, `CGAL::Interval_nt<true>`,
/// `CORE::Expr` or a number of its kind (with the same operators and CGAL's traits), and exact types with square
/// roots; with intervals a comparison may throw `CGAL::Uncertain_conversion_exception`, which the caller handles.
/// Where lines and arcs have regions of another form it has a member NEEDS_CERTAIN_TURN, true: rounding does not tell
/// them apart then.
/// \cgalHasModel{Bca\, Spiral_fat_arc\, Bilens\, the fallbacks Near_linear_to_chord and Near_circular_to_bca\, and for
///   studies the paper's own steps\, Textbook_bca\, Textbook_spiral_fat_arc and Textbook_bilens\, and
///   Three_point_fat_arc\, Fat_biarc\, Axis_box\, Oriented_box and Control_hull}
struct Construction {
  static constexpr const char* NAME = "construction";        ///< a short name, which studies of stability print
  static constexpr int ARCS_PER_REGION = 2;                  ///< for counting arcs
  static constexpr bool NEEDS_CURVATURE = true;              ///< whether curvatures of a chord shape are wanted
  static constexpr bool NEEDS_CONTROL_POINTS = true;         ///< whether control points of a chord shape are wanted
  static constexpr bool BOUNDARY_NEEDS_SQUARE_ROOT = false;  ///< true: without, there is no Region_boundary_2

  /// At least the distance from any point of one boundary to the other one, in units of the coordinates.
  template <class NT> NT thickness(const CGAL::Bounding_arcs::Chord_shape_2<NT>& shape) const;

  /// Both boundaries, from the start of the piece to its end; or a Region_outline_2 of them.
  template <class NT>
  CGAL::Bounding_arcs::Region_boundary_2<NT> boundary(const CGAL::Bounding_arcs::Chord_frame_2<NT>& frame) const;

  /// Both boundaries as arcs and segments of the kernel, over number types without square roots; wanted only where
  /// BOUNDARY_NEEDS_SQUARE_ROOT, and by Construct_boundary_2 only. The `deviation` of its pieces stays 0.
  template <class Kernel, class FT>
  CGAL::Bounding_arcs::Kernel_boundary_2<Kernel> algebraic_boundary(
      const CGAL::Bounding_arcs::Chord_frame_2<FT>& frame) const;
};

#endif
