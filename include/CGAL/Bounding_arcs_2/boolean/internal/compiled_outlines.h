// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Boolean operations as the library has compiled them.

#ifndef CGAL_BOUNDING_ARCS_2_BOOLEAN_INTERNAL_COMPILED_OUTLINES_H
#define CGAL_BOUNDING_ARCS_2_BOOLEAN_INTERNAL_COMPILED_OUTLINES_H

#include <CGAL/Bounding_arcs_2/boolean/Clipped_2.h>
#include <CGAL/Bounding_arcs_2/boolean/Drawn_outline.h>
#include <CGAL/Bounding_arcs_2/boolean/Outline_2.h>
#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>
#include <CGAL/Bounding_arcs_2/overlay/Outline_operand.h>
#include <CGAL/Bounding_arcs_2/tree/Drawing_hierarchy.h>

#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// \throws std::invalid_argument for an open curve, and for curves out of the range of queries
[[nodiscard]] Outline_2 outline(const std::vector<Outline_operand>& operands, Boolean_operation operation,
                                Decisions decisions);

/// Returns the curves of an outline, each a chain of the parts of its Bezier pieces.
[[nodiscard]] Drawing_2<double> outline_drawing(const Outline_2& outline,
                                                const std::vector<const Drawing_2<double>*>& operands);
/// Returns them with how far rounding moved them.
[[nodiscard]] Drawn_outline drawn_outline(const Outline_2& outline, const std::vector<Outline_operand>& operands,
                                          const Outline_drawing_options& options);

/// \throws std::invalid_argument for an open curve of the region
[[nodiscard]] Clipped_2 clip(const Drawing_hierarchy& curves, const Drawing_hierarchy& region, Fill_rule rule);

}  // namespace CGAL::Bounding_arcs::internal

#endif
