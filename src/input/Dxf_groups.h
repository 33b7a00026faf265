// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The text of a DXF file as items: each begins with a group of code 0, which is its kind, and has the groups up to the
// next one. A group is two lines, a code and a value.

#ifndef BOUNDING_ARCS_TOOL_DXF_GROUPS_H
#define BOUNDING_ARCS_TOOL_DXF_GROUPS_H

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace bounding_arcs_tool {

/// Why an item is left out, in a clause: "radius 0".
struct Dxf_left_out : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The program in whose extended data names of curves are.
constexpr const char* DXF_NAMES = "BOUNDING_ARCS";

struct Dxf_group {
  int code;
  std::string_view value;  ///< without spaces around it
};

/// \throws Dxf_left_out for a value that is no number, or exceeds 2^1000
[[nodiscard]] double real_value(const Dxf_group& group);
/// \throws Dxf_left_out for a value that is no integer
[[nodiscard]] long long integer_value(const Dxf_group& group);

/// An item, a view of the text: an entity, a vertex, the begin or end of a section, and so on.
struct Dxf_item {
  std::string_view kind;
  std::vector<Dxf_group> groups;  ///< without its kind, comments and extended data
  bool is_cut = false;            ///< the text ends in it
  std::string_view name = {};     ///< in the extended data of DXF_NAMES; empty for none

  /// The first group with a code; nothing where there is none.
  [[nodiscard]] const Dxf_group* find(int code) const;
  /// \throws Dxf_left_out where there is no such group, or its value is wrong
  [[nodiscard]] double real(int code) const;
  /// Values for groups that may be left out. \throws Dxf_left_out for a value that is wrong
  [[nodiscard]] double real(int code, double otherwise) const;
  [[nodiscard]] long long integer(int code, long long otherwise) const;
  [[nodiscard]] std::string text(int code, const std::string& otherwise) const;
};

/// Does the text begin as a DXF file does, with a section or a comment?
[[nodiscard]] bool is_dxf(std::string_view text);

/// Goes through the items of a text up to that of kind EOF. Lines may be as long as they are.
class Dxf_items {
 public:
  Dxf_items(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {}

  /// The next item, nothing behind the last one. \throws Input_error with the line for what is no group code
  [[nodiscard]] std::optional<Dxf_item> next();
  /// Whether EOF was there.
  [[nodiscard]] bool has_end() const { return has_end_; }

 private:
  [[nodiscard]] std::optional<std::string_view> next_line();
  [[nodiscard]] std::optional<Dxf_group> next_group();

  std::string_view text_;
  std::string file_;
  std::size_t line_ = 0;
  std::optional<Dxf_group> begun_;  // the kind of the next item, which ended the one before
  bool has_group_ = false, has_end_ = false;
};

}  // namespace bounding_arcs_tool

#endif
