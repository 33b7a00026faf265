// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What makes a DXF file one, before a library reads it that stops or goes on where something is wrong without a word.

#include "Dxf_groups.h"

#include "Input_text.h"

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <optional>

namespace bounding_arcs_tool {

using CGAL::Bounding_arcs::Input_error;

namespace {

constexpr std::size_t LONGEST_LINE = 1000;  // dxflib's buffers hold 1024 characters

std::string_view stripped(std::string_view line) {
  const auto first = line.find_first_not_of(" \t\r");
  return first == line.npos ? "" : line.substr(first, line.find_last_not_of(" \t\r") - first + 1);
}

struct Dxf_lines {
  std::string_view text;
  std::size_t number = 0;
  // The next line, or nothing at the end.
  std::optional<std::string_view> next() {
    if (text.empty()) return std::nullopt;
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end == text.npos ? text.size() : end + 1);
    ++number;
    return line;
  }
};

bool is_real(int code) {
  return (code >= 10 && code < 60) || (code >= 110 && code < 150) || (code >= 210 && code < 240) ||
         (code >= 460 && code < 470) || (code >= 1010 && code < 1060);
}
bool is_count(int code) { return (code >= 70 && code < 80) || (code >= 90 && code < 100); }

template <class Number> bool is_number(std::string_view word, Number& number) {
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  return error == std::errc() && end == word.data() + word.size();
}

}  // namespace

bool is_dxf(std::string_view text) {
  Dxf_lines lines{text};
  const auto code = lines.next(), value = lines.next();
  if (!code || !value) return false;
  return stripped(*code) == "999" || (stripped(*code) == "0" && stripped(*value) == "SECTION");
}

std::string_view checked_dxf(std::string_view text, const std::string& file) {
  Dxf_lines lines{text};
  const auto fail = [&](const std::string& reason) {
    throw Input_error(file, "line " + std::to_string(lines.number), reason);
  };
  bool has_counts = false;
  while (const auto code_line = lines.next()) {
    const std::string_view code_word = stripped(*code_line);
    int code = 0;
    if (!is_number(code_word, code) || code < -5 || code > 1071)
      fail("expected a group code, found " + in_quotes(code_word));
    const auto value_line = lines.next();
    if (!value_line) fail("the file ends after a group code");
    const std::string_view value = stripped(*value_line);
    if (value_line->size() > LONGEST_LINE) fail("is longer than " + std::to_string(LONGEST_LINE) + " characters");
    if (value.find('\0') != value.npos) fail("holds a character that is none");
    if (code == 0) {
      if (value == "EOF") return text.substr(0, text.size() - lines.text.size());
      has_counts = value == "SPLINE" || value == "LWPOLYLINE" || value == "HATCH" || value == "LEADER";
    } else if (is_real(code)) {
      double x = 0;
      if (!is_number(value, x)) fail("expected a number, found " + in_quotes(value));
      if (!(std::abs(x) <= MAXIMUM_COORDINATE)) fail("the number " + in_quotes(value) + " exceeds 2^1000");
    } else if (is_count(code)) {
      long long count = 0;
      if (!is_number(value, count)) fail("expected an integer, found " + in_quotes(value));
      if (has_counts && (count < 0 || static_cast<std::size_t>(count) > text.size()))
        fail("the count " + in_quotes(value) + " is larger than the file");
    }
  }
  throw Input_error(file, "line " + std::to_string(lines.number), "the file ends without EOF");
}

}  // namespace bounding_arcs_tool
