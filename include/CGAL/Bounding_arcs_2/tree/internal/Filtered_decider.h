// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Decides pieces in batches where construction, number type and segment have them, and piece by piece where these leave
// a piece open.  Nodes and breaks are those of Plain_decider.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_INTERNAL_FILTERED_DECIDER_H
#define CGAL_BOUNDING_ARCS_2_TREE_INTERNAL_FILTERED_DECIDER_H

#include <CGAL/Bounding_arcs_2/spiral/Bezier_spiral_2.h>
#include <CGAL/Bounding_arcs_2/tree/Build_options.h>
#include <CGAL/Bounding_arcs_2/tree/Region_nodes.h>
#include <CGAL/Bounding_arcs_2/tree/internal/Piece_filter.h>
#include <CGAL/Bounding_arcs_2/tree/internal/Plain_decider.h>
#include <CGAL/Bounding_arcs_2/tree/subdivide.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::filter {

/// A model of PieceDecider (doc/concepts.md). Subtrees of halved segments are made by the filter over double only, as
/// exact kernels are to be what the algorithm says; measures, which decide nothing, over all number types.
template <class Traits, class Spiral> class Filtered_decider {
  static constexpr bool IS_DOUBLE =
      std::is_same_v<typename Traits::FT, double> && std::is_same_v<Spiral, Bezier_spiral_2<double>>;
  using Bound = decltype(std::declval<const Traits&>().bound_thickness_2_object());

 public:
  Filtered_decider(const Traits& traits, Instruction_set set)
      : plain_(traits, set), bound_(traits.bound_thickness_2_object()), measure_bound_(traits),
        filter_(METHOD<typename Traits::Construction>, set) {}

  /// Tells which segments subdivide is called for next: what is to be decided of them together.
  void look_ahead(const Spiral* first, std::size_t count, double eps, bool keeps_thickness) {
    if constexpr (IS_DOUBLE) filter_.look_ahead(first, count, eps, keeps_thickness);
  }
  [[nodiscard]] internal::Subdivision subdivide(const Spiral& spiral, double eps, std::size_t limit,
                                                internal::Region_nodes& nodes, Decision_counts& counts) {
    if constexpr (IS_DOUBLE)
      if (const auto s = filter_.subdivide(spiral, eps, limit, nodes, counts, open_piece(spiral, bound_))) return *s;
    return plain_.subdivide(spiral, eps, limit, nodes, counts);
  }

  [[nodiscard]] unsigned are_thick(const Spiral& spiral, int level, std::uint64_t place, unsigned count,
                                   double eps) const {
    if constexpr (IS_DOUBLE)
      if (const auto thick = filter_.are_thick(spiral, level, place, count, eps, open_piece(spiral, bound_)))
        return *thick;
    return plain_.are_thick(spiral, level, place, count, eps);
  }

  void measure(const Spiral& spiral, double eps, const std::vector<double>& breaks, std::vector<double>& measures,
               Decision_counts& counts) const {
    if (!filter_.bound(spiral.local_curve(), eps, breaks, measures, counts, open_piece(spiral, measure_bound_)))
      return plain_.measure(spiral, eps, breaks, measures, counts);
    for (std::size_t i = 0; i < measures.size(); ++i)
      measures[i] =
          thickness_measure(measures[i], Piece_source<Spiral>{spiral, breaks[i], breaks[i + 1]}, eps, measure_bound_);
  }

 private:
  template <class AnyBound> [[nodiscard]] static Open_piece open_piece(const Spiral& spiral, const AnyBound& bound) {
    return [&](double begin, double end, double eps) { return bound(Piece_source<Spiral>{spiral, begin, end}, eps); };
  }

  Plain_decider<Traits, Spiral> plain_;
  Bound bound_;
  Measure_bound<Traits> measure_bound_;
  Piece_filter filter_;
};

}  // namespace CGAL::Bounding_arcs::filter

namespace CGAL::Bounding_arcs {

/// Who decides the pieces of a tree: the filter where it serves traits and segments, else each piece by itself.
template <class Traits, class Spiral>
using Default_decider = std::conditional_t<filter::has_local_curve_v<Spiral> &&
                                               filter::METHOD<typename Traits::Construction> != filter::Method::NONE,
                                           filter::Filtered_decider<Traits, Spiral>, Plain_decider<Traits, Spiral>>;

}  // namespace CGAL::Bounding_arcs

#endif
