// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The concept BoundingRegionTraits_2. Nothing here is to be included: test/consumer/concepts.cpp compiles the library
// over it, so that what is required is all that there is to require.

#ifndef BOUNDING_ARCS_CONCEPT_BOUNDING_REGION_TRAITS_2_H
#define BOUNDING_ARCS_CONCEPT_BOUNDING_REGION_TRAITS_2_H

#include <CGAL/Bounding_arcs_2/region/thickness_bound.h>
#include <CGAL/Simple_cartesian.h>
#include "Construction.h"

/// \cgalConcept
/// The kind of regions that Region_hierarchy_2, whose first argument it is, has at its nodes. Copyable.
///
/// The models offer more, which the tree does not use: Bounding_region_traits_2 has all functors.
/// \cgalHasModel{Bca_traits_2\, Spiral_fat_arc_traits_2\, Bilens_traits_2\, and Certified_traits_2 of one of them over
///   floating numbers}
struct BoundingRegionTraits_2 {
  /// A CGAL kernel over FT, whose points queries take and give. Its predicates decide what doubles leave open.
  using Kernel = CGAL::Simple_cartesian<double>;

  /// The number type of frames.
  using FT = double;

  /// The region. Copyable.
  struct Bounding_region_2 {};

  /// The kind of region as formulas, a model of Construction. Here only its constants and `thickness` are asked for.
  using Construction = ::Construction;

  BoundingRegionTraits_2();

  /// Returns the construction of all regions.
  [[nodiscard]] const Construction& construction() const;

  /// Makes regions.
  struct Construct_bounding_region_2 {
    Bounding_region_2 operator()(const CGAL::Bounding_arcs::Chord_frame_2<FT>& frame) const;
  };
  /// Decides.
  struct Bound_thickness_2 {
    /// Whether the thickness is at most eps, and a double that is at least the thickness.
    /// \param source a model of ChordShapeSource
    template <class Source> CGAL::Bounding_arcs::Thickness_bound operator()(const Source& source, double eps) const;
  };

  [[nodiscard]] Construct_bounding_region_2 construct_bounding_region_2_object() const;  ///< chord frame → region
  [[nodiscard]] Bound_thickness_2 bound_thickness_2_object() const;  ///< ChordShapeSource, eps → Thickness_bound
};

#endif
