// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pieces of spiral segments, for regions.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_PIECE_SOURCE_H
#define CGAL_BOUNDING_ARCS_2_TREE_PIECE_SOURCE_H

#include <CGAL/Bounding_arcs_2/frame/bezier_chord_shape.h>

#include <algorithm>

namespace CGAL::Bounding_arcs {

/// A piece of a spiral segment as regions are bounded from it: a model of ChordShapeSource.
template <class Spiral> struct Piece_source {
  using Exact_number_type = typename Spiral::Exact_number_type;
  const Spiral& spiral;
  double t0, t1;

  template <class NT> [[nodiscard]] Chord_shape_2<NT> shape(const Shape_parts& parts) const {
    return spiral.template shape<NT>(t0, t1, parts);
  }
};

/// eps, or the least thickness that the coordinates and cuts of the segment resolve where that is larger.
template <class Spiral> [[nodiscard]] double reachable(double eps, const Spiral& spiral) {
  // A thickness this many times the error of a point still means something; below it regions of neighbours overlap
  // by rounding alone. Ten times less and leaves would be of the size of the rounding itself.
  constexpr double RESOLUTION_PER_ERROR = 2;
  return (std::max)(eps, RESOLUTION_PER_ERROR * (spiral.point_error() + spiral.cut_error()));
}

}  // namespace CGAL::Bounding_arcs

#endif
