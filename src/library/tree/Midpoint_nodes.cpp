// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of tree/internal/Midpoint_nodes.h.

#include <CGAL/Bounding_arcs_2/tree/Region_nodes.h>
#include <CGAL/Bounding_arcs_2/tree/Spiral_grid.h>
#include <CGAL/Bounding_arcs_2/tree/internal/Midpoint_nodes.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Bounding_arcs::internal {
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
