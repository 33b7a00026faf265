// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A binary tree of axis-aligned boxes over items in a row, built bottom-up: neighbours along a curve are neighbours in
// the plane, so level by level each box joins the next two below it.  Boxes of one or two items are made when they are
// asked for: three quarters of the memory would be theirs.
//
//   level 2            [0]
//   level 1       (0)       (1)          children of (l, k): (l-1, 2k) and, where there is one, (l-1, 2k+1)
//   level 0     (0) (1)   (2)            level 0: the items

#ifndef CGAL_BOUNDING_ARCS_2_TREE_BOX_HIERARCHY_H
#define CGAL_BOUNDING_ARCS_2_TREE_BOX_HIERARCHY_H

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Bounding_arcs {

class Box_hierarchy {
 public:
  Box_hierarchy() = default;
  /// Levels over this many items, which are to be set by join_items for all items, then join_levels.
  explicit Box_hierarchy(std::size_t items) : items_(items) {
    for (; items > std::size_t(1) << top_; ++top_) continue;
    std::size_t total = 0;
    for (int level = KEPT; level <= top_; ++level) {
      starts_.push_back(total);
      total += size_of_level(level);
    }
    boxes_.resize(total);
  }

  /// Sets what is kept of the lowest level over items begin, ..., end - 1.
  /// \param box box(i) is that of item i
  /// \pre begin is a multiple of 4, and so is end where it is not the number of items
  template <class BoxOfItem> void join_items(std::size_t begin, std::size_t end, const BoxOfItem& box) {
    if (top_ < KEPT) return;
    for (std::size_t i = begin; i < end; i += ITEMS) boxes_[i / ITEMS] = joined(i, (std::min)(i + ITEMS, end), box);
  }
  /// Sets the levels above.
  void join_levels() {
    for (int level = KEPT + 1; level <= top_; ++level) {
      const CGAL::Bbox_2* below = &boxes_[start(level - 1)];
      const std::size_t size = size_of_level(level - 1);
      for (std::size_t k = 0; k < size; k += 2)
        boxes_[start(level) + k / 2] = k + 1 < size ? below[k] + below[k + 1] : below[k];
    }
  }

  /// That of the only box. \pre there are items
  [[nodiscard]] int top_level() const { return top_; }
  [[nodiscard]] std::size_t size_of_level(int level) const { return items_ == 0 ? 0 : ((items_ - 1) >> level) + 1; }
  /// Box k of a level. \param item item(i) is the box of item i
  template <class BoxOfItem> [[nodiscard]] CGAL::Bbox_2 box(int level, std::size_t k, const BoxOfItem& item) const {
    if (level >= KEPT) return boxes_[start(level) + k];
    return joined(k << level, (std::min)((k + 1) << level, items_), item);
  }
  /// The number of boxes, kept or not.
  [[nodiscard]] std::size_t size() const {
    std::size_t total = 0;
    for (int level = 0; level <= top_; ++level) total += size_of_level(level);
    return total;
  }
  [[nodiscard]] std::size_t bytes() const {
    return boxes_.capacity() * sizeof(CGAL::Bbox_2) + starts_.capacity() * sizeof(std::size_t);
  }

 private:
  static constexpr int KEPT = 2;  // the lowest level that is
  static constexpr std::size_t ITEMS = std::size_t(1) << KEPT;

  [[nodiscard]] std::size_t start(int level) const { return starts_[static_cast<std::size_t>(level - KEPT)]; }
  template <class BoxOfItem>
  [[nodiscard]] static CGAL::Bbox_2 joined(std::size_t begin, std::size_t end, const BoxOfItem& item) {
    CGAL::Bbox_2 all = item(begin);
    for (std::size_t i = begin + 1; i < end; ++i) all += item(i);
    return all;
  }

  std::size_t items_ = 0;
  int top_ = 0;
  std::vector<CGAL::Bbox_2> boxes_;  // level by level from KEPT
  std::vector<std::size_t> starts_;  // of levels in boxes_
};

}  // namespace CGAL::Bounding_arcs

#endif
