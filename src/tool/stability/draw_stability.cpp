// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The plot of a study of stability: a row of panels a family, a panel a quantity, both axes in powers of ten.  Colour
// tells the method, dashes the formula; only the kernel double is drawn.

#include "stability_command.h"

#include "../Commands.h"
#include "../option_words.h"

#include <CGAL/Bounding_arcs_2/number/strict_math.h>
#include <CGAL/Bounding_arcs_2/study/Stability_study.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <utility>

namespace bounding_arcs_tool {
namespace {

using CGAL::Bounding_arcs::HALF_ULP;
using CGAL::Bounding_arcs::Stability_row;

// Pixels.
constexpr double PANEL_WIDTH = 270, PANEL_HEIGHT = 190, GAP = 30, LEFT = 70, RIGHT = 20, TOP = 112, BETWEEN = 76,
                 BOTTOM = 62;
// Errors shown, as powers of ten; what is outside is drawn on the border. No double figure is below half an ulp but by
// luck.
constexpr double LEAST_ERROR = -17.5, LARGEST_ERROR = 1.5;
constexpr double DECADES = 20;  // of delta shown: all that happens does so there

const char* const QUANTITIES[] = {"center", "radius", "joint", "thickness"};

template <class... Arguments> void print(std::ostream& out, const char* format, Arguments... arguments) {
  char text[500];
  std::snprintf(text, sizeof text, format, arguments...);
  out << text;
}

struct Family {
  std::string name;
  bool is_log = true;  // delta is a small parameter; else it counts members
  double largest = 0, least = 0;
  std::vector<const Stability_row*> rows;  // of double
  std::size_t left_out = 0;

  // 0 at the left border, for the largest delta or the first member, 1 at the right.
  [[nodiscard]] double place(double delta) const {
    if (largest == least) return 0.5;
    return is_log ? std::log10(largest / delta) / std::log10(largest / least) : (delta - least) / (largest - least);
  }
};

std::vector<Family> families_of(const std::vector<Stability_row>& rows) {
  std::vector<Family> families;
  for (const Stability_row& row : rows) {
    if (row.kernel != "double") continue;
    if (families.empty() || families.back().name != row.family) {
      families.emplace_back();
      families.back().name = row.family;
      families.back().largest = families.back().least = row.delta;
      families.back().is_log = row.family != "curves" && row.family != "random" && row.family != "hunt";
    }
    Family& family = families.back();
    family.largest = std::max(family.largest, row.delta);
    family.least = std::min(family.least, row.delta);
    family.rows.push_back(&row);
  }
  for (Family& family : families) {
    if (!family.is_log) continue;
    const double least = std::max(family.least, family.largest * std::pow(10.0, -DECADES) * 0.99);
    const auto is_out = [&](const Stability_row* row) { return row->delta < least; };
    const auto end = std::remove_if(family.rows.begin(), family.rows.end(), is_out);
    family.left_out = static_cast<std::size_t>(family.rows.end() - end);
    family.rows.erase(end, family.rows.end());
    family.least = least;
  }
  return families;
}

const char* colour(const std::string& method) { return palette(methods_by_name().at(method)).stroke; }

double height_of(double error) {
  const double power = error > 0 ? std::log10(error) : LEAST_ERROR;
  return PANEL_HEIGHT * (LARGEST_ERROR - std::clamp(power, LEAST_ERROR, LARGEST_ERROR)) / (LARGEST_ERROR - LEAST_ERROR);
}

void power_of_ten(std::ostream& out, double x, double y, const char* anchor, int exponent) {
  print(out, "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\">", x, y, anchor);
  if (exponent == 0) out << "1</text>\n";
  else
    print(out, "10<tspan dy=\"-5\" font-size=\"9\">%s%d</tspan></text>\n", exponent < 0 ? "\xe2\x88\x92" : "",
          std::abs(exponent));
}

void draw_axes(std::ostream& out, const Family& family, const char* quantity, bool is_leftmost) {
  print(out, "<rect class=\"f\" width=\"%.0f\" height=\"%.0f\"/><text class=\"q\" x=\"8\" y=\"-6\">%s</text>\n",
        PANEL_WIDTH, PANEL_HEIGHT, quantity);
  constexpr int ERROR_STEP = 4, DELTA_STEP = 4;
  for (int exponent = -16; exponent <= 0; exponent += ERROR_STEP) {
    const double y = height_of(std::pow(10.0, exponent));
    print(out, "<path class=\"g\" d=\"M0 %.1fH%.0f\"/>", y, PANEL_WIDTH);
    if (is_leftmost) power_of_ten(out, -8, y + 4, "end", exponent);
  }
  out << '\n';
  if (family.is_log) {
    const int first = static_cast<int>(std::floor(std::log10(family.largest) + 1e-6)),
              last = static_cast<int>(std::ceil(std::log10(family.least) - 1e-6));
    for (int exponent = first; exponent >= last; exponent -= DELTA_STEP) {
      const double x = PANEL_WIDTH * family.place(std::pow(10.0, exponent));
      print(out, "<path class=\"g\" d=\"M%.1f 0V%.0f\"/>", x, PANEL_HEIGHT);
      power_of_ten(out, x, PANEL_HEIGHT + 17, "middle", exponent);
    }
  } else {
    for (const double delta : {family.least, family.largest})
      print(out, "<text x=\"%.1f\" y=\"%.0f\" text-anchor=\"middle\">%.0f</text>\n", PANEL_WIDTH * family.place(delta),
            PANEL_HEIGHT + 17, delta);
  }
  constexpr double PROMISED = 16 * 0x1p-52;
  print(out, "<path class=\"u\" d=\"M0 %.1fH%.0f\"/><path class=\"p\" d=\"M0 %.1fH%.0f\"/>\n", height_of(HALF_ULP),
        PANEL_WIDTH, height_of(PROMISED), PANEL_WIDTH);
}

void draw_series(std::ostream& out, const Family& family, const char* quantity) {
  std::map<std::pair<std::string, std::string>, std::string>
      paths;  // formula and method: stable lies over textbook last
  std::map<std::pair<std::string, std::string>, std::size_t> sizes;
  char text[60];
  for (const Stability_row* row : family.rows) {
    if (row->quantity != quantity) continue;
    const auto key = std::make_pair(row->formula == "stable" ? "1" : "0", row->method);
    std::snprintf(text, sizeof text, "%s%.1f %.1f", paths[key].empty() ? "M" : "L",
                  PANEL_WIDTH * family.place(row->delta), height_of(row->rel_error));
    paths[key] += text;
    ++sizes[key];
  }
  for (const auto& [key, path] : paths) {
    const bool is_dot = sizes[key] == 1, is_stable = key.first == "1";
    print(out, "<path class=\"%s\" stroke=\"%s\" d=\"", is_dot ? (is_stable ? "d" : "o") : (is_stable ? "s" : "t"),
          colour(key.second));
    out << path << (is_dot ? "h0" : "") << "\"/>\n";
  }
}

// The legend names the series that are drawn.
void draw_legend(std::ostream& out, const std::vector<Family>& families) {
  const auto is_drawn = [&](const std::string& method, const std::string& formula) {
    return std::any_of(families.begin(), families.end(), [&](const Family& family) {
      return std::any_of(family.rows.begin(), family.rows.end(),
                         [&](const Stability_row* row) { return row->method == method && row->formula == formula; });
    });
  };
  print(out, "<text class=\"h\" x=\"%.0f\" y=\"34\">Digits lost by bounding region constructions in double</text>\n",
        LEFT);
  print(out,
        "<text x=\"%.0f\" y=\"54\">Relative error of a region's circles, joints and thickness against exact "
        "arithmetic; positions from the piece's start. "
        "Lower is better: at 1 no digit is left.</text>\n",
        LEFT);
  double x = LEFT;
  for (const char* method : {"bca", "sfa", "bilens", "fat-arc", "fat-biarc", "box", "oriented-box", "hull"})
    for (const char* formula : {"textbook", "stable"}) {
      if (!is_drawn(method, formula)) continue;
      print(out, "<path class=\"%c\" stroke=\"%s\" d=\"M%.0f 77h34\"/><text x=\"%.0f\" y=\"81\">%s, %s</text>\n",
            *formula, colour(method), x, x + 40, method, formula);
      x += 147;
    }
  print(out,
        "<path class=\"u\" d=\"M%.0f 77h34\"/><text x=\"%.0f\" y=\"81\">unit roundoff 2<tspan dy=\"-5\" "
        "font-size=\"9\">\xe2\x88\x92"
        "53</tspan></text>\n",
        x, x + 40);
  x += 178;
  print(out,
        "<path class=\"p\" d=\"M%.0f 77h34\"/><text x=\"%.0f\" y=\"81\">16 ulp = 2<tspan dy=\"-5\" "
        "font-size=\"9\">\xe2\x88\x92"
        "48</tspan></text>\n",
        x, x + 40);
}

}  // namespace

void draw_stability(std::ostream& out, const std::vector<Stability_row>& rows) {
  const std::vector<Family> families = families_of(rows);
  const double width = LEFT + 4 * PANEL_WIDTH + 3 * GAP + RIGHT;
  const double height = TOP + static_cast<double>(families.size()) * (PANEL_HEIGHT + BETWEEN) + BOTTOM - BETWEEN;
  print(out, "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.0f\" height=\"%.0f\" viewBox=\"0 0 %.0f %.0f\">\n",
        width, height, width, height);
  out << "<title>Digits lost by bounding region constructions in double</title>\n"
         "<style>text{font-family:sans-serif;font-size:12px;fill:#333}.h{font-size:20px}.q{font-size:13px;font-weight:"
         "bold}\n"
         ".f{fill:none;stroke:#888}.g{stroke:#e4e4e4;fill:none}.s,.t,.d,.o{fill:none;stroke-width:1.8;stroke-linejoin:"
         "round}\n"
         ".t{stroke-dasharray:6 3}.d,.o{stroke-width:7;stroke-linecap:round}.o{stroke-width:9;stroke-opacity:.45}\n"
         ".u{stroke:#111;stroke-width:1;fill:none}.p{stroke:#111;stroke-width:1;stroke-dasharray:1.5 "
         "3;fill:none}</style>\n"
         "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
  draw_legend(out, families);
  double y = TOP;
  for (const Family& family : families) {
    double x = LEFT;
    for (const char* quantity : QUANTITIES) {
      print(out, "<g transform=\"translate(%.0f %.0f)\">\n", x, y);
      draw_axes(out, family, quantity, x == LEFT);
      draw_series(out, family, quantity);
      out << "</g>\n";
      x += PANEL_WIDTH + GAP;
    }
    print(out, "<text x=\"%.0f\" y=\"%.0f\" text-anchor=\"middle\">", (width + LEFT - RIGHT) / 2,
          y + PANEL_HEIGHT + 38);
    out << family.name << (family.is_log ? ": delta, smaller to the right" : ": number of the spiral");
    if (family.left_out > 0) print(out, "; %zu rows with smaller delta are not drawn", family.left_out);
    print(out,
          "</text>\n<text x=\"18\" y=\"%.0f\" text-anchor=\"middle\" transform=\"rotate(-90 18 %.0f)\">relative "
          "error</text>\n",
          y + PANEL_HEIGHT / 2, y + PANEL_HEIGHT / 2);
    y += PANEL_HEIGHT + BETWEEN;
  }
  out << "</svg>\n";
}

}  // namespace bounding_arcs_tool
