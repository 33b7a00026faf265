// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tells markup from text only as far as references need it: none counts in comments, CDATA and instructions.

#include "Xml_text.h"

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>
#include "Input_text.h"

#include <algorithm>
#include <iterator>

namespace bounding_arcs_tool {

using CGAL::Bounding_arcs::Input_error;

namespace {

// Keeps the recursion short; programs that write entities nest them once or twice.
constexpr std::size_t MAXIMUM_ENTITY_NESTING = 64;

// How many bytes a reference counts as: entities without text could be nested without end.
constexpr std::size_t BYTES_OF_REFERENCE = 16;

constexpr std::string_view PREDEFINED[] = {"lt", "gt", "amp", "quot", "apos"};

bool is_predefined(std::string_view name) {
  return std::find(std::begin(PREDEFINED), std::end(PREDEFINED), name) != std::end(PREDEFINED);
}

// What runs to its own end, whatever stands in it.
struct Opaque {
  std::string_view start, end;
};
constexpr Opaque OPAQUE[] = {{"<!--", "-->"}, {"<![CDATA[", "]]>"}, {"<?", "?>"}};

// The length of what is opaque at the start of a text, 0 if nothing is.
std::size_t opaque_length(std::string_view text) {
  for (const auto& [start, end] : OPAQUE) {
    if (text.substr(0, start.size()) != start) continue;
    const std::size_t found = text.find(end, start.size());
    return found == text.npos ? text.size() : found + end.size();
  }
  return 0;
}

// The name of the reference at the start of a text, "" for one to a character or none.
std::string_view reference_name(std::string_view text) {
  const std::size_t length = xml_name_length(text.substr(1));
  return text.substr(length + 1, 1) == ";" ? text.substr(1, length) : "";
}

}  // namespace

Xml_text::Xml_text(const std::string& text, const std::string& file, Svg_notes& notes)
    : original_(text), file_(file), notes_(notes) {
  if (text.find('&') == text.npos) return;
  doctype_ = parsed_xml_doctype(text);
  put(std::string_view(text).substr(0, doctype_.end));
  expand_contents(std::string_view(text).substr(doctype_.end));
  if (replacements_.empty()) expanded_ = {};
}

std::string Xml_text::place(std::size_t offset) const {
  const auto after = std::upper_bound(replacements_.begin(), replacements_.end(), offset,
                                      [](std::size_t at, const Replacement& r) { return at < r.start; });
  if (after == replacements_.begin()) return text_place(original_, offset);
  const Replacement& before = *std::prev(after);
  if (offset >= before.end) return text_place(original_, offset - before.end + before.original_end);
  return text_place(original_, before.original_start) + ", entity " + in_quotes(before.entity);
}

void Xml_text::expand_contents(std::string_view text) {
  while (!text.empty()) text.remove_prefix(expand_markup(text));
}

std::size_t Xml_text::expand_markup(std::string_view text) {
  if (const std::size_t opaque = opaque_length(text); opaque > 0) return put(text.substr(0, opaque));
  if (text.front() == '<') return expand_tag(text);
  if (text.front() == '&') return expand_reference(text, false);
  return put(text.substr(0, text.find_first_of("<&")));
}

std::size_t Xml_text::expand_tag(std::string_view text) {
  std::size_t at = 0;
  while (at < text.size() && text[at] != '>') {
    const bool is_value = text[at] == '"' || text[at] == '\'';
    if (is_value) at += expand_value(text.substr(at));
    else at += put(text.substr(at, std::min(text.find_first_of("\"'>", at), text.size()) - at));
  }
  if (at == text.size() && !open_.empty()) fail("expected whole elements, found part of a tag");
  return at + put(text.substr(at, 1));
}

std::size_t Xml_text::expand_value(std::string_view text) {
  const std::size_t end = std::min(text.find(text.front(), 1), text.size());
  std::size_t at = put(text.substr(0, 1));
  while (at < end) {
    const std::string_view rest = text.substr(at, end - at);
    at += rest.front() == '&' ? expand_reference(rest, true) : put(rest.substr(0, rest.find('&')));
  }
  return end + put(text.substr(end, 1));
}

std::size_t Xml_text::expand_reference(std::string_view text, bool in_value) {
  const std::string_view name = reference_name(text);
  if (name.empty() || is_predefined(name)) return put(text.substr(0, 1));
  const std::size_t length = name.size() + 2;
  const bool is_outermost = open_.empty();
  const auto offset = static_cast<std::size_t>(text.data() - original_.data());  // of an outermost one
  const std::size_t start = expanded_.size();
  const auto entity = doctype_.entities.find(name);
  if (entity == doctype_.entities.end()) {
    const bool is_external = doctype_.external.count(name) > 0;
    notes_.add("entity", is_external ? "is not in this file" : "is not declared", Svg_notes::LEFT_OUT,
               [&] { return in_quotes(name); });
    return put(text.substr(0, length));
  }
  if (is_outermost) replacements_.push_back({start, start, offset, offset + length, name});
  expand_entity(name, in_value);
  if (is_outermost) replacements_.back().end = expanded_.size();
  return length;
}

void Xml_text::expand_entity(std::string_view name, bool in_value) {
  const bool is_open = std::find(open_.begin(), open_.end(), name) != open_.end();
  open_.push_back(name);
  if (is_open) fail("expected an entity that does not contain itself");
  if (open_.size() > MAXIMUM_ENTITY_NESTING)
    fail("expected entities nested at most " + std::to_string(MAXIMUM_ENTITY_NESTING) + " levels deep, found more");
  count(BYTES_OF_REFERENCE);
  const std::string_view text = doctype_.entities.find(name)->second;
  if (in_value) expand_literal(text);
  else expand_contents(text);
  open_.pop_back();
}

// In an attribute, quotes of an entity are characters as others are.
void Xml_text::expand_literal(std::string_view text) {
  while (!text.empty()) {
    const char first = text.front();
    std::size_t length = 1;
    if (first == '&') length = expand_reference(text, true);
    else if (first == '"') put("&quot;");
    else if (first == '\'') put("&apos;");
    else if (first == '<') put("&lt;");
    else length = put(text.substr(0, text.find_first_of("&\"'<")));
    text.remove_prefix(length);
  }
}

std::size_t Xml_text::put(std::string_view text) {
  count(open_.empty() ? 0 : text.size());
  expanded_ += text;
  return text.size();
}

void Xml_text::count(std::size_t bytes) {
  added_ += bytes;
  if (added_ > MAXIMUM_SVG_SIZE)
    fail("expected at most " + std::to_string(MAXIMUM_SVG_SIZE) + " bytes of SVG added by entities, found more");
}

void Xml_text::fail(const std::string& reason) const {
  const std::string entity = ", entity " + in_quotes(open_.back());
  throw Input_error(file_, text_place(original_, replacements_.back().original_start) + entity, reason);
}

}  // namespace bounding_arcs_tool
