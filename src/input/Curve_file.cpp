// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tells the formats apart, and makes what is wrong with a file a line.

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>

#include "Curve_readers.h"
#include "Dxf_groups.h"
#include "Input_text.h"

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <string_view>

namespace CGAL::Bounding_arcs {

namespace tool = bounding_arcs_tool;

namespace {

constexpr std::size_t LONGEST_PLACE = 200;
constexpr std::size_t LONGEST_REASON = 400;

constexpr std::string_view UTF8_MARK = "\xEF\xBB\xBF", UTF16_MARK = "\xFE\xFF", UTF16_SWAPPED_MARK = "\xFF\xFE";

bool starts_with(std::string_view text, std::string_view head) { return text.substr(0, head.size()) == head; }

// Ends of a drawing are as near as doubles are, or as its digits are, unless these are so few that they tell of
// details.
Curve_file with_rounding_of_doubles(Curve_file&& read) {
  constexpr double DETAIL = 0x1p-16;  // of the extent; the six digits behind the point that many files have are fewer
  Bbox_2 box;
  for (const Curve_record& record : read.curves)
    for (const auto& bezier : record.beziers)
      for (const Xy<double>& p : bezier.control_points()) box += Bbox_2(p.x, p.y, p.x, p.y);
  const double detail = DETAIL * (std::max)(box.x_span(), box.y_span());
  if (read.rounding > detail) read.rounding = 0;
  for (Curve_record& record : read.curves)
    if (2 * record.end_error > detail) record.end_error = 0;  // two ends have one each
  const double size =
      (std::max)({std::fabs(box.xmin()), std::fabs(box.xmax()), std::fabs(box.ymin()), std::fabs(box.ymax())});
  read.rounding = (std::max)(read.rounding, Joined_curves::rounding_of_ends(size));
  return std::move(read);
}

// Throws for a text that cannot be JSON, by its name where it has one.
void refuse_others(std::string_view whole, std::size_t first, const std::string& file) {
  const std::string_view text = whole.substr(first);
  constexpr std::string_view FIRST_OF_JSON = "{[\"tfn", BINARY_DXF = "AutoCAD Binary DXF", DWG = "AC10";
  if (FIRST_OF_JSON.find(text.front()) != std::string_view::npos) return;
  const std::string what = starts_with(text, BINARY_DXF) ? "a binary DXF file, which is not read: save it as text"
                           : starts_with(text, DWG)      ? "a DWG file, which is not read: save it as DXF"
                                                         : "a file that begins with " + tool::in_quotes(text);
  throw Input_error(file, tool::text_place(whole, first), "expected JSON, SVG or text DXF, found " + what);
}

}  // namespace

Input_error::Input_error(const std::string& file, const std::string& place, const std::string& reason)
    : std::runtime_error(tool::one_line(file, std::string::npos) + ": " + tool::one_line(place, LONGEST_PLACE) + ": " +
                         tool::one_line(reason, LONGEST_REASON)) {}

std::string Curve_file::text_of(const Note& note) {
  return std::to_string(note.count) + ' ' + note.what + (note.reason.empty() ? "" : ": " + note.reason);
}

std::string Curve_file::text_of(const std::vector<Note>& notes) {
  std::string text;
  for (const bool is_read : {false, true}) {
    const char* between = is_read ? "read all the same: " : "left out: ";
    for (const Curve_file::Note& note : notes) {
      if (note.is_read != is_read) continue;
      text += (text.empty() || *between == ';' ? "" : "; ") + std::string(between) + text_of(note);
      between = "; ";
    }
  }
  return text;
}

Curve_file Curve_file::from_text(const std::string& text, const std::string& file, const std::string& stem,
                                 const Options& options) {
  if (starts_with(text, UTF16_MARK) || starts_with(text, UTF16_SWAPPED_MARK))
    throw Input_error(file, "line 1, column 1", "expected UTF-8, found a UTF-16 byte order mark");
  const std::size_t start = starts_with(text, UTF8_MARK) ? UTF8_MARK.size() : 0;
  const std::size_t first = text.find_first_not_of(" \t\r\n", start);
  if (first == text.npos) throw Input_error(file, "line 1, column 1", "expected JSON, SVG or DXF, found an empty file");
  if (tool::is_dxf(std::string_view(text).substr(first)))
    return with_rounding_of_doubles(tool::read_dxf_curves(std::string_view(text).substr(start), file, options));
  if (text[first] == '<') return with_rounding_of_doubles(tool::read_svg_curves(text, file, options));
  refuse_others(text, first, file);
  Curve_file read = tool::read_json_curves(text, file, stem);
  read.rule = options.rule.value_or(read.rule);
  return read;
}

Curve_file read_curve_file(const std::string& path, const Curve_file::Options& options) {
  const std::string text = tool::file_contents(path);
  const bool is_stdin = path == "-";
  return Curve_file::from_text(text, is_stdin ? "stdin" : path,
                               is_stdin ? "stdin" : tool::valid_utf8(std::filesystem::path(path).stem().string()),
                               options);
}

std::size_t close_filled(std::vector<Curve_record>& records) {
  std::size_t count = 0;
  for (Curve_record& record : records) {
    if (record.filling != Curve_record::CLOSED) continue;
    const Xy<double>&start = record.beziers.front().control_points().front(),
          &end = record.beziers.back().control_points().back();
    if (start == end) continue;
    record.beziers.push_back(Bezier_curve_2<double>({end, start}));
    record.closed = true;
    ++count;
  }
  return count;
}

Drawing_2<double> read_drawing(const std::string& path) { return drawing<double>(read_curve_file(path).curves); }

}  // namespace CGAL::Bounding_arcs
