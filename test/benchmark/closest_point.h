// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bounds of the distance from a point to the curves of a tree: depth first, the nearer child first, by boxes over
// segments and by the arcs of region nodes below.

#ifndef BOUNDING_ARCS_TEST_BENCHMARK_CLOSEST_POINT_H
#define BOUNDING_ARCS_TEST_BENCHMARK_CLOSEST_POINT_H

#include <CGAL/Bounding_arcs_2/region/region_bounds.h>
#include <CGAL/Bounding_arcs_2/tree/Region_reader.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

namespace bounding_arcs_benchmark {

template <class Tree> class Closest_point_search {
  using Handle = typename Tree::Handle;
  using Point = CGAL::Bounding_arcs::Xy<double>;
  using Region = CGAL::Bounding_arcs::Arc_region_2;
  using Bracket = CGAL::Bounding_arcs::Bracket;

 public:
  explicit Closest_point_search(const Tree& tree) : tree_(&tree), reader_(tree) {}

  [[nodiscard]] Bracket operator()(const Point& q) {
    q_ = q;
    bounds_ = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    descend_boxes(tree_->root());
    return bounds_;
  }
  /// Only the boxes that hold points at most so far away.
  void look_at_boxes(const Point& q, double distance) {
    q_ = q;
    bounds_ = {distance, distance};
    has_regions_ = false;
    descend_boxes(tree_->root());
    has_regions_ = true;
  }
  /// All that were looked at since the search was made: region nodes with their arcs, and boxes.
  [[nodiscard]] std::size_t regions() const { return regions_; }
  [[nodiscard]] std::size_t boxes() const { return boxes_; }

 private:
  struct Child {
    Handle handle;
    double lower = 0;
  };
  [[nodiscard]] static double squared_distance(const Point& q, const CGAL::Bbox_2& box) {
    const double dx = (std::max)({box.xmin() - q.x, q.x - box.xmax(), 0.0}),
                 dy = (std::max)({box.ymin() - q.y, q.y - box.ymax(), 0.0});
    return dx * dx + dy * dy;
  }
  void descend_boxes(const Handle& h) {
    Child children[2];
    std::size_t count = 0;
    tree_->for_each_child(h, [&](const Handle& child) {
      if (child.is_region && has_regions_) descend_root(child);
      if (child.is_region) return;
      children[count++] = {child, squared_distance(q_, tree_->box(child))};
    });
    boxes_ += count;
    if (count == 2 && children[1].lower < children[0].lower) std::swap(children[0], children[1]);
    for (std::size_t i = 0; i < count; ++i)
      if (children[i].lower <= bounds_.upper * bounds_.upper) descend_boxes(children[i].handle);
  }
  void descend_root(const Handle& root) {
    if (look_at(root, reader_.region(root)) <= bounds_.upper) descend(root);
  }
  double look_at(const Handle& h, const Region& region) {
    ++regions_;
    const Bracket b = distance_bounds(q_, region);
    bounds_.upper = (std::min)(bounds_.upper, b.upper);
    if (h.is_leaf) bounds_.lower = (std::min)(bounds_.lower, b.lower);
    return b.lower;
  }
  void descend(const Handle& h) {
    if (h.is_leaf) return;
    Child children[2];
    std::size_t count = 0;
    reader_.for_each_child(h, [&](const Handle& child, const Region& region) {
      children[count++] = {child, look_at(child, region)};
    });
    if (children[1].lower < children[0].lower) std::swap(children[0], children[1]);
    for (const Child& child : children)
      if (child.lower <= bounds_.upper) descend(child.handle);
  }

  const Tree* tree_;
  CGAL::Bounding_arcs::Region_reader<Tree> reader_;
  Point q_;
  Bracket bounds_{};
  bool has_regions_ = true;
  std::size_t regions_ = 0, boxes_ = 0;
};

}  // namespace bounding_arcs_benchmark

#endif
