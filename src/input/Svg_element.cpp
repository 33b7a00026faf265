// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lengths with units, and the mapping of viewports.

#include "Svg_element.h"

#include <CGAL/Bounding_arcs_2/number/expected.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <vector>

namespace bounding_arcs_tool {

namespace {

struct Viewbox {
  double x, y, width, height;
};

Viewbox parsed_viewbox(std::string_view text) {
  Svg_scanner scanner(text);
  double v[4];
  scanner.skip_space();
  for (double& number : v) {
    number = scanner.number();
    scanner.skip_separator();
  }
  if (!scanner.at_end()) scanner.expected("the end after four numbers");
  if (!(v[2] > 0 && v[3] > 0))
    throw Svg_error(0, "expected a width and a height above 0, found " + CGAL::Bounding_arcs::text_of(v[2]) + " and " +
                           CGAL::Bounding_arcs::text_of(v[3]));
  return {v[0], v[1], v[2], v[3]};
}

// A preserveAspectRatio: the parts of the room left over that come before the contents, 0, 1/2 or 1, and which scale is
// taken of the two.
struct Aspect_ratio {
  double left = 0.5, top = 0.5;
  enum { MEET, SLICE, NONE } kind = MEET;
};

// An invalid value counts as none, as the standard has it.
Aspect_ratio parsed_aspect_ratio(std::string_view text) {
  Svg_scanner scanner(text);
  const auto word = [&] {
    scanner.skip_space();
    return scanner.word();
  };
  std::string align = word();
  if (align == "defer") align = word();
  const std::string scale = word();
  scanner.skip_space();
  if (!scanner.at_end() || (!scale.empty() && scale != "meet" && scale != "slice")) return {};
  Aspect_ratio ratio;
  ratio.kind = align == "none" ? Aspect_ratio::NONE : scale == "slice" ? Aspect_ratio::SLICE : Aspect_ratio::MEET;
  if (ratio.kind == Aspect_ratio::NONE) return ratio;
  const std::string_view places[] = {"Min", "Mid", "Max"};
  for (int x = 0; x < 3; ++x)
    for (int y = 0; y < 3; ++y)
      if (align == "x" + std::string(places[x]) + "Y" + std::string(places[y])) {
        ratio.left = x / 2.0;
        ratio.top = y / 2.0;
        return ratio;
      }
  return {};
}

// The map that has a fixed point elsewhere.
Svg_transform about(const Xy<double>& origin, const Svg_transform& map) {
  return svg_translation(origin.x, origin.y) * map * svg_translation(-origin.x, -origin.y);
}

}  // namespace

std::size_t Svg_element::attribute_bytes() const {
  std::size_t bytes = 0;
  for (const pugi::xml_attribute& attribute : node_.attributes()) bytes += 1 + std::strlen(attribute.value());
  return bytes;
}

bool Svg_element::is_wanted() const {
  if (has("requiredExtensions")) return false;
  if (!has("systemLanguage")) return true;
  std::string languages = ",";
  for (const char* c = node_.attribute("systemLanguage").value(); *c != '\0'; ++c)
    if (std::isspace(static_cast<unsigned char>(*c)) == 0)
      languages += static_cast<char>(std::tolower(static_cast<unsigned char>(*c)));
  languages += ",";
  return languages.find(",en,") != languages.npos || languages.find(",en-") != languages.npos;
}

std::string_view Svg_element::reference() const {
  const pugi::xml_attribute plain = node_.attribute("href");
  return plain.empty() ? node_.attribute("xlink:href").value() : plain.value();
}

double Svg_element::length(const char* attribute, double whole, double otherwise) const {
  return parsed(attribute, [&](std::string_view text) {
    return !has(attribute) || text == "auto" ? otherwise : parsed_svg_length(text, whole);
  });
}

double Svg_element::size(const char* attribute, double whole, double otherwise) const {
  const double size = length(attribute, whole, otherwise);
  return parsed(attribute, [&](std::string_view) {
    if (size < 0) throw Svg_error(1, "expected a size of at least 0, found " + CGAL::Bounding_arcs::text_of(size));
    return size;
  });
}

Svg_transform Svg_element::transform(const Svg_style& style, const Svg_viewport& viewport) const {
  const std::string styled = style.declared("transform");
  if (styled.empty() && !has("transform")) return {};
  const Svg_transform map = styled.empty()
                                ? parsed("transform", parsed_svg_transform)
                                : within("transform in style", [&] { return parsed_css_transform(styled, viewport); });
  const std::string origin = style.value("transform-origin");
  if (origin.empty()) return map;
  const bool in_style = !style.declared("transform-origin").empty();
  return within("transform-origin", [&] { return about(parsed_transform_origin(origin, viewport, in_style), map); });
}

Svg_transform Svg_element::viewbox_transform(Svg_viewport& viewport) const {
  if (!has("viewBox")) return {};
  const Viewbox box = parsed("viewBox", parsed_viewbox);
  const Aspect_ratio ratio = parsed_aspect_ratio(node_.attribute("preserveAspectRatio").value());
  double sx = viewport.width / box.width, sy = viewport.height / box.height;
  if (ratio.kind != Aspect_ratio::NONE)
    sx = sy = ratio.kind == Aspect_ratio::MEET ? std::min(sx, sy) : std::max(sx, sy);
  const double left = (viewport.width - sx * box.width) * ratio.left;
  const double top = (viewport.height - sy * box.height) * ratio.top;
  viewport = {box.width, box.height};
  return svg_translation(left, top) * svg_scaling(sx, sy) * svg_translation(-box.x, -box.y);
}

Svg_viewport Svg_element::root_viewport() const {
  if (has("viewBox")) {
    const Viewbox box = parsed("viewBox", parsed_viewbox);
    return {box.width, box.height};
  }
  const Svg_viewport& none = DEFAULT_SVG_VIEWPORT;
  return {length("width", none.width, none.width), length("height", none.height, none.height)};
}

double Svg_element::root_unit_in_mm() const {
  constexpr double PIXEL = 25.4 / 96;
  const double width = svg_length_in_mm(node_.attribute("width").value()),
               height = svg_length_in_mm(node_.attribute("height").value());
  if (width == 0 && height == 0) return 0;
  if (!has("viewBox")) return PIXEL;
  Viewbox box;
  try {
    box = parsed("viewBox", parsed_viewbox);
  } catch (const Svg_error&) {
    return PIXEL;  // as browsers take it
  }
  const double x = width / box.width, y = height / box.height;
  if (!std::isfinite(x + y)) return 0;
  if (x == 0 || y == 0) return (std::max)(x, y);  // the other side is as long as the viewBox has it
  const Aspect_ratio ratio = parsed_aspect_ratio(node_.attribute("preserveAspectRatio").value());
  if (ratio.kind == Aspect_ratio::NONE) return x == y ? x : 0;
  return ratio.kind == Aspect_ratio::MEET ? (std::min)(x, y) : (std::max)(x, y);
}

std::optional<CGAL::Bounding_arcs::Curve_file::Page> Svg_element::root_page() const {
  const auto text = [&](const char* attribute) { return std::string(node_.attribute(attribute).value()); };
  CGAL::Bounding_arcs::Curve_file::Page page;
  page.shown_width = text("width");
  page.shown_height = text("height");
  page.aspect_ratio = text("preserveAspectRatio");
  try {
    if (has("viewBox")) {
      const Viewbox box = parsed("viewBox", parsed_viewbox);
      page.view_box = text("viewBox");
      page.x = box.x, page.y = box.y, page.width = box.width, page.height = box.height;
    } else {
      page.width = size("width", 0, 0);
      page.height = size("height", 0, 0);
    }
  } catch (const Svg_error&) {
    return std::nullopt;
  }
  if (!(page.width > 0 && page.height > 0)) return std::nullopt;
  return page;
}

}  // namespace bounding_arcs_tool
