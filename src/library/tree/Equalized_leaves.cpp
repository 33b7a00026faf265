// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of tree/internal/Equalized_leaves.h.

#include "equalize_breaks.h"

#include <CGAL/Bounding_arcs_2/tree/Spiral_grid.h>
#include <CGAL/Bounding_arcs_2/tree/internal/Equalized_leaves.h>

#include <cstddef>
#include <cstdint>

namespace CGAL::Bounding_arcs::internal {

bool Equalized_leaves::add(double first, double last, double eps, std::size_t limit, const Measure& measure) {
  constexpr int LEVEL = 3;  // of the equal pieces that a segment is first cut into
  const Spiral_grid grid(first, last);
  const int level = grid.levels() > LEVEL ? LEVEL : 0;
  cut_.breaks.clear();
  for (std::uint64_t i = 0; i <= std::uint64_t(1) << level; ++i) cut_.breaks.push_back(grid.parameter(level, i));
  equalize_breaks(cut_, eps, limit, measure);
  if (cut_.is_limit_far) return false;
  bounds_.push_back(*std::max_element(cut_.measures.begin(), cut_.measures.end()));
  breaks_.insert(breaks_.end(), cut_.breaks.begin(), cut_.breaks.end());
  first_.push_back(breaks_.size());
  return number_of_nodes() <= limit;
}

void Equalized_leaves::append(const Equalized_leaves& other, std::size_t first, std::size_t last) {
  const std::size_t begin = breaks_.size() - other.first_[first];  // modulo 2^64, as it may be negative
  const auto at = [](const std::vector<double>& v, std::size_t i) {
    return v.begin() + static_cast<std::ptrdiff_t>(i);
  };
  breaks_.insert(breaks_.end(), at(other.breaks_, other.first_[first]), at(other.breaks_, other.first_[last]));
  bounds_.insert(bounds_.end(), at(other.bounds_, first), at(other.bounds_, last));
  for (std::size_t i = first; i < last; ++i) first_.push_back(other.first_[i + 1] + begin);
}

}  // namespace CGAL::Bounding_arcs::internal
