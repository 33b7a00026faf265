// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What overlay.h calls, compiled in the library.

#ifndef CGAL_BOUNDING_ARCS_2_OVERLAY_INTERNAL_COMPILED_OVERLAY_H
#define CGAL_BOUNDING_ARCS_2_OVERLAY_INTERNAL_COMPILED_OVERLAY_H

#include <CGAL/Bounding_arcs_2/overlay/Outline_operand.h>
#include <CGAL/Bounding_arcs_2/overlay/Overlay_2.h>
#include <CGAL/Bounding_arcs_2/query/measures.h>
#include <CGAL/Bounding_arcs_2/tree/Segment_hierarchy.h>

#include <cstdint>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// \throws std::invalid_argument for curves out of the range of queries
[[nodiscard]] Overlay_2 overlay(const std::vector<Outline_operand>& operands, const Overlay_options& options,
                                Decisions decisions);

/// \throws std::invalid_argument if the face is unbounded, or eps below 0
[[nodiscard]] Measure_bounds face_area(const Overlay_2& overlay, std::uint32_t face,
                                       const std::vector<Outline_operand>& operands, double eps);

}  // namespace CGAL::Bounding_arcs::internal

#endif
