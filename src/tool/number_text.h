// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers as text, which is most of what results are made of.

#ifndef BOUNDING_ARCS_TOOL_NUMBER_TEXT_H
#define BOUNDING_ARCS_TOOL_NUMBER_TEXT_H

#include <CGAL/Bounding_arcs_2/number/Xy.h>

#include <cstddef>
#include <string>

namespace bounding_arcs_tool {

/// What a number takes while it is written, in characters; then it has at most 24.
constexpr std::size_t NUMBER_ROOM = 40;

/// Writes x with the fewest digits that read back as the same double, of these the nearest to x. There is an exponent
/// below 1e-4 and from 1e16 on, "1e-05" and "1.5e+16".
/// \param to room for NUMBER_ROOM characters
/// \return the end of the text
/// \guarantee the digits are those of std::to_chars; the locale does not matter
char* write_number(char* to, double x);

/// Appends that text.
void add_number(std::string& text, double x);
/// That text.
[[nodiscard]] std::string number(double x);
/// A point for messages: "(0.5, 1)", with few digits.
[[nodiscard]] std::string place_text(const CGAL::Bounding_arcs::Xy<double>& p);
/// Four digits for people to read; null for what is no number.
[[nodiscard]] std::string short_number(double x);

}  // namespace bounding_arcs_tool

#endif
