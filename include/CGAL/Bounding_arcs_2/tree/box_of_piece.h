// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The box of a piece of a spiral segment: as it is monotone in x and y, the box of its two end points.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_BOX_OF_PIECE_H
#define CGAL_BOUNDING_ARCS_2_TREE_BOX_OF_PIECE_H

#include <CGAL/Bounding_arcs_2/internal/convert.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/number_utils.h>

#include <limits>
#include <type_traits>
#include <utility>

namespace CGAL::Bounding_arcs {
/// Two doubles with x - error and x + error between them.
template <class NT> [[nodiscard]] std::pair<double, double> widened(const NT& x, double error) {
  if constexpr (std::is_same_v<NT, double> || std::is_same_v<NT, float>) {
    // the differences below are rounded by at most half an ulp of x and the error together
    const double margin = error + (CGAL::abs(static_cast<double>(x)) + error) * std::numeric_limits<double>::epsilon();
    return {static_cast<double>(x) - margin, static_cast<double>(x) + margin};
  } else {
    const std::pair<double, double> range = CGAL::to_interval(x);
    return {widened(range.first, error).first, widened(range.second, error).second};
  }
}

/// \guarantee holds the exact piece
template <class Spiral> [[nodiscard]] CGAL::Bbox_2 box_of_piece(const Spiral& s, double t0, double t1) {
  const auto box = [&](const auto& p) {
    const auto x = widened(p.x, s.point_error()), y = widened(p.y, s.point_error());
    return CGAL::Bbox_2(x.first, y.first, x.second, y.second);
  };
  return box(s.point(t0)) + box(s.point(t1));
}

}  // namespace CGAL::Bounding_arcs

#endif
