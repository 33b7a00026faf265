// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// An element of an SVG document and its attributes as numbers.

#ifndef BOUNDING_ARCS_TOOL_SVG_ELEMENT_H
#define BOUNDING_ARCS_TOOL_SVG_ELEMENT_H

#include "Svg_length.h"
#include "Svg_outline.h"
#include "Svg_scanner.h"
#include "Svg_style.h"

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>

#include <pugixml.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace bounding_arcs_tool {

/// What browsers take for a drawing that does not say its size.
constexpr Svg_viewport DEFAULT_SVG_VIEWPORT{300, 150};

/// An element; all functions that read attributes throw an Svg_error that names the attribute.
class Svg_element {
 public:
  explicit Svg_element(const pugi::xml_node& node) : node_(node) {}

  [[nodiscard]] const pugi::xml_node& node() const { return node_; }
  /// The name of an SVG element has no prefix.
  [[nodiscard]] std::string_view name() const { return node_.name(); }
  [[nodiscard]] bool is_svg() const { return name().find(':') == std::string_view::npos; }
  [[nodiscard]] std::string_view id() const { return node_.attribute("id").value(); }
  [[nodiscard]] bool has(const char* attribute) const { return !node_.attribute(attribute).empty(); }
  /// The length of all attributes, names and quotes counted as one byte each.
  [[nodiscard]] std::size_t attribute_bytes() const;
  /// Whether it is a group that Inkscape shows as a layer.
  [[nodiscard]] bool is_layer() const {
    return name() == "g" && std::string_view(node_.attribute("inkscape:groupmode").value()) == "layer";
  }
  [[nodiscard]] std::string_view layer_name() const { return node_.attribute("inkscape:label").value(); }
  /// Whether it asks for no extension, and for no language or for English among others.
  [[nodiscard]] bool is_wanted() const;
  /// The value of href, with or without the prefix xlink.
  [[nodiscard]] std::string_view reference() const;

  /// A length in user units; `whole` is what 100 % is, `otherwise` the value of an absent or automatic attribute.
  [[nodiscard]] double length(const char* attribute, double whole, double otherwise) const;
  /// A length that is not negative.
  [[nodiscard]] double size(const char* attribute, double whole, double otherwise) const;
  /// The map by transform and transform-origin. \param style that of this element
  [[nodiscard]] Svg_transform transform(const Svg_style& style, const Svg_viewport& viewport) const;

  /// The map from the contents of a nested svg or symbol element to a rectangle at the origin, by viewBox and
  /// preserveAspectRatio.
  /// \param viewport the size of the rectangle; becomes that of the viewBox, if there is one
  [[nodiscard]] Svg_transform viewbox_transform(Svg_viewport& viewport) const;
  /// The size that percentages refer to in the root element, by viewBox, or width and height.
  [[nodiscard]] Svg_viewport root_viewport() const;
  /// The length in mm of a user unit of the root element, where its width or height has a physical unit. Without a
  /// viewBox it is that of a pixel, of which an inch has 96.
  /// \return 0 where none has, and where units are of different lengths along x and y
  [[nodiscard]] double root_unit_in_mm() const;

  /// What the root element shows; nothing where it tells neither a viewBox nor a width and height.
  [[nodiscard]] std::optional<CGAL::Bounding_arcs::Curve_file::Page> root_page() const;

  /// parse(value) of an attribute, with its name put into an Svg_error.
  template <class Parse> auto parsed(const char* attribute, Parse parse) const {
    return within(attribute, [&] { return parse(std::string_view(node_.attribute(attribute).value())); });
  }

 private:
  template <class Action> static auto within(const char* attribute, Action action) {
    try {
      return action();
    } catch (Svg_error& error) {
      error.attribute = attribute;
      throw;
    }
  }

  pugi::xml_node node_;
};

[[nodiscard]] bool is_svg_shape(std::string_view name);

/// Draws a path, rect, circle, ellipse, line, polyline or polygon.
/// \throws Svg_error
void draw_svg_shape(const Svg_element& element, const Svg_viewport& viewport, Svg_outline& outline);

}  // namespace bounding_arcs_tool

#endif
