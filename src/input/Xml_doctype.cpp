// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Goes through the declarations from left to right; what it does not know it passes over.

#include "Xml_doctype.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <system_error>
#include <utility>

namespace bounding_arcs_tool {

namespace {

constexpr std::string_view SPACE = " \t\r\n";

bool starts_with(std::string_view text, std::string_view head) { return text.substr(0, head.size()) == head; }

// The code of a reference such as &#60; or &#x3C; at the start of a text, and the length of the reference; a length of
// 0 if there is none.
struct Character_reference {
  unsigned code = 0;
  std::size_t length = 0;
};

Character_reference character_reference(std::string_view text) {
  if (!starts_with(text, "&#")) return {};
  const bool is_hexadecimal = text.substr(2, 1) == "x";
  const char* const first = text.data() + (is_hexadecimal ? 3 : 2);
  const char* const last = text.data() + text.size();
  unsigned code = 0;
  const auto [end, status] = std::from_chars(std::min(first, last), last, code, is_hexadecimal ? 16 : 10);
  if (status != std::errc() || end == last || *end != ';') return {};
  return {code, static_cast<std::size_t>(end + 1 - text.data())};
}

// An entity's text has its references to characters replaced. Those beyond ASCII wait for the parser, which knows the
// encoding of the file.
std::string with_characters(std::string_view value) {
  std::string result;
  while (!value.empty()) {
    const Character_reference reference = character_reference(value);
    const bool is_ascii = reference.length > 0 && reference.code > 0 && reference.code < 0x80;
    if (is_ascii) result += static_cast<char>(reference.code);
    else result += value.front();
    value.remove_prefix(is_ascii ? reference.length : 1);
  }
  return result;
}

class Doctype_parser {
 public:
  explicit Doctype_parser(std::string_view text) : text_(text) {}

  Xml_doctype parse() {
    accept("\xEF\xBB\xBF");
    while (skip_space(), pass("<?", "?>") || pass("<!--", "-->")) continue;
    result_.end = at_;
    if (!accept("<!DOCTYPE")) return std::move(result_);
    while (at_ < text_.size() && next() != '[' && next() != '>')
      if (!skip_literal()) ++at_;
    if (accept("[")) parse_subset();
    skip_space();
    if (accept(">")) result_.end = at_;
    else result_ = {text_.size(), {}, {}};  // the parser will say what is wrong
    return std::move(result_);
  }

 private:
  void parse_subset() {
    while (at_ < text_.size() && !accept("]")) {
      if (pass("<?", "?>") || pass("<!--", "-->")) continue;
      if (accept("<!ENTITY")) parse_entity();
      else if (accept("<!")) skip_declaration();
      else ++at_;
    }
  }

  void parse_entity() {
    skip_space();
    const std::string_view name = text_.substr(at_, xml_name_length(text_.substr(at_)));
    at_ += name.size();
    skip_space();
    // The first declaration of a name counts.
    const bool is_known = result_.entities.count(name) + result_.external.count(name) > 0;
    const std::size_t start = at_;
    if (!name.empty() && !is_known) {
      if (skip_literal()) result_.entities.emplace(name, with_characters(text_.substr(start + 1, at_ - start - 2)));
      else result_.external.insert(name);
    }
    skip_declaration();
  }

  void skip_declaration() {
    while (at_ < text_.size() && !accept(">"))
      if (!skip_literal()) ++at_;
  }

  // Passes over text between quotes.
  bool skip_literal() {
    const char quote = next();
    if (quote != '"' && quote != '\'') return false;
    const std::size_t end = text_.find(quote, at_ + 1);
    if (end == text_.npos) return false;
    at_ = end + 1;
    return true;
  }

  bool pass(std::string_view start, std::string_view end) {
    if (!accept(start)) return false;
    const std::size_t found = text_.find(end, at_);
    at_ = found == text_.npos ? text_.size() : found + end.size();
    return true;
  }

  bool accept(std::string_view word) {
    if (!starts_with(text_.substr(at_), word)) return false;
    at_ += word.size();
    return true;
  }

  void skip_space() { at_ = std::min(text_.find_first_not_of(SPACE, at_), text_.size()); }

  [[nodiscard]] char next() const { return at_ < text_.size() ? text_[at_] : '\0'; }

  std::string_view text_;
  std::size_t at_ = 0;
  Xml_doctype result_;
};

}  // namespace

std::size_t xml_name_length(std::string_view text) {
  const auto is_part = [](char c) {
    const bool is_letter = ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || c == '_' || c == ':';
    return is_letter || ('0' <= c && c <= '9') || c == '-' || c == '.' || static_cast<unsigned char>(c) >= 0x80;
  };
  return static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), is_part) - text.begin());
}

Xml_doctype parsed_xml_doctype(std::string_view text) { return Doctype_parser(text).parse(); }

}  // namespace bounding_arcs_tool
