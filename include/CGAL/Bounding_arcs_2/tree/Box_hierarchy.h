// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A binary tree of axis-aligned boxes over items in a row, built bottom-up: neighbours along a curve are neighbours in
// the plane, so level by level each box joins the next two below it.
//
//   level 2            [0]
//   level 1       [0]       [1]          children of (l, k): (l-1, 2k) and, where there is one, (l-1, 2k+1)
//   level 0     [0] [1]   [2]            level 0: the items' own boxes

#ifndef CGAL_BOUNDING_ARCS_2_TREE_BOX_HIERARCHY_H
#define CGAL_BOUNDING_ARCS_2_TREE_BOX_HIERARCHY_H

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

class Box_hierarchy {
 public:
  Box_hierarchy() = default;
  explicit Box_hierarchy(std::vector<CGAL::Bbox_2> items) : boxes_(std::move(items)) {
    for (std::size_t begin = 0, size = boxes_.size(); size > 0;) {
      starts_.push_back(begin);
      if (size == 1) break;
      for (std::size_t k = 0; k < size; k += 2)
        boxes_.push_back(k + 1 < size ? boxes_[begin + k] + boxes_[begin + k + 1] : boxes_[begin + k]);
      begin += size;
      size = (size + 1) / 2;
    }
  }

  /// The number of levels; 0 when there are no items.
  [[nodiscard]] std::size_t levels() const { return starts_.size(); }
  [[nodiscard]] std::size_t size_of_level(std::size_t level) const {
    return (level + 1 < starts_.size() ? starts_[level + 1] : boxes_.size()) - starts_[level];
  }
  [[nodiscard]] const CGAL::Bbox_2& box(std::size_t level, std::size_t k) const { return boxes_[starts_[level] + k]; }
  [[nodiscard]] std::size_t size() const { return boxes_.size(); }
  [[nodiscard]] std::size_t bytes() const {
    return boxes_.capacity() * sizeof(CGAL::Bbox_2) + starts_.capacity() * sizeof(std::size_t);
  }

 private:
  std::vector<CGAL::Bbox_2> boxes_;  // level by level, items first
  std::vector<std::size_t> starts_;
};

}  // namespace CGAL::Bounding_arcs

#endif
