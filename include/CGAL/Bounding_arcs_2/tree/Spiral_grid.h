// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parameters of halves.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_SPIRAL_GRID_H
#define CGAL_BOUNDING_ARCS_2_TREE_SPIRAL_GRID_H

#include <CGAL/Bounding_arcs_2/tree/internal/bits.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace CGAL::Bounding_arcs {

/// The parameters at which a spiral segment is halved: piece `place` of the 2^level equal ones.
/// Invariant: a parameter is the same double on every level, and the ends are the segment's own.
class Spiral_grid {
 public:
  static constexpr int MAX_LEVEL = 52;  ///< places are doubles without rounding

  Spiral_grid(double first, double last) : first_(first), last_(last), length_(last - first) {
    // so that the last parameter is reached although the difference was rounded
    if (first + length_ < last) length_ = std::nextafter(length_, std::numeric_limits<double>::infinity());
  }

  /// The number of halvings that the parameters have room for: pieces two ulps long have different ends whatever the
  /// rounding, and half-way points between them.
  [[nodiscard]] int levels() const {
    const double ulp = std::numeric_limits<double>::epsilon() * (std::max)(std::fabs(first_), std::fabs(last_));
    return length_ >= 4 * ulp ? (std::min)(MAX_LEVEL, internal::exponent_of(length_ / ulp) - 1) : 0;
  }
  [[nodiscard]] double first() const { return first_; }
  [[nodiscard]] double last() const { return last_; }
  /// The length of a level's pieces.
  [[nodiscard]] double step(int level) const { return length_ * internal::halved(level); }
  /// Where piece `place` of a level begins, and the one before it ends.
  [[nodiscard]] double parameter(int level, std::uint64_t place) const {
    return (std::min)(first_ + static_cast<double>(place) * step(level), last_);
  }

 private:
  double first_, last_, length_;
};

}  // namespace CGAL::Bounding_arcs

#endif
