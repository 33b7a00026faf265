// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Decides pieces in batches where construction, number type and segment have them, and piece by piece where these leave
// a piece open.  Nodes and breaks are those of Plain_decider.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_INTERNAL_BATCH_FILTERED_DECIDER_H
#define CGAL_BOUNDING_ARCS_2_TREE_INTERNAL_BATCH_FILTERED_DECIDER_H

#include <CGAL/Bounding_arcs_2/tree/Plain_decider.h>
#include <CGAL/Bounding_arcs_2/tree/internal/batch/Formulas.h>
#include <CGAL/Bounding_arcs_2/tree/internal/batch/Level_strategy.h>
#include <CGAL/Bounding_arcs_2/tree/internal/batch/Piece_decisions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::filter {

template <class Spiral, class = void> inline constexpr bool has_local_curve_v = false;
template <class Spiral>
inline constexpr bool has_local_curve_v<Spiral, std::void_t<decltype(std::declval<const Spiral&>().local_curve())>> =
    true;

/// Whether there are formulas for batches of the traits' regions, and local forms of the segments.
template <class Traits, class Spiral>
inline constexpr bool serves_v =
    has_local_curve_v<Spiral> && !std::is_void_v<typename Formulas<typename Traits::Construction>::Type>;

/// A model of PieceDecider (doc/concepts.md). Subtrees of halved segments are made by the filter over double only, as
/// exact kernels are to be what the algorithm says; measures, which decide nothing, over all number types.
template <class Traits, class Spiral> class Filtered_decider {
  static constexpr bool IS_DOUBLE = std::is_same_v<typename Traits::FT, double>;
  using Bound = decltype(std::declval<const Traits&>().bound_thickness_2_object());

 public:
  Filtered_decider(const Traits& traits, Instruction_set set)
      : plain_(traits, set), bound_(traits.bound_thickness_2_object()), measure_bound_(traits),
        functions_(Batch_functions::template of<typename Formulas<typename Traits::Construction>::Type>(set)) {}

  /// Tells which segments subdivide is called for next: what is to be decided of them together.
  void look_ahead(const Spiral* first, std::size_t count, double eps, bool keeps_thickness) {
    if constexpr (IS_DOUBLE) ahead_.decide(functions_, first, count, eps, keeps_thickness);
  }
  [[nodiscard]] Subdivision subdivide(const Spiral& spiral, double eps, std::size_t limit, Region_nodes& nodes,
                                      Decision_counts& counts) {
    if constexpr (IS_DOUBLE) {
      const Segment_top top = ahead_.top(spiral);
      const Subdivision begun = levels_.begin(top, nodes, counts);
      if (levels_.is_done()) return {begun.bound, nodes.size() > limit};
      Piece_decisions<Bound, Spiral> decide(bound_, functions_, spiral);
      if (decide.has_batches()) return levels_.finish(decide, top, eps, limit, nodes, counts);
    }
    return plain_.subdivide(spiral, eps, limit, nodes, counts);
  }

  [[nodiscard]] unsigned are_thick(const Spiral& spiral, int level, std::uint64_t place, unsigned count,
                                   double eps) const {
    if constexpr (IS_DOUBLE) {
      const Local_curve curve = spiral.local_curve();
      if (const Bound_function bound = functions_.of_one(curve)) {
        const Spiral_grid grid(spiral.first(), spiral.last());
        unsigned thick = 0;
        for (unsigned i = 0; i < count; ++i) {
          const double begin = grid.parameter(level, place + i), end = grid.parameter(level, place + i + 1);
          const Bracket b = bound(curve, begin, end, eps, level <= LAST_LONG_LEVEL);
          if (b.lower > eps || (!(b.upper <= eps) && !bound_(Piece_source<Spiral>{spiral, begin, end}, eps).within))
            thick |= 1U << i;
        }
        return thick;
      }
    }
    return plain_.are_thick(spiral, level, place, count, eps);
  }

  void measure(const Spiral& spiral, double eps, const std::vector<double>& breaks, std::vector<double>& measures,
               Decision_counts& counts) const {
    Piece_decisions<Measure_bound<Traits>, Spiral> decide(measure_bound_, functions_, spiral);
    if (!decide.has_batches()) return plain_.measure(spiral, eps, breaks, measures, counts);
    constexpr std::size_t LONG = 8;  // pieces of a segment: fewer are likely to turn by too much for narrow forms
    const std::size_t count = breaks.size() - 1;
    measures.resize((count + BATCH_SIZE - 1) / BATCH_SIZE * BATCH_SIZE);
    for (std::size_t i = 0; i < count; i += BATCH_SIZE) {
      Batch_pieces pieces = Batch_pieces::between(breaks.data() + i, (std::min)(count - i, BATCH_SIZE));
      pieces.are_long = count <= LONG;
      static_cast<void>(decide(pieces, eps, measures.data() + i, counts));
    }
    measures.resize(count);
    for (std::size_t i = 0; i < count; ++i)
      measures[i] =
          thickness_measure(measures[i], Piece_source<Spiral>{spiral, breaks[i], breaks[i + 1]}, eps, measure_bound_);
  }

 private:
  Plain_decider<Traits, Spiral> plain_;
  Bound bound_;
  Measure_bound<Traits> measure_bound_;
  Batch_functions functions_;
  Look_ahead<Spiral> ahead_;
  Level_strategy levels_;
};

}  // namespace CGAL::Bounding_arcs::filter

#endif
