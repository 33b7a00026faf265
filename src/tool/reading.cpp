// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading.h"

#include "../input/Dxf_units.h"
#include "../input/Input_text.h"
#include "Read_file.h"
#include "option_words.h"
#include "usage.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <utility>

namespace bounding_arcs_tool {

namespace ba = CGAL::Bounding_arcs;

namespace {

std::string check_join(const std::string& word) {
  char* end = nullptr;
  const double eps = std::strtod(word.c_str(), &end);
  if (word == "none" || (!word.empty() && *end == '\0' && std::isfinite(eps) && eps >= 0)) return "";
  return expected("none, or one number from 0 such as 0.01", word);
}

}  // namespace

void add_reading_options(CLI::App& command, Reading_words& words) {
  command
      .add_option_function<std::string>(
          "--units",
          [&words](const std::string& word) {
            words.unit = {"", unit_of_word(word)};
          },
          "Convert what is read to that unit, which distances, --eps and results are in; a file that tells no unit\n"
          "is taken to be in it. Without it the unit of the first file that tells one")
      ->check(one_of(unit_words()));
  command
      .add_option("--join-ends", words.join,
                  "Join open curves where two ends are that near, in units of the coordinates; where more are, those\n"
                  "that go on straight. An outline of loose lines gets an inside. Without it ends of DXF and SVG\n"
                  "files are joined that rounding parts; none joins nothing")
      ->check(CLI::Validator(check_join, "", "join-ends"))
      ->type_name("NUMBER");
  command.add_flag("--skip-open", words.skips_open, "Leave out curves that are open when all ends are joined");
  command
      .add_option(
          "--layers", words.layers,
          "Read only curves on these layers of a DXF file, or of an SVG file from Inkscape, with commas between")
      ->type_name("LIST");
  command
      .add_option("--ids", words.ids,
                  "Take only curves of these names, with commas between, as they are called when ends are joined; a\n"
                  "name stands also for name.1, name.2, ...")
      ->type_name("LIST");
  command.add_flag("--strict", words.is_strict,
                   "Refuse a file in which something is left out, joined or open where it has to be closed, unless an\n"
                   "option asks for that; else a line on standard error says it");
  command.add_flag("--hidden", words.options.with_hidden,
                   "Read also what is invisible in a drawing, and layers that are off or frozen");
  command.add_flag("--paper", words.options.with_paper,
                   "Read also what a DXF file has in paper space: frames and titles of sheets");
}

void Reading_words::keep_unit(const File_unit& of) {
  if (unit.in_mm != 0) return;
  if (of.in_mm == 0) {
    if (without_unit.empty()) without_unit = of.file;
    return;
  }
  unit = of;
  if (!without_unit.empty()) tell(without_unit, taken_unit_text(of));
}

std::string name_of_file(const std::string& path) { return path == "-" ? "stdin" : path; }

std::string count_text(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

void tell(const std::string& file, const std::string& text) {
  std::cerr << "bounding_arcs: " << one_line(file, std::string::npos) << ": " << text << '\n';
}

void tell_change(const std::string& file, const std::string& text, const Reading_words& words) {
  if (text.empty()) return;
  constexpr std::size_t LONGEST = 4000;  // bytes: names of kinds are the file's, and may be many
  const std::string line = one_line(text, LONGEST);
  if (words.is_strict)
    throw ba::Input_error(file, "--strict",
                          "expected a file that is read as it stands, found one that is not: " + line);
  tell(file, line);
}

void tell_notes(const std::string& file, const std::vector<ba::Curve_file::Note>& notes, const Reading_words& words) {
  tell_change(file, ba::Curve_file::text_of(notes), words);
}

namespace {

void tell_joined(const std::string& file, const Read_file& read, const Reading_words& words) {
  if (!read.converted.empty()) tell(file, read.converted);
  if (words.join.empty()) tell_change(file, read.joined, words);
  else if (!read.joined.empty()) tell(file, read.joined);
  tell_change(file, read.ambiguous, words);
}

}  // namespace

ba::Curve_file::Options reading_options(const Reading_words& words) {
  ba::Curve_file::Options options = words.options;
  if (!words.layers.empty()) options.layers = words_between_commas(words.layers);
  if (!words.rule.empty()) options.rule = fill_rule(words.rule, ba::Fill_rule::NONZERO);
  return options;
}

ba::Curve_file read_joined(const std::string& path, const Reading_words& words) {
  Read_file read = read_file(path, words);
  tell_joined(name_of_file(path), read, words);
  return std::move(read.file);
}

ba::Curve_file read_told(const std::string& path, const Reading_words& words) {
  const std::string name = name_of_file(path);
  Read_file read = read_file(path, words);
  tell_joined(name, read, words);
  if (words.skips_open) skip_open(name, read);
  if (!read.skipped.empty()) tell(name, read.skipped);  // no error with --strict, as it was asked for
  tell_notes(name, read.file.notes, words);
  return std::move(read.file);
}

void tell_left_out(const std::string& file, const std::string& command, std::size_t count, ba::Fill_rule rule) {
  if (count == 0) return;
  tell(file, command + ": " + std::to_string(count) + (count == 1 ? " curve bounds" : " curves bound") +
                 " nothing: the " + name_of(rule) + " rule fills both sides or neither; --rule chooses");
}

void tell_units_of_dxf(const File_unit& unit) {
  if (unit.in_mm > 0 && dxf_number_of_unit(unit.in_mm) == 0)
    tell(unit.file.empty() ? "--units" : unit.file,
         "1 unit is " + unit_text(unit.in_mm) + ", for which DXF has no word: none is written; --units converts");
}

}  // namespace bounding_arcs_tool
