// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Disjoint sets of numbers, each known by its least one, in four bytes a number: Boost's take sixteen, which
// counts where each piece of a large drawing has a number.

#ifndef BOUNDING_ARCS_LIBRARY_OVERLAY_JOINED_SETS_H
#define BOUNDING_ARCS_LIBRARY_OVERLAY_JOINED_SETS_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// Sets of numbers below a count (Tarjan 1975), with the least one as that by which a set is known.
class Joined_sets {
 public:
  explicit Joined_sets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0U); }

  [[nodiscard]] std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::uint32_t i, std::uint32_t j) {
    i = find(i);
    j = find(j);
    parent_[(std::max)(i, j)] = (std::min)(i, j);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
