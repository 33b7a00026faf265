// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Json_place.h"

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>
#include "Input_text.h"

namespace bounding_arcs_tool {

using CGAL::Bounding_arcs::Input_error;

namespace {

// Curve files need 5 levels; the bound keeps paths, and the parser's own stack, short.
constexpr std::size_t MAXIMUM_JSON_NESTING = 64;

}  // namespace

std::string Json_place::path() const {
  std::string path;
  for (const Level& level : levels_)
    if (level.is_list) path += '[' + std::to_string(level.index) + ']';
    else if (!level.key.empty()) path += (path.empty() ? "" : ".") + level.key;
  return path.empty() ? "document" : path;
}

void Json_place::enter_key(const std::string& key) {
  Level& level = levels_.back();
  level.key.clear();
  if (!level.keys.insert(key).second)
    throw Input_error(file_, path(), "expected each key once, found " + in_quotes(key) + " twice");
  level.key = key;
}

void Json_place::open(bool is_list) {
  if (levels_.size() == MAXIMUM_JSON_NESTING)
    throw Input_error(
        file_, path(),
        "expected at most " + std::to_string(MAXIMUM_JSON_NESTING) + " levels of lists and objects, found more");
  levels_.emplace_back().is_list = is_list;
}

std::size_t Json_place::close() {
  const std::size_t count = levels_.back().index;
  levels_.pop_back();
  return count;
}

void Json_place::pass() {
  if (!levels_.empty() && levels_.back().is_list) ++levels_.back().index;
}

}  // namespace bounding_arcs_tool
