// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers as text, which is most of what results are made of.

#ifndef BOUNDING_ARCS_TOOL_NUMBER_TEXT_H
#define BOUNDING_ARCS_TOOL_NUMBER_TEXT_H

#include <cstddef>
#include <string>

namespace bounding_arcs_tool {

/// What a number takes while it is written, in characters; then it has at most 24.
constexpr std::size_t NUMBER_ROOM = 40;

/// Writes x with 17 significant digits, but for zeros at the end of a fraction: reads back as the same double.
/// \param to room for NUMBER_ROOM characters
/// \return the end of the text
/// \guarantee what printf writes for %.17g in the locale "C", correctly rounded, ties to even
char* write_number(char* to, double x);

/// Appends that text.
void add_number(std::string& text, double x);
/// That text.
[[nodiscard]] std::string number(double x);
/// Four digits for people to read; null for what is no number.
[[nodiscard]] std::string short_number(double x);

}  // namespace bounding_arcs_tool

#endif
