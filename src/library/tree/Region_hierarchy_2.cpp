// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of what Region_hierarchy_2 is made of: boxes over segments, and the nodes of halved and of equalised ones.

#include "Box_tree.h"
#include "equalize_breaks.h"

#include <CGAL/Bounding_arcs_2/tree/Region_nodes.h>
#include <CGAL/Bounding_arcs_2/tree/Spiral_grid.h>
#include <CGAL/Bounding_arcs_2/tree/internal/Equalized_leaves.h>
#include <CGAL/Bounding_arcs_2/tree/internal/Midpoint_nodes.h>
#include <CGAL/Bounding_arcs_2/tree/internal/Segment_boxes.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

Segment_boxes::Segment_boxes(const std::vector<CGAL::Bbox_2>& segments)
    : tree_(std::make_shared<const Box_tree>(segments)) {}

std::size_t Segment_boxes::size() const { return tree_->size(); }
CGAL::Bbox_2 Segment_boxes::box() const { return tree_->box(); }
CGAL::Bbox_2 Segment_boxes::box(std::size_t slot) const {
  return tree_->node(static_cast<std::uint32_t>(slot / Box_tree::WIDTH)).box(slot % Box_tree::WIDTH);
}
Segment_boxes::Children Segment_boxes::children(std::uint32_t node) const {
  static_assert(sizeof(Children::child) / sizeof(Child) == Box_tree::WIDTH);
  const Box_tree::Node& n = tree_->node(node);
  Children below{{}, n.size};
  for (std::size_t k = 0; k < n.size; ++k) below.child[k] = {n.child[k], n.is_item(k), node * Box_tree::WIDTH + k};
  return below;
}

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

namespace {

constexpr int SHALLOW = 6;  // levels of 64 pieces

// The ends of a subtree of up to 64 nodes, a bit for each piece of level SHALLOW: a leaf ends with it. 0 where leaves
// are deeper.
[[nodiscard]] std::uint64_t shallow_ends(std::uint64_t splits) {
  std::uint64_t ends = 0, there = 1;  // the latter of a level's pieces
  for (int level = 0; there != 0; ++level) {
    std::uint64_t halves = 0;
    for (std::uint64_t left = there; left != 0; left &= left - 1, splits >>= 1) {
      const int place = count_zeros(left);
      if ((splits & 1) == 0) ends |= std::uint64_t(1) << (((place + 1) << (SHALLOW - level)) - 1);
      else if (level == SHALLOW) return 0;
      else halves |= std::uint64_t(3) << 2 * place;
    }
    there = halves;
  }
  return ends;
}

}  // namespace

void Leaf_runs::write_ends(const Region_nodes& nodes, std::size_t root, std::size_t size, const Spiral_grid& grid,
                           double* ends) {
  if (!nodes.is_split(root)) {  // as many are at a coarse eps
    *ends = grid.parameter(0, 1);
    return;
  }
  if (const std::uint64_t bits = size <= 64 ? shallow_ends(nodes.word(root)) : 0) {
    const double first = grid.first(), last = grid.last(), step = grid.step(SHALLOW);
    for (std::uint64_t left = bits; left != 0; left &= left - 1) {
      const double t = first + static_cast<double>(count_zeros(left) + 1) * step;
      *ends++ = t < last ? t : last;
    }
    return;
  }
  leaves_.clear();
  level_.assign(1, {0, 1, 0});
  for (std::size_t node = root; !level_.empty();) {
    halves_.clear();
    for (const Run& run : level_)
      for (std::uint64_t place = run.begin; place < run.end;) {
        const auto count = static_cast<int>((std::min<std::uint64_t>)(run.end - place, 64));
        split(nodes.word(node), count, run.level, place);
        node += static_cast<std::size_t>(count);
        place += static_cast<std::uint64_t>(count);
      }
    level_.swap(halves_);
  }
  std::sort(leaves_.begin(), leaves_.end(), [](const Run& a, const Run& b) { return a.key() < b.key(); });
  for (const Run& run : leaves_) {
    const double first = grid.first(), last = grid.last(), step = grid.step(run.level),
                 begin = static_cast<double>(run.begin);
    const int count = static_cast<int>(run.end - run.begin);
    for (int i = 0; i < count; ++i) {  // grid.parameter(run.level, run.begin + i + 1)
      const double t = first + (begin + (i + 1)) * step;
      ends[i] = t < last ? t : last;
    }
    ends += count;
  }
}

// The pieces from `place` on, of which the lowest `count` bits tell which are split.
void Leaf_runs::split(std::uint64_t word, int count, int level, std::uint64_t place) {
  for (int i = 0, length; i < count; i += length) {
    const bool is_split = (word >> i & 1) != 0;
    length = (std::min)(count_zeros(is_split ? ~(word >> i) : word >> i), count - i);
    const std::uint64_t begin = place + static_cast<std::uint64_t>(i), end = begin + static_cast<std::uint64_t>(length);
    if (is_split) append(halves_, {2 * begin, 2 * end, level + 1});
    else append(leaves_, {begin, end, level});
  }
}
void Leaf_runs::append(std::vector<Run>& runs, const Run& run) {
  const bool joins = !runs.empty() && runs.back().end == run.begin && runs.back().level == run.level;
  if (joins) runs.back().end = run.end;
  else runs.push_back(run);
}

}  // namespace CGAL::Bounding_arcs::internal
