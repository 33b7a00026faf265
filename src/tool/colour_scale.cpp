// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "colour_scale.h"

#include "number_text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace bounding_arcs_tool {

std::string colour_of_share(double share) {
  constexpr double STOPS[][3] = {{68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}, {253, 231, 37}};
  constexpr int LAST = sizeof STOPS / sizeof *STOPS - 1;
  const double at = LAST * (std::min)((std::max)(share, 0.0), 1.0);
  const int i = (std::min)(static_cast<int>(at), LAST - 1);
  char text[16];
  const auto mix = [&](int c) {
    return static_cast<int>(std::lround(STOPS[i][c] + (at - i) * (STOPS[i + 1][c] - STOPS[i][c])));
  };
  std::snprintf(text, sizeof text, "#%02x%02x%02x", mix(0), mix(1), mix(2));
  return text;
}

void Colour_scale::draw(std::ostream& out, double largest, const std::string& what) const {
  constexpr int STEPS = 100, LABELS = 4;
  constexpr double TEXT = 18, OVERLAP = 0.5;  // pixels
  char text[200];
  for (int i = 0; i < STEPS; ++i) {
    std::snprintf(text, sizeof text, "<rect x=\"%.4f\" y=\"%.4f\" width=\"%.4f\" height=\"%g\" fill=\"%s\"/>\n",
                  place(i / double(STEPS)), top_, place(1.0 / STEPS) - place(0) + (i + 1 < STEPS ? OVERLAP : 0), HEIGHT,
                  colour_of_share((i + 0.5) / STEPS).c_str());
    out << text;
  }
  for (int i = 0; i <= LABELS; ++i) {
    std::snprintf(text, sizeof text, "<text class=\"k\" x=\"%.4f\" y=\"%.4f\">%s</text>\n", place(i / double(LABELS)),
                  top_ + HEIGHT + TEXT, short_number(largest * i / LABELS).c_str());
    out << text;
  }
  std::snprintf(text, sizeof text, "<text class=\"k\" x=\"%.4f\" y=\"%.4f\">%s</text>\n", place(0.5),
                top_ + HEIGHT + 2 * TEXT, what.c_str());
  out << text;
}

}  // namespace bounding_arcs_tool
