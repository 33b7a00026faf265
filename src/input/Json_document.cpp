// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The JSON parser is told to report its events, from which the path to the current value follows.

#include "Json_document.h"

#include "Curve_file.h"
#include "Input_text.h"

#include <set>

namespace bounding_arcs_tool {

namespace {

using nlohmann::json;

// Curve files need 5 levels; the bound keeps every later walk over a document, recursive or not, shallow.
constexpr std::size_t MAXIMUM_NESTING = 64;

// Follows the parser through a document. Invariant: path() is the place of the value that is read next or now.
class Json_follower {
 public:
  explicit Json_follower(const std::string& file) : file_(file) {}

  bool follow(json::parse_event_t event, const json& value) {
    using Event = json::parse_event_t;
    if (event == Event::key) enter_key(value.get_ref<const std::string&>());
    if (event == Event::object_start || event == Event::array_start) open(event == Event::array_start);
    if (event == Event::object_end || event == Event::array_end) levels_.pop_back();
    const bool value_ends = event == Event::value || event == Event::object_end || event == Event::array_end;
    if (value_ends && !levels_.empty() && levels_.back().is_array) ++levels_.back().index;
    return true;
  }

  [[nodiscard]] std::string path() const {
    std::string path;
    for (const Level& level : levels_)
      if (level.is_array)
        path += '[' + std::to_string(level.index) + ']';
      else if (!level.key.empty())
        path += (path.empty() ? "" : ".") + level.key;
    return path.empty() ? "document" : path;
  }

 private:
  struct Level {
    bool is_array = false;
    std::size_t index = 0;
    std::string key;
    std::set<std::string> keys;
  };

  void enter_key(const std::string& key) {
    Level& level = levels_.back();
    level.key.clear();
    if (!level.keys.insert(key).second)
      throw Input_error(file_, path(), "the key " + in_quotes(key) + " appears twice");
    level.key = key;
  }

  void open(bool is_array) {
    if (levels_.size() == MAXIMUM_NESTING)
      throw Input_error(file_, path(), "nested deeper than " + std::to_string(MAXIMUM_NESTING) + " levels");
    levels_.emplace_back().is_array = is_array;
  }

  const std::string& file_;
  std::vector<Level> levels_;
};

// What the parser says without its own prefix "[json.exception...] parse error at line 1, column 2: ".
std::string bare_reason(const std::string& what) {
  const std::size_t column = what.find("column ");
  const std::size_t end = column == what.npos ? what.find("] ") : what.find(": ", column);
  return end == what.npos ? what : what.substr(end + 2);
}

}  // namespace

json parsed_json(const std::string& text, const std::string& file) {
  Json_follower follower(file);
  try {
    return json::parse(text,
                       [&](int, json::parse_event_t event, json& value) { return follower.follow(event, value); });
  } catch (const json::parse_error& error) {
    throw Input_error(file, text_place(text, error.byte > 0 ? error.byte - 1 : 0), bare_reason(error.what()));
  } catch (const json::out_of_range& error) {
    throw Input_error(file, follower.path(), "expected a finite number: " + bare_reason(error.what()));
  }
}

}  // namespace bounding_arcs_tool
