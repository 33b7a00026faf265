// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The order of passes: what lies inside first, and little way through the air.

#ifndef BOUNDING_ARCS_TOOL_TOOLPATH_ORDER_PASSES_H
#define BOUNDING_ARCS_TOOL_TOOLPATH_ORDER_PASSES_H

#include "Tool_pass.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace bounding_arcs_tool {

/// Returns of each pass the smallest closed one around it. Where passes cross, the middle of the longest piece tells.
/// \guarantee what is around another one encloses more, so that there is a last one of all
/// \complexity quadratic in the passes, in comparisons of boxes
[[nodiscard]] std::vector<std::optional<std::size_t>> passes_around(const std::vector<Tool_pass>& passes);

/// Returns passes such that each comes before all that are around it: islands first, inside out. Among those that may
/// come next it is the one that starts nearest to where the tool is. Closed passes start at the joint of pieces that is
/// nearest, and keep their direction; others start at either end. Where these differ in height it is the upper one, but
/// where the tool is at the lower one: it plunges no deeper than it has to.
/// \param from where the tool is at first
/// \guarantee heuristic: no order with less way through the air is looked for; the same passes give the same order
/// \complexity n log n in the joints, beside passes_around
[[nodiscard]] std::vector<Tool_pass> inside_out(const std::vector<Tool_pass>& passes, const Xy<double>& from = {0, 0});

/// Returns passes group by group: the first one of a group opens it, and the group is cut to its end. The next one is
/// always the one that starts nearest to where the tool is, which is (0, 0) at first; of those as near the first one.
/// \param groups of each pass, in ascending order
/// \guarantee as inside_out
[[nodiscard]] std::vector<Tool_pass> group_by_group(const std::vector<Tool_pass>& passes,
                                                    const std::vector<std::size_t>& groups);

}  // namespace bounding_arcs_tool

#endif
