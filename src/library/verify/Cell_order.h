// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether the cells of an axis are turned inside out.

#ifndef BOUNDING_ARCS_LIBRARY_VERIFY_CELL_ORDER_H
#define BOUNDING_ARCS_LIBRARY_VERIFY_CELL_ORDER_H

#include "Axis_checker_curves.h"
#include "Axis_tiles.h"
#include "Checked_axis.h"

#include <algorithm>
#include <cstddef>
#include <optional>

namespace CGAL::Bounding_arcs::verify {

class Cell_order {
 public:
  explicit Cell_order(const Checked_axis& of) : of_(of) {}

  /// A line that crosses the boundary, in a tip, is parted by discs between: nothing else of the cells changes.
  [[nodiscard]] bool holds(const Cells& cells, int halvings = 0) const {
    if ((is_in_order(cells.left) && is_in_order(cells.right)) || is_tip_in_order(cells)) return true;
    constexpr int MOST_HALVINGS = 8;
    const auto middle = halvings < MOST_HALVINGS ? disc_between(of_.curves, cells, of_.size) : std::nullopt;
    if (!middle) return false;
    Cells first = cells, last = cells;
    first.left.begin = last.left.end = middle->left;
    first.right.end = last.right.begin = middle->right;
    first.left.first = last.left.last = first.right.last = last.right.first = &*middle;
    return holds(first, halvings + 1) && holds(last, halvings + 1);
  }

 private:
  // In a tip without an angle the line to the corner may cross a side, however short it is. Both cells together are the
  // triangle from a center to both feet, and what both sides and the chord between their feet x and y enclose, where
  // no side meets the chord again.
  [[nodiscard]] bool is_tip_in_order(const Cells& cells) const {
    const bool is_last = cells.right.last->radius == 0;
    if (!is_last && cells.right.first->radius != 0) return false;
    const Axis_tile &to = is_last ? cells.right : cells.left, &from = is_last ? cells.left : cells.right;
    const Checked_vector x = point_at(of_.piece(to.begin), to.begin.t).point,
                         y = point_at(of_.piece(from.end), from.end.t).point;
    const Checked_vector c = checked((is_last ? cells.right.first : cells.right.last)->center);
    if (!(distance(of_.point(to.end), of_.point(from.begin)) <= of_.room) || !is_left(x, y, c)) return false;
    for (const Axis_tile* tile : {&to, &from}) {
      const auto [low, high] = std::minmax(tile->begin.t, tile->end.t);
      if (low == high) continue;
      const Bezier_curve_2<double> part = of_.piece(tile->begin).subcurve(low, high);
      for (const Xy<double>& p : part.control_points())
        if (!is_left(y, x, checked(p))) return false;
    }
    return true;
  }
  // A cell is not turned inside out: either of its diagonals has two triangles to the left of their sides. What of the
  // boundary is on the inside of its chord is in the cell by its control points.
  [[nodiscard]] bool is_in_order(const Axis_tile& tile) const {
    const Checked_vector p = point_at(of_.piece(tile.begin), tile.begin.t).point,
                         q = point_at(of_.piece(tile.end), tile.end.t).point;
    const Checked_vector c = checked(tile.first->center), d = checked(tile.last->center);
    if (length(q - p).sup() + length(d - c).sup() <= of_.small()) return true;
    const bool is_by_first = is_left(p, q, d) && is_left(p, d, c), is_by_second = is_left(p, q, c) && is_left(q, d, c);
    if (!is_by_first && !is_by_second) return false;
    if (tile.begin.t == tile.end.t) return true;
    const double low = (std::min)(tile.begin.t, tile.end.t), high = (std::max)(tile.begin.t, tile.end.t);
    const Bezier_curve_2<double> part = of_.piece(tile.begin).subcurve(low, high);
    const Checked_vector chord = q - p;
    for (int i = 1; i < part.degree(); ++i) {
      const Checked_vector x = checked(part.control_points()[static_cast<std::size_t>(i)]);
      const bool is_inside = (cross(chord, x - p) - Checked_number(of_.room) * length(chord)).sup() > 0;
      if (is_inside && !(is_left(q, d, x) && is_left(d, c, x) && is_left(c, p, x))) return false;
    }
    return true;
  }
  // Whether r is to the left of the way from p to q, or within rounding on it.
  [[nodiscard]] bool is_left(const Checked_vector& p, const Checked_vector& q, const Checked_vector& r) const {
    const Checked_vector way = q - p;
    return length(way).sup() <= of_.room || (cross(way, r - p) + Checked_number(of_.room) * length(way)).inf() >= 0;
  }

  const Checked_axis& of_;
};

}  // namespace CGAL::Bounding_arcs::verify

#endif
