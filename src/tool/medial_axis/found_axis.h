// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The axis that the subcommands medial-axis and thickness ask for.

#ifndef BOUNDING_ARCS_TOOL_MEDIAL_AXIS_FOUND_AXIS_H
#define BOUNDING_ARCS_TOOL_MEDIAL_AXIS_FOUND_AXIS_H

#include "medial_axis_command.h"

#include <CGAL/Bounding_arcs_2/medial_axis/axis_certificate.h>
#include <CGAL/Bounding_arcs_2/medial_axis/axis_conics.h>

#include <optional>
#include <string>
#include <vector>

namespace bounding_arcs_tool {

namespace ba = CGAL::Bounding_arcs;

inline constexpr double DEGREE = 3.14159265358979323846 / 180;

/// An axis and what it is of.
struct Found_axis {
  ba::Medial_axis_2 axis;
  std::optional<ba::Medial_axis_2::Certificate> proof;
  std::vector<std::vector<ba::Medial_axis_2::Conic>> conics;  ///< of each edge, where asked for
};

/// What an axis that is UNRESOLVED lacks, and where.
[[nodiscard]] std::string message_of_unresolved(const ba::Medial_axis_2& axis);

/// Says on standard error what of an axis is left out.
/// \param command whose words these are
/// \return the exit status: 1 where a part of it is
int tell_of_axis(const Query_drawing& loaded, const Found_axis& found, const char* command);

/// Refuses curves without a frame of which some parts alone bound a region. \throws Input_error
void expect_no_crossing(const Query_drawing& loaded, const char* command);

/// It may be UNRESOLVED where part of it is there, and is neither pruned nor proven nor has cells.
/// \param loaded with a frame where it is asked for (with_frame). \throws Input_error
[[nodiscard]] Found_axis axis_of(const Query_drawing& loaded, const Medial_axis_words& words);
/// Shows how long it takes besides.
[[nodiscard]] Found_axis shown_axis_of(const Query_drawing& loaded, const Medial_axis_words& words);

}  // namespace bounding_arcs_tool

#endif
