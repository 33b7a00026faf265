// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Read_file.h"

#include "../input/Input_text.h"
#include "Elapsed_line.h"
#include "loose_ends.h"
#include "number_text.h"
#include "option_words.h"
#include "usage.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <optional>
#include <set>
#include <string_view>

namespace bounding_arcs_tool {
namespace {

namespace ba = CGAL::Bounding_arcs;

std::string joined_text(const ba::Joined_curves& joined) {
  if (joined.joints == 0) return "";
  std::size_t parts = 0, closed = 0, open = 0;
  for (const std::size_t i : joined.joined) {
    parts += joined.parts[i].size();
    ++(joined.drawing.curves()[i].is_closed ? closed : open);
  }
  std::string to = closed > 0 ? std::to_string(closed) + " closed" : "";
  if (open > 0) to += (closed > 0 ? " and " : "") + std::to_string(open) + " open";
  return "joined: " + count_text(parts, "open curve") + " to " + to + (closed + open == 1 ? " one" : " ones") +
         (joined.moved > 0 ? ", ends moved by up to " + short_number(joined.moved) : "");
}

std::string ambiguous_text(const std::vector<Xy<double>>& places) {
  if (places.empty()) return "";
  return "ambiguous: more than two ends meet at " + count_text(places.size(), "place") +
         (places.size() == 1 ? ", " : ", the first ") + place_text(places.front()) + ", and are not joined";
}

// Names of layers have no case in DXF.
std::string layer_key(const std::string& name) {
  std::string key = name;
  for (char& c : key) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return key;
}

// The curves of one element have its name, a point and a number.
bool is_called(const std::string& name, const std::string& asked) {
  if (name.compare(0, asked.size(), asked) != 0) return false;
  const std::string_view rest = std::string_view(name).substr(asked.size());
  return rest.empty() || (rest.size() > 1 && rest.front() == '.' &&
                          std::all_of(rest.begin() + 1, rest.end(), [](char c) { return c >= '0' && c <= '9'; }));
}

// Leaves what one of some words fits, each of which has to fit something.
template <class Fits>
void select(Read_file& read, const std::vector<std::string>& words, const Fits& fits, const std::string& file,
            const std::string& option, const std::string& what) {
  const std::vector<Curve_record>& curves = read.file.curves;
  for (const std::string& word : words)
    if (std::none_of(curves.begin(), curves.end(), [&](const Curve_record& r) { return fits(r, word); }))
      throw ba::Input_error(file, option, "expected " + what + ", found " + in_quotes(word));
  read.keep_if([&](std::size_t i) {
    return std::any_of(words.begin(), words.end(), [&](const std::string& word) { return fits(curves[i], word); });
  });
}

std::string layers_of(const std::vector<Curve_record>& curves) {
  std::set<std::string> layers;
  for (const Curve_record& record : curves)
    if (!record.layer.empty()) layers.insert(record.layer);
  if (layers.empty()) return "a file with layers";
  return "layers that have curves, " + one_of_text({layers.begin(), layers.end()});
}

// \return what is said of it
std::string convert(ba::Curve_file& file, const File_unit& wanted, const std::string& name) {
  if (wanted.in_mm == 0 || file.curves.empty()) return "";
  const bool is_by_word = wanted.file.empty();
  const std::string word = word_of_unit(wanted.in_mm);
  if (file.unit_in_mm == 0) {
    tell_unit(file, wanted.in_mm);
    return is_by_word ? "no unit told: 1 unit is taken for 1 " + word : taken_unit_text(wanted);
  }
  if (is_same_unit(file.unit_in_mm, wanted.in_mm)) return "";
  const std::string from = unit_text(file.unit_in_mm);
  convert_to_unit(file, wanted.in_mm, name);
  const std::string to =
      is_by_word ? word : "units of " + unit_text(wanted.in_mm) + ", as in " + one_line(wanted.file, std::string::npos);
  return "converted from units of " + from + " to " + to;
}

}  // namespace

Read_file read_file(const std::string& path, const Reading_words& words) {
  const std::string name = name_of_file(path);
  std::optional<Elapsed_line> elapsed;
  if (path != "-") elapsed.emplace("reading " + one_line(name, std::string::npos));  // who types needs no clock
  Read_file read;
  read.file = read_curve_file(path, reading_options(words));
  read.converted = convert(read.file, words.unit, name);
  read.parts.assign(read.file.curves.size(), 1);
  if (!words.layers.empty())
    select(
        read, words_between_commas(words.layers),
        [](const Curve_record& r, const std::string& word) { return layer_key(r.layer) == layer_key(word); }, name,
        "--layers", layers_of(read.file.curves));
  if (words.join != "none" && !(words.join.empty() && read.file.rounding == 0)) {
    const double eps = words.join.empty() ? read.file.rounding : std::strtod(words.join.c_str(), nullptr);
    if (!words.join.empty())
      for (Curve_record& record : read.file.curves) record.end_error = 0;  // no end is to be moved farther than told
    const ba::Joined_curves joined = join_curves(read.file.curves, eps, !words.join.empty());
    read.parts.clear();
    for (const auto& parts : joined.parts) read.parts.push_back(parts.size());
    read.joined = joined_text(joined);
    read.ambiguous = ambiguous_text(joined.crowded);
    read.moved = joined.moved;
  }
  if (!words.ids.empty())
    select(
        read, words_between_commas(words.ids),
        [](const Curve_record& r, const std::string& word) { return is_called(r.name, word); }, name, "--ids",
        "names of curves, which the subcommand info lists");
  return read;
}

void skip_open(const std::string& name, Read_file& read) {
  const ba::Drawing_2<double> drawing = ba::drawing<double>(read.file.curves);
  const Loose_ends ends = loose_ends(drawing);
  if (ends.open == 0) return;
  if (ends.open == read.file.curves.size())
    throw ba::Input_error(name, "--skip-open", "expected a closed curve, found " + ends.text());
  read.skipped = "left out: " + ends.text();
  read.keep_if([&](std::size_t i) { return drawing.curves()[i].is_closed; });
}

}  // namespace bounding_arcs_tool
