// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points, of which those within a reach of each other are one: a knot, with the place of the one that came first.
// Squares as wide as the reach are knots, and one with their neighbours where those have points, too.

#ifndef BOUNDING_ARCS_LIBRARY_OFFSET_KNOTS_H
#define BOUNDING_ARCS_LIBRARY_OFFSET_KNOTS_H

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>
#include <CGAL/Bounding_arcs_2/number/Xy.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

class Knots {
 public:
  explicit Knots(double reach) : reach_(reach) {}

  std::uint32_t add(const Xy<double>& p) {
    points_.push_back(p);
    return static_cast<std::uint32_t>(points_.size() - 1);
  }
  /// Joins the points to knots; to be called when all are there.
  void join() {
    boost::disjoint_sets_with_storage<> sets(points_.size());
    std::vector<Cell> cells;
    for (std::uint32_t i = 0; i < points_.size(); ++i)
      cells.push_back({std::floor(points_[i].x / reach_), std::floor(points_[i].y / reach_), i});
    std::sort(cells.begin(), cells.end());
    for (auto c = cells.begin(); c != cells.end(); ++c) {
      if (c != cells.begin() && !(*(c - 1) < *c)) {
        sets.union_set((c - 1)->point, c->point);
        continue;
      }
      for (const Cell& beside :
           {Cell{c->x, c->y + 1, 0}, {c->x + 1, c->y - 1, 0}, {c->x + 1, c->y, 0}, {c->x + 1, c->y + 1, 0}}) {
        const auto found = std::lower_bound(c, cells.end(), beside);
        if (found != cells.end() && !(beside < *found)) sets.union_set(c->point, found->point);
      }
    }
    knot_.resize(points_.size());
    std::vector<std::uint32_t> first(points_.size(), NONE);  // of each set
    for (std::uint32_t i = 0; i < points_.size(); ++i) {
      std::uint32_t& of_set = first[sets.find_set(i)];
      knot_[i] = of_set = (std::min)(of_set, i);
      moved_ = (std::max)(moved_, euclidean_norm(points_[i] - points_[knot_[i]]));
    }
  }
  /// The knot of a point, which is a number below size().
  [[nodiscard]] std::uint32_t of(std::uint32_t point) const { return knot_[point]; }
  [[nodiscard]] const Xy<double>& place(std::uint32_t knot) const { return points_[knot]; }
  [[nodiscard]] std::size_t size() const { return points_.size(); }
  /// How far a point is from the place of its knot at most.
  [[nodiscard]] double moved() const { return moved_; }

 private:
  struct Cell {
    double x, y;
    std::uint32_t point;
    friend bool operator<(const Cell& a, const Cell& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }
  };

  static constexpr std::uint32_t NONE = (std::numeric_limits<std::uint32_t>::max)();

  double reach_, moved_ = 0;
  std::vector<Xy<double>> points_;
  std::vector<std::uint32_t> knot_;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
