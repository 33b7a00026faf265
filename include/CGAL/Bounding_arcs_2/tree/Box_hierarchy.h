// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A binary tree of axis-aligned boxes over items in a row, built bottom-up: neighbours along a curve are neighbours in
// the plane, so level by level each box joins the next two below it.  The items' own boxes are not kept, as items have them.
//
//   level 2            [0]
//   level 1       [0]       [1]          children of (l, k): (l-1, 2k) and, where there is one, (l-1, 2k+1)
//   level 0     (0) (1)   (2)            level 0: the items

#ifndef CGAL_BOUNDING_ARCS_2_TREE_BOX_HIERARCHY_H
#define CGAL_BOUNDING_ARCS_2_TREE_BOX_HIERARCHY_H

#include <CGAL/Bbox_2.h>

#include <cstddef>
#include <vector>

namespace CGAL::Bounding_arcs {

class Box_hierarchy {
 public:
  Box_hierarchy() = default;
  /// Levels over this many items, whose boxes are set by join_items for all items and then join_levels.
  explicit Box_hierarchy(std::size_t items) : items_(items) {
    std::size_t total = 0;
    for (std::size_t size = items; size > 1;) {
      size = (size + 1) / 2;
      starts_.push_back(total);
      total += size;
    }
    boxes_.resize(total);
  }

  /// Sets the boxes of level 1 over items begin, ..., end - 1.
  /// \param box box(i) is that of item i
  /// \pre begin is even; end is even or the number of items
  template <class BoxOfItem>
  void join_items(std::size_t begin, std::size_t end, const BoxOfItem& box) {
    if (items_ <= 1) return;
    for (std::size_t i = begin; i < end; i += 2) boxes_[i / 2] = i + 1 < end ? box(i) + box(i + 1) : box(i);
  }
  /// Sets the boxes of the levels above 1.
  void join_levels() {
    for (std::size_t level = 2; level < levels(); ++level) {
      const std::size_t size = size_of_level(level - 1);
      for (std::size_t k = 0; k < size; k += 2)
        boxes_[starts_[level - 1] + k / 2] = k + 1 < size ? box(level - 1, k) + box(level - 1, k + 1) : box(level - 1, k);
    }
  }

  /// The number of levels, that of the items included; 0 when there are no items.
  [[nodiscard]] std::size_t levels() const { return items_ == 0 ? 0 : starts_.size() + 1; }
  [[nodiscard]] std::size_t size_of_level(std::size_t level) const {
    if (level == 0) return items_;
    return (level < starts_.size() ? starts_[level] : boxes_.size()) - starts_[level - 1];
  }
  /// \pre level > 0
  [[nodiscard]] const CGAL::Bbox_2& box(std::size_t level, std::size_t k) const { return boxes_[starts_[level - 1] + k]; }
  /// The number of boxes, those of items included.
  [[nodiscard]] std::size_t size() const { return items_ + boxes_.size(); }
  [[nodiscard]] std::size_t bytes() const {
    return boxes_.capacity() * sizeof(CGAL::Bbox_2) + starts_.capacity() * sizeof(std::size_t);
  }

 private:
  std::size_t items_ = 0;
  std::vector<CGAL::Bbox_2> boxes_;  // level by level from 1
  std::vector<std::size_t> starts_;
};

}  // namespace CGAL::Bounding_arcs

#endif
