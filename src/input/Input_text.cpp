// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reading files and showing parts of them.

#include "Input_text.h"

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <system_error>

#include <unistd.h>

namespace bounding_arcs_tool {

using CGAL::Bounding_arcs::Input_error;

namespace {

constexpr std::size_t LONGEST_QUOTE = 40;

// The length of the UTF-8 sequence that starts at `at`, 0 if there is none: no overlong forms, surrogates or values
// above U+10FFFF.
std::size_t sequence_length(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const unsigned lead = byte(at);
  if (lead < 0x80) return 1;
  const std::size_t length = lead >= 0xF0 ? 4 : (lead >= 0xE0 ? 3 : 2);
  if (lead < 0xC2 || lead > 0xF4) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(at + i) & 0xC0) != 0x80) return 0;
  const unsigned second = byte(at + 1);
  const bool overlong = (lead == 0xE0 && second < 0xA0) || (lead == 0xF0 && second < 0x90);
  const bool out_of_range = (lead == 0xED && second > 0x9F) || (lead == 0xF4 && second > 0x8F);
  return overlong || out_of_range ? 0 : length;
}

// Whether a UTF-8 sequence is a control character or one of the two line separators of Unicode.
bool is_control(std::string_view sequence) {
  if (sequence.size() == 1) return static_cast<unsigned char>(sequence[0]) < 0x20 || sequence[0] == 0x7F;
  if (sequence.size() == 2) return sequence[0] == '\xC2' && static_cast<unsigned char>(sequence[1]) < 0xA0;
  return sequence == "\xE2\x80\xA8" || sequence == "\xE2\x80\xA9";
}

std::string hexadecimal(std::string_view bytes) {
  constexpr char DIGITS[] = "0123456789ABCDEF";
  std::string result;
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    result += {'\\', 'x', DIGITS[byte >> 4], DIGITS[byte & 15]};
  }
  return result;
}

std::string all_of(std::istream& stream, const std::string& file) {
  std::string text;
  char block[1 << 16];
  errno = 0;
  while (stream.read(block, sizeof block), stream.gcount() > 0) {
    text.append(block, static_cast<std::size_t>(stream.gcount()));
    if (text.size() > MAXIMUM_FILE_SIZE)
      throw Input_error(file, "file", "expected at most " + std::to_string(MAXIMUM_FILE_SIZE) + " bytes, found more");
  }
  if (stream.bad()) throw Input_error(file, "file", "cannot be read: " + std::generic_category().message(errno));
  return text;
}

}  // namespace

std::string file_contents(const std::string& path) {
  if (path == "-") {
    if (::isatty(STDIN_FILENO) == 0 &&
        ::read(STDIN_FILENO, nullptr, 0) < 0)  // closed, or a directory: streams take this for the end
      throw Input_error("stdin", "file", "cannot be read: " + std::generic_category().message(errno));
    return all_of(std::cin, "stdin");
  }
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    throw Input_error(path, "file", "expected a file, found a directory");
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw Input_error(path, "file", "cannot be opened: " + std::generic_category().message(errno));
  return all_of(stream, path);
}

std::string text_place(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  const auto line = std::count(before.begin(), before.end(), '\n') + 1;
  const std::size_t last_break = before.rfind('\n');
  const std::size_t column = last_break == before.npos ? before.size() + 1 : before.size() - last_break;
  return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

std::string valid_utf8(std::string_view text) {
  std::string result;
  bool in_bad_run = false;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = sequence_length(text, i);
    if (length > 0) result += text.substr(i, length);
    if (length == 0 && !in_bad_run) result += "\xEF\xBF\xBD";
    in_bad_run = length == 0;
    i += std::max<std::size_t>(length, 1);
  }
  return result;
}

std::string one_line(std::string_view text, std::size_t most) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = sequence_length(text, i);
    const std::string_view bytes = text.substr(i, std::max<std::size_t>(length, 1));
    const std::string shown = length == 0 || is_control(bytes) ? hexadecimal(bytes) : std::string(bytes);
    if (shown.size() > most - std::min(most, result.size())) return result + "...";
    result += shown;
    i += bytes.size();
  }
  return result;
}

std::string in_quotes(std::string_view text) { return '"' + one_line(text, LONGEST_QUOTE) + '"'; }

}  // namespace bounding_arcs_tool
