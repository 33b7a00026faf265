// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where ends of open curves meet: an outline that is drawn as loose lines, which nothing joins, has no inside.

#ifndef BOUNDING_ARCS_TOOL_LOOSE_ENDS_H
#define BOUNDING_ARCS_TOOL_LOOSE_ENDS_H

#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>

#include <cstddef>
#include <string>

namespace bounding_arcs_tool {

/// How many curves of a drawing are open, and at how many places their ends meet.
struct Loose_ends {
  std::size_t open = 0;
  std::size_t places = 0;   ///< with two ends or more that are the same or, up to rounding, near
  std::size_t rounded = 0;  ///< of these, places with ends that are near, but not the same

  [[nodiscard]] bool meet() const { return places > 0; }
  /// "open curves, whose ends meet at 4 places"; "open curves" where none meet.
  [[nodiscard]] std::string noun() const;
  /// "4 open curves, whose ends meet at 4 places: they are not joined".
  [[nodiscard]] std::string text() const;
};

/// Ends are the same if they are so bit for bit. They are near if neither coordinate differs by more than 2^-40 of the
/// drawing's extent.
[[nodiscard]] Loose_ends loose_ends(const CGAL::Bounding_arcs::Drawing_2<double>& drawing);

}  // namespace bounding_arcs_tool

#endif
