// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Declarations by prefix, each a stack: the time for an element does not grow with what is declared around it.

#include "Svg_namespaces.h"

#include <optional>
#include <string>

namespace bounding_arcs_tool {

namespace {

constexpr const char* INKSCAPES = "inkscape";  // the prefix

struct Qualified_name {
  std::string_view prefix, local;
};

Qualified_name split(std::string_view name) {
  const std::size_t colon = name.find(':');
  if (colon == name.npos) return {"", name};
  return {name.substr(0, colon), name.substr(colon + 1)};
}

// The prefix that an attribute declares; "" is that of elements without one.
std::optional<std::string_view> declared_prefix(const pugi::xml_attribute& attribute) {
  const Qualified_name name = split(attribute.name());
  if (name.prefix == "xmlns") return name.local;
  if (name.prefix.empty() && name.local == "xmlns") return "";
  return std::nullopt;
}

}  // namespace

void Svg_namespaces::enter(pugi::xml_node element) {
  for (const pugi::xml_attribute& attribute : element.attributes())
    if (const auto prefix = declared_prefix(attribute))
      declarations_[*prefix].push_back(declared(*prefix, attribute.value()));
  const Qualified_name name = split(element.name());
  const bool is_svg = of(name.prefix) == SVG;
  if (is_svg && !name.prefix.empty()) element.set_name(std::string(name.local).c_str());
  if (!is_svg && name.prefix.empty()) element.set_name(":");
  for (pugi::xml_attribute attribute : element.attributes()) {
    const auto [prefix, local] = split(attribute.name());
    if (prefix.empty()) continue;  // of no namespace
    const Namespace space = of(prefix);
    if (local == "href" && space == XLINK) attribute.set_name("xlink:href");
    else if (space == INKSCAPE && prefix != INKSCAPES)
      attribute.set_name((INKSCAPES + (":" + std::string(local))).c_str());
    else if (space != INKSCAPE && prefix == INKSCAPES) attribute.set_name(":");
  }
}

void Svg_namespaces::leave(const pugi::xml_node& element) {
  for (const pugi::xml_attribute& attribute : element.attributes())
    if (const auto prefix = declared_prefix(attribute)) declarations_[*prefix].pop_back();
}

// Some programs declare namespaces by entities, which are not resolved: their prefixes speak for them.
Svg_namespaces::Namespace Svg_namespaces::declared(std::string_view prefix, std::string_view uri) {
  if (!uri.empty() && uri.front() == '&')
    return prefix.empty() || prefix == "svg" ? SVG : prefix == "xlink" ? XLINK : prefix == INKSCAPES ? INKSCAPE : OTHER;
  if (uri == "http://www.w3.org/2000/svg") return SVG;
  if (uri == "http://www.inkscape.org/namespaces/inkscape") return INKSCAPE;
  return uri == "http://www.w3.org/1999/xlink" ? XLINK : OTHER;
}

Svg_namespaces::Namespace Svg_namespaces::of(std::string_view prefix) const {
  const auto found = declarations_.find(prefix);
  if (found != declarations_.end() && !found->second.empty()) return found->second.back();
  return declared(prefix, "&");
}

}  // namespace bounding_arcs_tool
