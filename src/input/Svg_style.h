// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The properties of an SVG element, and what the reader says of those that it does not read.

#ifndef BOUNDING_ARCS_TOOL_SVG_STYLE_H
#define BOUNDING_ARCS_TOOL_SVG_STYLE_H

#include "Svg_notes.h"

#include <pugixml.hpp>

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace bounding_arcs_tool {

/// What an element sets its properties to, by its style attribute or else by an attribute of the property's name.
/// Values are in small letters, without comments and without space around them. Style sheets play no part.
class Svg_style {
 public:
  /// The element must outlive this.
  explicit Svg_style(const pugi::xml_node& element);

  /// The value that the style attribute declares last, or last among important ones; "" if it declares none.
  /// \param accepted values that count, where the list is not empty
  [[nodiscard]] std::string declared(std::string_view property,
                                     std::initializer_list<std::string_view> accepted = {}) const;
  /// The value by the style attribute, else by the attribute; "" if there is none.
  [[nodiscard]] std::string value(const char* property, std::initializer_list<std::string_view> accepted = {}) const;

  /// Notes the properties of an element that change what is seen and are not read.
  void note_unread(std::string_view element, Svg_notes& notes) const;

 private:
  struct Declaration {
    std::string property, value;
    bool is_important = false;
  };

  static Declaration declaration(std::string_view text);

  pugi::xml_node element_;
  std::vector<Declaration> declarations_;
};

/// Whether a style sheet sets a property of anything.
[[nodiscard]] bool is_in_svg_style_sheet(std::string_view text, std::string_view property);
/// Notes a style sheet that sets properties which would play a part.
void note_svg_style_sheet(std::string_view text, Svg_notes& notes);

}  // namespace bounding_arcs_tool

#endif
