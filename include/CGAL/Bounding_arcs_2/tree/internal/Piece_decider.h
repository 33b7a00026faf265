// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Decides pieces in batches where construction, number type and segment have them, and piece by piece where these leave
// a piece open.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_INTERNAL_PIECE_DECIDER_H
#define CGAL_BOUNDING_ARCS_2_TREE_INTERNAL_PIECE_DECIDER_H

#include <CGAL/Bounding_arcs_2/region/thickness_bound.h>
#include <CGAL/Bounding_arcs_2/spiral/Bezier_spiral_2.h>
#include <CGAL/Bounding_arcs_2/tree/Build_options.h>
#include <CGAL/Bounding_arcs_2/tree/Region_nodes.h>
#include <CGAL/Bounding_arcs_2/tree/internal/Piece_filter.h>
#include <CGAL/Bounding_arcs_2/tree/subdivide.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

// The measure by which leaves of about equal thickness are made: a thickness rounded up to few digits, so that it is
// the same whoever bounded the thickness, and breaks are where they are without a filter and in every kernel.

/// Digits of measures: moves breaks by 2^-13 / 3 of a piece; twice as many would leave more open.
inline constexpr int MEASURE_BITS = 12;
/// x >= 0 rounded up to MEASURE_BITS significant bits.
[[nodiscard]] inline double rounded_measure(double x) {
  constexpr std::uint64_t REST = (std::uint64_t(1) << (53 - MEASURE_BITS)) - 1;
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  bits = (bits + REST) & ~REST;
  std::memcpy(&x, &bits, sizeof bits);
  return x;
}

/// \param upper an upper bound of the piece's thickness, as a rule within 2^-20 of it
/// \param bound decides pieces against an eps
/// \return at least the thickness, at most eps where `upper` is; the least number of MEASURE_BITS bits that is, but
///   where `upper` is farther above the thickness
template <class Piece, class Bound>
[[nodiscard]] double thickness_measure(double upper, const Piece& piece, double eps, const Bound& bound) {
  constexpr double CLOSE = 0x1p-20;
  double measure = rounded_measure(upper);
  const double less = rounded_measure(upper * (1 - CLOSE));
  if (less < measure && bound(piece, less).within) measure = less;
  return upper <= eps ? (std::min)(measure, eps) : measure;
}

/// The traits' Bound_thickness_2 over floating numbers; for exact ones the filtered kernel's, which decides the same
/// and bounds thickness in doubles.
template <class Traits> [[nodiscard]] auto measure_bound(const Traits& traits) {
  if constexpr (std::is_floating_point_v<typename Traits::FT>) {
    return traits.bound_thickness_2_object();
  } else {
    return [construction = traits.construction()](const auto& source, double eps) {
      return bound_thickness<double, true>(construction, source, eps);
    };
  }
}

/// Decides pieces in batches where construction, number type and segment have them, else piece by piece: nodes and
/// breaks are the same.
template <class Traits, class Spiral> class Piece_decider {
  static constexpr filter::Method METHOD =
      filter::has_local_curve_v<Spiral> ? filter::METHOD<typename Traits::Construction> : filter::Method::NONE;
  static constexpr bool HAS_FILTER = METHOD != filter::Method::NONE;
  // Subtrees of halved segments are made by the filter over double only, as exact kernels are to be what the algorithm
  // says; measures, which decide nothing, over all number types.
  static constexpr bool IS_DOUBLE =
      HAS_FILTER && std::is_same_v<typename Traits::FT, double> && std::is_same_v<Spiral, Bezier_spiral_2<double>>;

 public:
  /// \param set NONE decides each piece by itself
  Piece_decider(const Traits& traits, Build_options::Instruction_set set)
      : bound_(traits.bound_thickness_2_object()), measure_bound_(measure_bound(traits)), filter_(METHOD, set) {}

  /// Tells which segments subdivide is called for next: what is to be decided of them together.
  void look_ahead([[maybe_unused]] const Spiral* first, [[maybe_unused]] std::size_t count, [[maybe_unused]] double eps,
                  [[maybe_unused]] bool keeps_thickness) {
    if constexpr (IS_DOUBLE) filter_.look_ahead(first, count, eps, keeps_thickness);
  }
  /// Appends a segment's subtree, see Bounding_arcs::subdivide.
  [[nodiscard]] internal::Subdivision subdivide(const Spiral& spiral, double eps, std::size_t limit,
                                                internal::Region_nodes& nodes, Decision_counts& counts) {
    if constexpr (IS_DOUBLE)
      if (const auto s = filter_.subdivide(spiral, eps, limit, nodes, counts, open_piece(spiral, bound_))) return *s;
    return Bounding_arcs::subdivide(bound_, spiral, eps, limit, nodes, counts);
  }

  /// Whether pieces place and, for `count` 2, place + 1 of a level are thicker than eps, a bit each.
  [[nodiscard]] unsigned are_thick(const Spiral& spiral, int level, std::uint64_t place, unsigned count,
                                   double eps) const {
    if constexpr (IS_DOUBLE)
      if (const auto thick = filter_.are_thick(spiral, level, place, count, eps, open_piece(spiral, bound_)))
        return *thick;
    const internal::Spiral_grid grid(spiral.first(), spiral.last());
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
    const auto piece = [&](std::size_t i) { return Piece_source<Spiral>{spiral, breaks[i], breaks[i + 1]}; };
    bool is_bounded = false;
    if constexpr (HAS_FILTER)
      is_bounded =
          filter_.bound(spiral.local_curve(), eps, breaks, measures, counts, open_piece(spiral, measure_bound_));
    measures.resize(breaks.size() - 1);
    for (std::size_t i = 0; i < measures.size(); ++i) {
      if (!is_bounded) {
        const Thickness_bound thickness = measure_bound_(piece(i), eps);
        ++(thickness.was_exact ? counts.exact : counts.bounded);
        measures[i] = thickness.upper;
      }
      measures[i] = thickness_measure(measures[i], piece(i), eps, measure_bound_);
    }
  }

 private:
  template <class AnyBound>
  [[nodiscard]] static filter::Open_piece open_piece(const Spiral& spiral, const AnyBound& bound) {
    return [&](double begin, double end, double eps) { return bound(Piece_source<Spiral>{spiral, begin, end}, eps); };
  }

  decltype(std::declval<const Traits&>().bound_thickness_2_object()) bound_;
  decltype(measure_bound(std::declval<const Traits&>())) measure_bound_;
  filter::Piece_filter filter_;
};

}  // namespace CGAL::Bounding_arcs

#endif
