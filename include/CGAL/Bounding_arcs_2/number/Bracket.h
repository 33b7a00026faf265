// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Two doubles with a number between them: a distance, a parameter, a thickness.

#ifndef CGAL_BOUNDING_ARCS_2_NUMBER_BRACKET_H
#define CGAL_BOUNDING_ARCS_2_NUMBER_BRACKET_H

#include <ostream>

namespace CGAL::Bounding_arcs {

/// A number is between these: `lower <= x && x <= upper`.
struct Bracket {
  double lower = 0, upper = 0;

  [[nodiscard]] double width() const { return upper - lower; }
  [[nodiscard]] double middle() const { return lower + (upper - lower) / 2; }
  /// Whether it is one double, so that the number is that.
  [[nodiscard]] bool is_single() const { return lower == upper; }
  [[nodiscard]] bool touches(const Bracket& other) const { return lower <= other.upper && other.lower <= upper; }

  /// Writes both bounds, with a blank between.
  friend std::ostream& operator<<(std::ostream& out, const Bracket& b) { return out << b.lower << ' ' << b.upper; }
};

}  // namespace CGAL::Bounding_arcs

#endif
