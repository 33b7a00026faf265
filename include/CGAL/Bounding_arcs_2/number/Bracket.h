// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Two doubles with a number between them: a distance, a parameter, a thickness.

#ifndef CGAL_BOUNDING_ARCS_2_NUMBER_BRACKET_H
#define CGAL_BOUNDING_ARCS_2_NUMBER_BRACKET_H

namespace CGAL::Bounding_arcs {

/// A number is between these: `lower <= x && x <= upper`.
struct Bracket {
  double lower = 0, upper = 0;

  [[nodiscard]] double width() const { return upper - lower; }
};

}  // namespace CGAL::Bounding_arcs

#endif
