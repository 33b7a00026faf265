// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parsing the text, and the places of elements in it.

#include "Svg_document.h"

#include "Input_text.h"
#include "Svg_namespaces.h"

#include <algorithm>
#include <cstddef>

namespace bounding_arcs_tool {

namespace {

constexpr std::size_t LONGEST_NAME = 40;

}  // namespace

Svg_document::Svg_document(const std::string& text, const std::string& file, Svg_notes& notes)
    : file_(file), notes_(notes), xml_(text, file, notes) {
  parse();
  walk();
  if (root().name() != "svg") fail(root(), "expected the root element svg, found another one");
  for (const pugi::xml_node& other : tree_.children())
    if (other.type() == pugi::node_element && other != root().node())
      fail(Svg_element(other), "expected one root element, found a second one");
}

void Svg_document::parse() {
  const std::string& text = xml_.text();
  const std::size_t nul = text.find('\0');
  if (nul != text.npos) throw Input_error(file_, xml_.place(nul), "expected XML, found a NUL byte");
  const pugi::xml_parse_result result = tree_.load_buffer(text.data(), text.size());
  const auto offset = static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0));
  if (!result) throw Input_error(file_, xml_.place(offset), std::string("XML: ") + result.description());
}

// Names elements by their namespaces, and finds their ids; without recursion, as the document may be deep.
void Svg_document::walk() {
  Svg_namespaces namespaces;
  for (pugi::xml_node node = tree_.document_element(); node;) {
    namespaces.enter(node);
    const Svg_element element(node);
    if (!element.id().empty()) by_id_.emplace(element.id(), node);
    if (element.name() == "style") note_style_sheet(node);
    if (node.first_child()) {
      node = node.first_child();
      continue;
    }
    while (node && !node.next_sibling()) {
      namespaces.leave(node);
      node = node.parent();
    }
    namespaces.leave(node);
    node = node.next_sibling();
  }
}

pugi::xml_node Svg_document::by_id(std::string_view id) const {
  const auto found = by_id_.find(id);
  return found == by_id_.end() ? pugi::xml_node() : found->second;
}

void Svg_document::note_style_sheet(const pugi::xml_node& style) {
  std::string sheet;
  for (const pugi::xml_node& text : style.children()) sheet += text.value();
  note_svg_style_sheet(sheet, notes_);
  has_sheet_that_fills_ = has_sheet_that_fills_ || is_in_svg_style_sheet(sheet, "fill");
}

std::string Svg_document::place(const Svg_element& element, const Svg_error* error) const {
  const std::ptrdiff_t offset = element.node().offset_debug();
  std::string place = xml_.place(static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0)));
  const std::string name = one_line(element.node().name(), LONGEST_NAME);
  place += name == ":" ? ", <an element of another namespace" : ", <" + name;
  if (!element.id().empty()) place += " id=" + in_quotes(element.id());
  place += '>';
  if (error != nullptr && !error->attribute.empty()) place += ", attribute " + error->attribute;
  if (error != nullptr && error->character > 0) place += ", character " + std::to_string(error->character);
  return place;
}

Input_error Svg_document::error(const Svg_element& element, const Svg_error& error) const {
  return {file_, place(element, &error), error.what()};
}

void Svg_document::fail(const Svg_element& element, const std::string& reason) const {
  throw Input_error(file_, place(element), reason);
}

}  // namespace bounding_arcs_tool
