// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The text of an XML document in which references to its entities are replaced by what they stand for.
// Invariant: at most MAXIMUM_SVG_SIZE bytes are added; places are those of the file.

#ifndef BOUNDING_ARCS_TOOL_XML_TEXT_H
#define BOUNDING_ARCS_TOOL_XML_TEXT_H

#include "Svg_notes.h"
#include "Xml_doctype.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace bounding_arcs_tool {

/// What the parser of XML is given, which knows no entities but those of every document.
class Xml_text {
 public:
  /// Replaces entities that the document declares by their text. Notes references to all others, which stay.
  /// \param text must outlive this, as must `file` and `notes`
  /// \throws Input_error for an entity that contains itself, or part of a tag, and for too many bytes
  Xml_text(const std::string& text, const std::string& file, Svg_notes& notes);

  [[nodiscard]] const std::string& text() const { return replacements_.empty() ? original_ : expanded_; }
  /// The line and column in the file of a byte of text(), and the name of the entity if it is of one.
  [[nodiscard]] std::string place(std::size_t offset) const;

 private:
  // A reference of the document itself, and what stands for it in the expanded text.
  struct Replacement {
    std::size_t start, end;                    // in the expanded text
    std::size_t original_start, original_end;  // in the file
    std::string_view entity;
  };

  // Each of these takes what is at the start of a text, and returns its length there.
  std::size_t expand_markup(std::string_view text);
  std::size_t expand_tag(std::string_view text);
  std::size_t expand_value(std::string_view text);
  std::size_t expand_reference(std::string_view text, bool in_value);
  void expand_contents(std::string_view text);
  void expand_entity(std::string_view name, bool in_value);
  void expand_literal(std::string_view text);

  std::size_t put(std::string_view text);
  void count(std::size_t bytes);
  [[noreturn]] void fail(const std::string& reason) const;

  const std::string& original_;
  const std::string& file_;
  Svg_notes& notes_;
  Xml_doctype doctype_;
  std::string expanded_;
  std::vector<Replacement> replacements_;
  std::vector<std::string_view> open_;  // entities around the current place, the outermost first
  std::size_t added_ = 0;               // bytes of entities, and of references to them
};

}  // namespace bounding_arcs_tool

#endif
