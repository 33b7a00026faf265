// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is known of a result: complete, or where doubles left something open.

#ifndef CGAL_BOUNDING_ARCS_2_OVERLAY_OUTLINE_STATUS_H
#define CGAL_BOUNDING_ARCS_2_OVERLAY_OUTLINE_STATUS_H

#include <CGAL/Bounding_arcs_2/number/Xy.h>

#include <cstdint>

namespace CGAL::Bounding_arcs {

/// What an outline or an overlay is known to be.
enum class Outline_status : std::uint8_t {
  COMPLETE,  ///< exactly what was asked for; always so with exact decisions
  UNDECIDED  ///< doubles left something open, and nothing else decides: there is no more than this
};

/// Where two curves meet in a way that was not decided.
struct Undecided_meeting {
  /// A Bezier piece of one of the drawings.
  struct Of {
    std::uint32_t operand = 0, curve = 0, bezier = 0;
  };
  Xy<double> at;  ///< about
  Of a, b;
};

}  // namespace CGAL::Bounding_arcs

#endif
