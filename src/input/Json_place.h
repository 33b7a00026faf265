// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a JSON parser is: the path to the value that it reads, such as curves[2].control_points[5][0].

#ifndef BOUNDING_ARCS_TOOL_JSON_PLACE_H
#define BOUNDING_ARCS_TOOL_JSON_PLACE_H

#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace bounding_arcs_tool {

/// Follows a parser event by event. Invariant: path() is the place of the value that is read next or now. The name of
/// the file must outlive it.
class Json_place {
 public:
  explicit Json_place(const std::string& file) : file_(file) {}

  [[nodiscard]] const std::string& file() const { return file_; }
  /// The path, "document" for the whole.
  [[nodiscard]] std::string path() const;
  /// The last key of the innermost object.
  [[nodiscard]] const std::string& key() const { return levels_.back().key; }

  /// \throws Input_error for a key that its object has already
  void enter_key(const std::string& key);
  /// Goes into a list or an object. \throws Input_error deeper than 64 levels
  void open(bool is_list);
  /// Goes back to where the list or object itself stands.
  /// \return how many values a list had
  std::size_t close();
  /// Goes past a value that was read.
  void pass();

 private:
  struct Level {
    bool is_list = false;
    std::size_t index = 0;
    std::string key;
    std::set<std::string> keys;
  };

  const std::string& file_;
  std::vector<Level> levels_;
};

}  // namespace bounding_arcs_tool

#endif
