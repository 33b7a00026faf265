// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The parameters at which a spiral segment is halved: piece `place` of the 2^level equal ones.
// Invariant: a parameter is the same double on every level, and the ends are the segment's own.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_SPIRAL_GRID_H
#define CGAL_BOUNDING_ARCS_2_TREE_SPIRAL_GRID_H

#include <CGAL/Bounding_arcs_2/filter/bound_batch.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace CGAL::Bounding_arcs {

class Spiral_grid {
 public:
  Spiral_grid(double first, double last) : first_(first), last_(last), length_(last - first) {
    // so that the last parameter is reached although the difference was rounded
    if (first + length_ < last) length_ = std::nextafter(length_, std::numeric_limits<double>::infinity());
    // Pieces two ulps long have different ends whatever the rounding, and half-way points between them.
    const double ulp = std::numeric_limits<double>::epsilon() * (std::max)(std::fabs(first), std::fabs(last));
    levels_ = length_ >= 4 * ulp ? (std::min)(MAX_LEVEL, std::ilogb(length_ / ulp) - 1) : 0;
  }

  /// The number of halvings that the parameters have room for.
  [[nodiscard]] int levels() const { return levels_; }
  /// Pieces place, ..., place + count - 1 of a level.
  [[nodiscard]] filter::Batch_pieces pieces(int level, std::uint64_t place, std::size_t count = 1) const {
    const double step = length_ / static_cast<double>(std::uint64_t(1) << level);
    return {count, nullptr, nullptr, first_, step, last_, static_cast<double>(place), level <= LAST_LONG_LEVEL};
  }

  static constexpr int TOP_LEVELS = 3;
  /// The pieces of levels 0 to TOP_LEVELS - 1, level by level.
  struct Top {
    static constexpr std::size_t COUNT = (std::size_t(1) << TOP_LEVELS) - 1;
    double begins[COUNT], ends[COUNT];
    [[nodiscard]] filter::Batch_pieces pieces() const { return {COUNT, begins, ends, 0, 0, 0, 0, true}; }
  };
  /// \pre levels() >= TOP_LEVELS - 1
  [[nodiscard]] Top top() const {
    Top t{};
    for (int level = 0, i = 0; level < TOP_LEVELS; ++level)
      for (int k = 0; k < 1 << level; ++k, ++i) {
        const filter::Batch_pieces p = pieces(level, static_cast<std::uint64_t>(k));
        t.begins[i] = p.begin(0);
        t.ends[i] = p.end(0);
      }
    return t;
  }

 private:
  static constexpr int LAST_LONG_LEVEL = 3;  // a segment turns by some half of a right angle as a rule
  static constexpr int MAX_LEVEL = 52;       // places are doubles without rounding

  double first_, last_, length_;
  int levels_ = 0;
};

}  // namespace CGAL::Bounding_arcs

#endif
