// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Decides pieces one by one, by the traits' functor: what a tree does without a filter.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_PLAIN_DECIDER_H
#define CGAL_BOUNDING_ARCS_2_TREE_PLAIN_DECIDER_H

#include <CGAL/Bounding_arcs_2/tree/subdivide.h>
#include <CGAL/Bounding_arcs_2/tree/thickness_measure.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

/// A model of PieceDecider (doc/concepts.md).
template <class Traits, class Spiral> class Plain_decider {
 public:
  Plain_decider(const Traits& traits, Instruction_set)
      : bound_(traits.bound_thickness_2_object()), measure_bound_(traits) {}

  /// Does nothing, as each segment is decided by itself.
  void look_ahead(const Spiral*, std::size_t, double, bool) {}
  /// Appends a segment's subtree, see Bounding_arcs::subdivide.
  [[nodiscard]] Subdivision subdivide(const Spiral& spiral, double eps, std::size_t limit, Region_nodes& nodes,
                                      Decision_counts& counts) {
    return Bounding_arcs::subdivide(bound_, spiral, eps, limit, nodes, counts);
  }

  /// Whether pieces place and, for `count` 2, place + 1 of a level are thicker than eps, a bit each.
  [[nodiscard]] unsigned are_thick(const Spiral& spiral, int level, std::uint64_t place, unsigned count,
                                   double eps) const {
    const Spiral_grid grid(spiral.first(), spiral.last());
    unsigned above = 0;
    for (unsigned i = 0; i < count; ++i) {
      const double t0 = grid.parameter(level, place + i), t1 = grid.parameter(level, place + i + 1);
      if (!bound_(Piece_source<Spiral>{spiral, t0, t1}, eps).within) above |= 1U << i;
    }
    return above;
  }

  /// Sets the measures of the pieces between breaks, see thickness_measure.
  void measure(const Spiral& spiral, double eps, const std::vector<double>& breaks, std::vector<double>& measures,
               Decision_counts& counts) const {
    measures.resize(breaks.size() - 1);
    for (std::size_t i = 0; i < measures.size(); ++i) {
      const Piece_source<Spiral> piece{spiral, breaks[i], breaks[i + 1]};
      const Thickness_bound thickness = measure_bound_(piece, eps);
      ++(thickness.was_exact ? counts.exact : counts.bounded);
      measures[i] = thickness_measure(thickness.upper, piece, eps, measure_bound_);
    }
  }

 private:
  decltype(std::declval<const Traits&>().bound_thickness_2_object()) bound_;
  Measure_bound<Traits> measure_bound_;
};

}  // namespace CGAL::Bounding_arcs

#endif
