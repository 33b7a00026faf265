// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The readers: what they take can be made curves of, the rest is refused in one line.

#include "targets.h"

#include "../../src/input/Curve_readers.h"
#include "../../src/tool/stream/answer_line.h"

#include <nlohmann/json.hpp>

#include <ostream>
#include <string>
#include <vector>

namespace bounding_arcs_fuzz {
namespace {

using bounding_arcs_tool::Curve_record;
using bounding_arcs_tool::Input_error;

std::string text_of(const std::uint8_t* data, std::size_t size) { return {data, data + size}; }

// Only JSON has drawings of nothing.
enum class Nothing { ALLOWED, REFUSED };

template <class Read> void read(Nothing nothing, const Read& read_records) {
  try {
    const std::vector<Curve_record> records = read_records();
    expect(!records.empty() || nothing == Nothing::ALLOWED, "a file that is read has a curve");
    for (const Curve_record& record : records) expect(!record.bezier_pieces<double>().empty(), "a curve has a piece");
  } catch (const Input_error& error) {
    const std::string_view line = error.what();
    expect(line.substr(0, 6) == "file: ", "an error names the file");
    expect(line.find('\n') == line.npos, "an error is one line");
  }
}

}  // namespace

void json(const std::uint8_t* data, std::size_t size) {
  read(Nothing::ALLOWED,
       [&] { return bounding_arcs_tool::read_json_curves(text_of(data, size), "file", "stem").curves; });
}
void svg(const std::uint8_t* data, std::size_t size) {
  for (const bool all : {false, true})
    read(Nothing::REFUSED, [&] {
      return bounding_arcs_tool::read_svg_curves(text_of(data, size), "file", {all, all}).curves;
    });
}
void dxf(const std::uint8_t* data, std::size_t size) {
  for (const bool all : {false, true})
    read(Nothing::REFUSED, [&] {
      return bounding_arcs_tool::read_dxf_curves(text_of(data, size), "file", {all, all}).curves;
    });
}

void stream(const std::uint8_t* data, std::size_t size) {
  const auto answer = [](std::vector<Curve_record>&& records, std::ostream& out) {
    out << "{\"curves\":[\n";
    const char* between = "";
    for (const Curve_record& record : records) {
      out << between << nlohmann::json(record.name).dump() << '\n';
      between = ",";
    }
    out << "]}\n";
  };
  std::string out;
  const bool is_result = bounding_arcs_tool::answer_line({7, text_of(data, size)}, answer, out);
  expect(out.find('\n') == out.size() - 1, "an answer is one line");
  const auto document = nlohmann::json::parse(out);  // throws what nobody catches
  expect(document.contains("error") != is_result, "an answer is a result or an error");
  expect(is_result || document["line"] == 7, "an error tells its line");
}

}  // namespace bounding_arcs_fuzz
