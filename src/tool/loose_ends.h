// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What keeps curves open: ends that are too far apart. An outline of such has no inside.

#ifndef BOUNDING_ARCS_TOOL_LOOSE_ENDS_H
#define BOUNDING_ARCS_TOOL_LOOSE_ENDS_H

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>
#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>

#include <cstddef>
#include <string>

namespace bounding_arcs_tool {

/// How many curves of a drawing are open, and why.
struct Loose_ends {
  std::size_t open = 0;
  CGAL::Bounding_arcs::Xy<double> start{0, 0}, end{0, 0};  ///< of the first one
  std::size_t gaps = 0;  ///< pairs of ends that are near, and that --join-ends would join
  double widest = 0;     ///< how far apart they are at most, rounded up; 0 where they are the same

  /// What a reader tells of curves that it leaves out.
  [[nodiscard]] CGAL::Bounding_arcs::Curve_file::Note note() const;
  /// "4 open curves, whose ends are up to 0.001 apart at 4 places, the first from (0, 0) to (10, 0): --join-ends 0.001
  /// joins them".
  [[nodiscard]] std::string text() const;
};

/// Ends are near where they are at most 2^-10 of the drawing's extent apart.
[[nodiscard]] Loose_ends loose_ends(const CGAL::Bounding_arcs::Drawing_2<double>& drawing);

}  // namespace bounding_arcs_tool

#endif
