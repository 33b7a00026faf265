// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Dxf_groups.h"

#include "Input_text.h"

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace bounding_arcs_tool {

using CGAL::Bounding_arcs::Input_error;

namespace {

constexpr int COMMENT = 999;  // codes above are extended data of programs

std::string_view stripped(std::string_view line) {
  const auto first = line.find_first_not_of(" \t\r");
  return first == line.npos ? "" : line.substr(first, line.find_last_not_of(" \t\r") - first + 1);
}

template <class Number> bool is_number(std::string_view word, Number& number) {
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  return error == std::errc() && end == word.data() + word.size();
}

std::string found(const Dxf_group& group) {
  return "found " + in_quotes(group.value) + " in group " + std::to_string(group.code);
}

}  // namespace

double real_value(const Dxf_group& group) {
  double x = 0;
  if (!is_number(group.value, x) || std::isnan(x)) throw Dxf_left_out("expected a number, " + found(group));
  if (!(std::abs(x) <= MAXIMUM_COORDINATE)) throw Dxf_left_out("expected at most 2^1000, " + found(group));
  return x;
}

long long integer_value(const Dxf_group& group) {
  long long n = 0;
  if (!is_number(group.value, n)) throw Dxf_left_out("expected an integer, " + found(group));
  return n;
}

const Dxf_group* Dxf_item::find(int code) const {
  const auto is_it = [&](const Dxf_group& group) { return group.code == code; };
  const auto place = std::find_if(groups.begin(), groups.end(), is_it);
  return place == groups.end() ? nullptr : &*place;
}

double Dxf_item::real(int code) const {
  const Dxf_group* group = find(code);
  if (group == nullptr) throw Dxf_left_out("no group " + std::to_string(code));
  return real_value(*group);
}

double Dxf_item::real(int code, double otherwise) const {
  const Dxf_group* group = find(code);
  return group == nullptr ? otherwise : real_value(*group);
}

long long Dxf_item::integer(int code, long long otherwise) const {
  const Dxf_group* group = find(code);
  return group == nullptr ? otherwise : integer_value(*group);
}

std::string Dxf_item::text(int code, const std::string& otherwise) const {
  const Dxf_group* group = find(code);
  return group == nullptr ? otherwise : std::string(group->value);
}

bool is_dxf(std::string_view text) {
  const auto line = [&] {
    const std::string_view first = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(first.size() + 1, text.size()));
    return stripped(first);
  };
  const std::string_view code = line();
  return code == "999" || (code == "0" && line() == "SECTION");
}

std::optional<std::string_view> Dxf_items::next_line() {
  if (text_.empty()) return std::nullopt;
  const std::string_view line = text_.substr(0, text_.find('\n'));
  text_.remove_prefix(std::min(line.size() + 1, text_.size()));
  ++line_;
  return stripped(line);
}

std::optional<Dxf_group> Dxf_items::next_group() {
  auto word = next_line();
  while (word && word->empty() && !has_group_) word = next_line();  // in front of the first group
  has_group_ = true;
  const bool is_behind = text_.find_first_not_of(" \t\r\n") == text_.npos;
  if (!word || (word->empty() && is_behind)) return std::nullopt;  // empty lines may end a file
  int code = 0;
  if (!is_number(*word, code) || code < -5 || code > 1071)
    throw Input_error(file_, "line " + std::to_string(line_), "expected a group code, found " + in_quotes(*word));
  const auto value = next_line();
  if (!value) return std::nullopt;  // cut off between the two
  return Dxf_group{code, *value};
}

std::optional<Dxf_item> Dxf_items::next() {
  while (!begun_) {  // what is in front of the first item
    begun_ = next_group();
    if (!begun_) return std::nullopt;
    if (begun_->code != 0) begun_.reset();
  }
  if (begun_->value == "EOF") {
    has_end_ = true;
    return std::nullopt;
  }
  constexpr int PROGRAM = 1001, STRING = 1000;
  Dxf_item item{begun_->value, {}};
  bool is_ours = false;
  for (begun_ = next_group(); begun_ && begun_->code != 0; begun_ = next_group()) {
    if (begun_->code < COMMENT) item.groups.push_back(*begun_);
    else if (begun_->code == PROGRAM) is_ours = begun_->value == DXF_NAMES;
    else if (begun_->code == STRING && is_ours) item.name = begun_->value;
  }
  item.is_cut = !begun_;
  return item;
}

}  // namespace bounding_arcs_tool
