// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The concept PieceDecider, see BoundingRegionTraits_2.h.

#ifndef BOUNDING_ARCS_CONCEPT_PIECE_DECIDER_H
#define BOUNDING_ARCS_CONCEPT_PIECE_DECIDER_H

#include <CGAL/Bounding_arcs_2/tree/subdivide.h>
#include "BoundingRegionTraits_2.h"
#include "SpiralSegment_2.h"

#include <cstddef>
#include <cstdint>
#include <vector>

/// \cgalConcept
/// Who decides which pieces are too thick: the third argument of Bounding_arc_tree_2. All models make the same tree.
/// Copyable; each thread has a copy of its own.
/// One piece after the other is decided by Plain_decider with the functor of the traits, many at a time by
/// filter::Filtered_decider, the default where the filter serves traits and segments.
/// \cgalHasModel{Plain_decider\, filter::Filtered_decider}
struct PieceDecider {
  PieceDecider(const BoundingRegionTraits_2& traits, CGAL::Bounding_arcs::Instruction_set set);

  /// Tells which segments subdivide is called for next: first[0], ..., first[count - 1], for the same eps. What is
  /// decided of them together saves time and changes no node.
  /// \param keeps_thickness of the nodes that are to be appended to
  void look_ahead(const SpiralSegment_2* first, std::size_t count, double eps, bool keeps_thickness);
  /// Appends the nodes of a halved segment, see subdivide().
  [[nodiscard]] CGAL::Bounding_arcs::Subdivision subdivide(const SpiralSegment_2& spiral, double eps, std::size_t limit,
                                                           CGAL::Bounding_arcs::Region_nodes& nodes,
                                                           CGAL::Bounding_arcs::Decision_counts& counts);
  /// Which of the pieces place and, for `count` 2, place + 1 of a level are thicker than eps, a bit each.
  [[nodiscard]] unsigned are_thick(const SpiralSegment_2& spiral, int level, std::uint64_t place, unsigned count,
                                   double eps) const;
  /// Sets the measures of the pieces between breaks, see thickness_measure().
  void measure(const SpiralSegment_2& spiral, double eps, const std::vector<double>& breaks,
               std::vector<double>& measures, CGAL::Bounding_arcs::Decision_counts& counts) const;
};

#endif
