// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// An SVG document: its text as a tree, its elements by id, and errors that name the place of an element.

#ifndef BOUNDING_ARCS_TOOL_SVG_DOCUMENT_H
#define BOUNDING_ARCS_TOOL_SVG_DOCUMENT_H

#include "Svg_element.h"
#include "Svg_notes.h"
#include "Xml_text.h"

#include <string>
#include <string_view>
#include <unordered_map>

namespace bounding_arcs_tool {

using CGAL::Bounding_arcs::Input_error;

/// A well-formed XML document with the root element svg, whose SVG elements have names without prefixes. The text, the
/// name of the file and the notes must outlive it.
class Svg_document {
 public:
  /// Notes entities and style sheets that are not read.
  /// \throws Input_error for XML that is not well-formed, for another root element, and for what Xml_text refuses
  Svg_document(const std::string& text, const std::string& file, Svg_notes& notes);

  [[nodiscard]] Svg_element root() const { return Svg_element(tree_.document_element()); }
  /// The length of the text in bytes, its entities replaced.
  [[nodiscard]] std::size_t size() const { return xml_.text().size(); }
  /// The first element of an id, or none.
  [[nodiscard]] pugi::xml_node by_id(std::string_view id) const;

  /// Whether a style sheet says what is filled.
  [[nodiscard]] bool has_sheet_that_fills() const { return has_sheet_that_fills_; }

  /// The line, column, name and id of the element and, from `error`, attribute and character.
  [[nodiscard]] std::string place(const Svg_element& element, const Svg_error* error = nullptr) const;
  /// The error about what stands at the place of an element.
  [[nodiscard]] Input_error error(const Svg_element& element, const Svg_error& error) const;
  /// \throws Input_error that names the place of the element
  [[noreturn]] void fail(const Svg_element& element, const std::string& reason) const;

 private:
  void parse();
  void walk();
  void note_style_sheet(const pugi::xml_node& style);

  const std::string& file_;
  Svg_notes& notes_;
  Xml_text xml_;
  pugi::xml_document tree_;
  std::unordered_map<std::string_view, pugi::xml_node> by_id_;
  bool has_sheet_that_fills_ = false;
};

}  // namespace bounding_arcs_tool

#endif
