// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading.h"

#include "../input/Input_text.h"
#include "option_words.h"

#include <CLI/CLI.hpp>

#include <iostream>

namespace bounding_arcs_tool {

namespace ba = CGAL::Bounding_arcs;

void add_reading_options(CLI::App& command, Reading_words& words) {
  command.add_flag("--strict", words.is_strict,
                   "Refuse a file that cannot be read whole; else what is left out is said on standard error");
  command.add_flag("--hidden", words.options.with_hidden,
                   "Read also what is invisible in a drawing, and layers that are off or frozen");
  command.add_flag("--paper", words.options.with_paper,
                   "Read also what a DXF file has in paper space: frames and titles of sheets");
}

std::string name_of_file(const std::string& path) { return path == "-" ? "stdin" : path; }

void tell_notes(const std::string& file, const std::vector<ba::Reading_note>& notes, const Reading_words& words) {
  if (notes.empty()) return;
  constexpr std::size_t LONGEST = 4000;  // bytes: names of kinds are the file's, and may be many
  const std::string text = one_line(text_of(notes), LONGEST);
  if (words.is_strict)
    throw ba::Input_error(file, "--strict", "expected a file that is read whole, found one that is not: " + text);
  std::cerr << "bounding_arcs: " << one_line(file, std::string::npos) << ": " << text << '\n';
}

ba::Curve_file read_told(const std::string& path, const Reading_words& words) {
  ba::Curve_file file = read_curve_file(path, words.options);
  tell_notes(name_of_file(path), file.notes, words);
  return file;
}

void tell_left_out(const std::string& file, const std::string& command, std::size_t count, ba::Fill_rule rule) {
  if (count == 0) return;
  std::cerr << "bounding_arcs: " << one_line(file, std::string::npos) << ": " << command << ": " << count
            << (count == 1 ? " curve bounds" : " curves bound") << " nothing: the " << name_of(rule)
            << " rule fills both sides or neither; --rule chooses\n";
}

}  // namespace bounding_arcs_tool
