// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The text of an input file: reading it, naming places in it, and making parts of it fit to print.

#ifndef BOUNDING_ARCS_TOOL_INPUT_TEXT_H
#define BOUNDING_ARCS_TOOL_INPUT_TEXT_H

#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

namespace bounding_arcs_tool {

/// Greatest magnitude of coordinates, knots and sizes, 2^1000: differences and sums of a few million stay finite, which
/// those of numbers next to the greatest double, 2^1024, do not.
inline const double MAXIMUM_COORDINATE = std::ldexp(1.0, 1000);

/// Weights lie within 2^-500 ... 2^500, so that the product of any two is a normal double.
inline const double MAXIMUM_WEIGHT = std::ldexp(1.0, 500);

/// Greatest size of a file in bytes, 256 MiB, some three million curves of a line each; endless devices end here.
constexpr std::size_t MAXIMUM_FILE_SIZE = std::size_t(1) << 28;

/// The limit for SVG, 64 MiB: path data spell out a piece in as little as two bytes, which is a hundred in memory.
constexpr std::size_t MAXIMUM_SVG_SIZE = std::size_t(1) << 26;

/// The bytes of a file, or of standard input for "-".
/// \throws Input_error when it cannot be opened, is a directory, cannot be read, or is longer than MAXIMUM_FILE_SIZE
[[nodiscard]] std::string file_contents(const std::string& path);

/// "line L, column C", both from 1, of the byte at an offset.
[[nodiscard]] std::string text_place(std::string_view text, std::size_t offset);

/// The text with every maximal run of bytes that is not UTF-8 replaced by U+FFFD.
[[nodiscard]] std::string valid_utf8(std::string_view text);

/// The text on one line: control characters and bytes that are not UTF-8 as \xNN, cut after `most` bytes with "...".
[[nodiscard]] std::string one_line(std::string_view text, std::size_t most);

/// The text between double quotes, on one line and cut to a length that suits a message.
[[nodiscard]] std::string in_quotes(std::string_view text);

}  // namespace bounding_arcs_tool

#endif
