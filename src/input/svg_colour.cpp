// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "svg_colour.h"

#include "Svg_scanner.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <string>

namespace bounding_arcs_tool {
namespace {

struct Named_colour {
  std::string_view name;
  int rgb;
};
constexpr Named_colour NAMES[] = {
    {"black", 0},         {"silver", 0xC0C0C0}, {"gray", 0x808080},   {"white", 0xFFFFFF},
    {"maroon", 0x800000}, {"red", 0xFF0000},    {"purple", 0x800080}, {"fuchsia", 0xFF00FF},
    {"green", 0x008000},  {"lime", 0x00FF00},   {"olive", 0x808000},  {"yellow", 0xFFFF00},
    {"navy", 0x000080},   {"blue", 0x0000FF},   {"teal", 0x008080},   {"aqua", 0x00FFFF}};

int of_digits(std::string_view digits) {
  std::string all(digits);
  if (digits.size() == 3) all = {digits[0], digits[0], digits[1], digits[1], digits[2], digits[2]};
  int rgb = -1;
  const auto [end, status] = std::from_chars(all.data(), all.data() + all.size(), rgb, 16);
  return all.size() == 6 && status == std::errc() && end == all.data() + all.size() && rgb >= 0 ? rgb : -1;
}

// Behind "rgb".
int of_shares(std::string_view text) {
  Svg_scanner scanner(text);
  if (!scanner.accept('(')) return -1;
  int rgb = 0;
  for (int i = 0; i < 3; ++i) {
    scanner.skip_separator();
    double share = scanner.number();
    if (scanner.word() == "%") share *= 2.55;
    rgb = 256 * rgb + static_cast<int>(std::lround(std::clamp(share, 0.0, 255.0)));
  }
  scanner.skip_space();
  return scanner.accept(')') && scanner.at_end() ? rgb : -1;
}

}  // namespace

int svg_colour(std::string_view text) {
  if (text.substr(0, 1) == "#") return of_digits(text.substr(1));
  try {
    if (text.substr(0, 3) == "rgb") return of_shares(text.substr(3));
  } catch (const Svg_error&) {
    return -1;
  }
  const auto* const found =
      std::find_if(std::begin(NAMES), std::end(NAMES), [&](const Named_colour& c) { return c.name == text; });
  return found == std::end(NAMES) ? -1 : found->rgb;
}

}  // namespace bounding_arcs_tool
