// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The grammar of style attributes, and lists of properties.

#include "Svg_style.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <set>

namespace bounding_arcs_tool {

namespace {

// Properties that the reader takes from attributes or style attributes.
constexpr std::string_view READ[] = {"display",   "visibility",       "fill-rule",
                                     "transform", "transform-origin", "transform-box"};

// Properties that set geometry where they stand in style, and are not read there.
constexpr std::string_view GEOMETRY[] = {"cx", "cy", "d", "height",    "offset", "offset-path", "r", "rotate",
                                         "rx", "ry", "x", "translate", "scale",  "width",       "y"};

// Properties that clip, or draw beside the curves, unless they are none.
struct Effect {
  const char* property;
  const char* reason;
};
constexpr Effect EFFECTS[] = {
    {"clip-path", "its clip-path cuts nothing off"}, {"mask", "its mask cuts nothing off"},
    {"marker", "its markers are left out"},          {"marker-start", "its markers are left out"},
    {"marker-mid", "its markers are left out"},      {"marker-end", "its markers are left out"}};

template <class List> bool contains(const List& list, std::string_view word) {
  return std::find(std::begin(list), std::end(list), word) != std::end(list);
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view SPACE = " \t\r\n\f";
  const std::size_t start = std::min(text.find_first_not_of(SPACE), text.size());
  return text.substr(start, text.find_last_not_of(SPACE) + 1 - start);
}

// The text in small letters, with a space for each comment.
std::string plain(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t comment = std::min(text.find("/*"), text.size());
    for (const unsigned char c : text.substr(0, comment)) result += static_cast<char>(std::tolower(c));
    if (comment == text.size()) break;
    result += ' ';
    const std::size_t end = text.find("*/", comment + 2);
    text.remove_prefix(end == text.npos ? text.size() : end + 2);
  }
  return result;
}

// Where the declaration at the start of a text ends: at a semicolon outside of quotes and brackets.
std::size_t declaration_length(std::string_view text) {
  char quote = '\0';
  int brackets = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quote != '\0') quote = c == quote ? '\0' : quote;
    else if (c == '"' || c == '\'') quote = c;
    else if (c == '(') ++brackets;
    else if (c == ')') --brackets;
    else if (c == ';' && brackets <= 0) return i;
  }
  return text.size();
}

// The names of declarations in rules: what stands between a brace or semicolon and a colon.
std::set<std::string_view> declared_names(std::string_view sheet) {
  std::set<std::string_view> names;
  for (std::size_t at = 0; (at = sheet.find_first_of("{;", at)) != sheet.npos;) {
    const std::size_t end = std::min(sheet.find_first_of("{};:", ++at), sheet.size());
    if (sheet.substr(end, 1) == ":") names.insert(trimmed(sheet.substr(at, end - at)));
  }
  return names;
}

}  // namespace

Svg_style::Svg_style(const pugi::xml_node& element) : element_(element) {
  const std::string text = plain(element.attribute("style").value());
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t length = declaration_length(rest);
    declarations_.push_back(declaration(rest.substr(0, length)));
    rest.remove_prefix(std::min(length + 1, rest.size()));
  }
}

Svg_style::Declaration Svg_style::declaration(std::string_view text) {
  const std::size_t colon = std::min(text.find(':'), text.size());
  const std::string_view property = trimmed(text.substr(0, colon));
  std::string_view value = text.substr(std::min(colon + 1, text.size()));
  const std::size_t mark = value.rfind('!');
  const bool is_important = mark != value.npos && trimmed(value.substr(mark + 1)) == "important";
  if (is_important) value = value.substr(0, mark);
  return {std::string(property), std::string(trimmed(value)), is_important};
}

std::string Svg_style::declared(std::string_view property, std::initializer_list<std::string_view> accepted) const {
  const Declaration* best = nullptr;
  for (const Declaration& declaration : declarations_) {
    if (declaration.property != property) continue;
    if (accepted.size() > 0 && !contains(accepted, declaration.value)) continue;
    if (best == nullptr || declaration.is_important || !best->is_important) best = &declaration;
  }
  return best == nullptr ? "" : best->value;
}

std::string Svg_style::value(const char* property, std::initializer_list<std::string_view> accepted) const {
  std::string value = declared(property, accepted);
  if (!value.empty()) return value;
  value = trimmed(plain(element_.attribute(property).value()));
  return accepted.size() == 0 || contains(accepted, value) ? value : "";
}

void Svg_style::note_unread(std::string_view element, Svg_notes& notes) const {
  std::set<std::string_view> reasons;
  for (const Effect& effect : EFFECTS) {
    const std::string effect_value = value(effect.property);
    if (!effect_value.empty() && effect_value != "none") reasons.insert(effect.reason);
  }
  for (const std::string_view reason : reasons) notes.add(element, reason, Svg_notes::READ);
  const auto unread = std::find_if(declarations_.begin(), declarations_.end(),
                                   [](const Declaration& d) { return contains(GEOMETRY, d.property); });
  if (unread != declarations_.end())
    notes.add(element, "geometry in its style attribute is not read", Svg_notes::READ,
              [&] { return unread->property; });
  const std::string box = value("transform-box");
  if (!box.empty() && box != "view-box" && !value("transform").empty())
    notes.add(element, "its transform-box is taken for view-box", Svg_notes::READ, [&] { return box; });
}

bool is_in_svg_style_sheet(std::string_view text, std::string_view property) {
  const std::string sheet = plain(text);
  return declared_names(sheet).count(property) > 0;
}

void note_svg_style_sheet(std::string_view text, Svg_notes& notes) {
  const std::string sheet = plain(text);
  std::string names;
  for (const std::string_view name : declared_names(sheet)) {
    const bool is_effect = std::any_of(std::begin(EFFECTS), std::end(EFFECTS),
                                       [&](const Effect& effect) { return name == effect.property; });
    if (!is_effect && !contains(READ, name) && !contains(GEOMETRY, name)) continue;
    names += (names.empty() ? "" : ", ") + std::string(name);
  }
  if (!names.empty()) notes.add("style", "style sheets are not read", Svg_notes::LEFT_OUT, [&] { return names; });
}

}  // namespace bounding_arcs_tool
