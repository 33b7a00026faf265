// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// An SVG document: its text as a tree, its elements by id, and errors that name the place of an element.

#ifndef BOUNDING_ARCS_TOOL_SVG_DOCUMENT_H
#define BOUNDING_ARCS_TOOL_SVG_DOCUMENT_H

#include "Svg_element.h"

#include <string>
#include <string_view>
#include <unordered_map>

namespace bounding_arcs_tool {

/// A well-formed XML document with the root element svg, whose SVG elements have names without prefixes. The text and
/// the name of the file must outlive it.
class Svg_document {
 public:
  /// \throws Input_error for XML that is not well-formed and for another root element
  Svg_document(const std::string& text, const std::string& file);

  [[nodiscard]] Svg_element root() const { return Svg_element(tree_.document_element()); }
  /// The length of the text in bytes.
  [[nodiscard]] std::size_t size() const { return text_.size(); }
  /// The first element of an id, or none.
  [[nodiscard]] pugi::xml_node by_id(std::string_view id) const;

  /// \throws Input_error with the line, column, name and id of the element and, from `error`, attribute and character
  [[noreturn]] void fail(const Svg_element& element, const std::string& reason, const Svg_error* error = nullptr) const;

  /// Does what reads attributes of an element, and names the element in what it throws.
  template <class Action> void guarded(const Svg_element& element, Action action) const {
    try {
      action();
    } catch (const Svg_error& error) {
      fail(element, error.what(), &error);
    }
  }

 private:
  void parse();
  void walk();

  const std::string& text_;
  const std::string& file_;
  pugi::xml_document tree_;
  std::unordered_map<std::string_view, pugi::xml_node> by_id_;
};

}  // namespace bounding_arcs_tool

#endif
