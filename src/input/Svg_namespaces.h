// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The namespaces of an XML document, so that elements are told by what their prefixes stand for.

#ifndef BOUNDING_ARCS_TOOL_SVG_NAMESPACES_H
#define BOUNDING_ARCS_TOOL_SVG_NAMESPACES_H

#include <pugixml.hpp>

#include <string_view>
#include <unordered_map>
#include <vector>

namespace bounding_arcs_tool {

/// The declarations around a place in a document, which must outlive this. Where nothing is declared, elements without
/// prefix and those with `svg` are SVG's, the prefix `xlink` is XLink's and `inkscape` Inkscape's: so are files written
/// by hand.
class Svg_namespaces {
 public:
  /// Goes into an element, and renames it in place: an SVG element has no prefix any more, one of another namespace has
  /// its own or is named `:`, XLink's href is `xlink:href`, and Inkscape's attributes alone have the prefix `inkscape`.
  void enter(pugi::xml_node element);
  /// Goes out of the element that was entered last.
  void leave(const pugi::xml_node& element);

 private:
  enum Namespace { SVG, XLINK, INKSCAPE, OTHER };

  [[nodiscard]] static Namespace declared(std::string_view prefix, std::string_view uri);
  [[nodiscard]] Namespace of(std::string_view prefix) const;

  std::unordered_map<std::string_view, std::vector<Namespace>> declarations_;  // by prefix, the innermost last
};

}  // namespace bounding_arcs_tool

#endif
