// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The algorithm: a spiral segment is halved while its regions are too thick.  This is the path of every kernel and
// curve without a filter; src/library/tree/batch/Piece_decisions.h makes the same nodes many at a time (Lee, Kim, Elber
// 2015, section 5).

#ifndef CGAL_BOUNDING_ARCS_2_TREE_SUBDIVIDE_H
#define CGAL_BOUNDING_ARCS_2_TREE_SUBDIVIDE_H

#include <CGAL/Bounding_arcs_2/frame/bezier_chord_shape.h>
#include <CGAL/Bounding_arcs_2/region/thickness_bound.h>
#include <CGAL/Bounding_arcs_2/tree/Build_options.h>
#include <CGAL/Bounding_arcs_2/tree/Region_nodes.h>
#include <CGAL/Bounding_arcs_2/tree/Spiral_grid.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Bounding_arcs {

// Pieces of spiral segments, for regions.

/// A piece of a spiral segment as regions are bounded from it: a model of ChordShapeSource.
template <class Spiral> struct Piece_source {
  using Exact_number_type = typename Spiral::Exact_number_type;
  const Spiral& spiral;
  double t0, t1;

  template <class NT> [[nodiscard]] Chord_shape_2<NT> shape(const Shape_parts& parts) const {
    return spiral.template shape<NT>(t0, t1, parts);
  }
};

namespace internal {
/// eps, or the least thickness that the coordinates and cuts of the segment resolve where that is larger.
template <class Spiral> [[nodiscard]] double reachable(double eps, const Spiral& spiral) {
  // A thickness this many times the error of a point still means something; below it regions of neighbours overlap
  // by rounding alone. Ten times less and leaves would be of the size of the rounding itself.
  constexpr double RESOLUTION_PER_ERROR = 2;
  return (std::max)(eps, RESOLUTION_PER_ERROR * (spiral.point_error() + spiral.cut_error()));
}

/// A segment whose whole region is thicker than this would need far more nodes than the limit: thickness falls with the
/// cube of length, so about the cube root of thickness over eps pieces are needed. So no time is spent on what would
/// end there.
[[nodiscard]] inline double hopeless_thickness(std::size_t limit, double eps) {
  constexpr double FAR_ABOVE = 8;
  const double most = FAR_ABOVE * static_cast<double>(limit);
  return eps * (most * most * most);
}

/// What is known of a subdivided segment beside its nodes.
struct Subdivision {
  double bound =
      0;  ///< at least the thickness of every leaf; above eps where parameters have no room for more halvings
  bool is_over_limit = false;  ///< there would be more than `limit` nodes, and not all are there
};
}  // namespace internal

/// Appends the nodes of a segment's subtree, level by level.
/// \param bound a model of BoundingRegionTraits_2's Bound_thickness_2
/// \param eps the largest thickness of a leaf, at least reachable(spiral)
/// \param limit the most nodes to be there in the end, those before included
template <class BoundThickness, class Spiral>
[[nodiscard]] internal::Subdivision subdivide(const BoundThickness& bound, const Spiral& spiral, double eps,
                                              std::size_t limit, internal::Region_nodes& nodes,
                                              Decision_counts& counts) {
  const internal::Spiral_grid grid(spiral.first(), spiral.last());
  internal::Subdivision result;
  std::vector<std::uint64_t> places{0}, halves;
  for (int level = 0; !places.empty(); ++level) {
    for (const std::uint64_t place : places) {
      const Piece_source<Spiral> piece{spiral, grid.parameter(level, place), grid.parameter(level, place + 1)};
      const Thickness_bound thickness = bound(piece, eps);
      ++(thickness.was_exact ? counts.exact : counts.bounded);
      const bool is_split = !thickness.within && level < grid.levels();
      nodes.append(&thickness.upper, is_split, 1);
      if (is_split) halves.insert(halves.end(), {2 * place, 2 * place + 1});
      else result.bound = (std::max)(result.bound, thickness.upper);
      const bool may_be_hopeless = level == 0 && thickness.upper > internal::hopeless_thickness(limit, eps);
      if (may_be_hopeless && !bound(piece, internal::hopeless_thickness(limit, eps)).within) return {0, true};
      if (nodes.size() > limit) return {0, true};
    }
    places.swap(halves);
    halves.clear();
  }
  return result;
}

}  // namespace CGAL::Bounding_arcs

#endif
