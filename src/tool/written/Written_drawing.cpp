// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Written_drawing.h"

#include "../number_text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace bounding_arcs_tool {

namespace ba = CGAL::Bounding_arcs;

namespace {

constexpr double ROUNDING = 0x1p-44;  // of lengths and weights: some hundred ulp
constexpr double ROUNDED = 0x1p-50;   // of coordinates

// A conic whose weights are 1, w and 1 but for a factor.
struct Conic {
  ba::Xy<double> p[3];
  double w;
};

// The arc that a conic is: its ends are as far from its middle control point, and its weight is the cosine of half the
// angle that it turns by.
std::optional<ba::Arc_2> arc_of(const Conic& conic) {
  const auto& p = conic.p;
  const ba::Xy<double> chord = p[2] - p[0], first = p[1] - p[0], second = p[2] - p[1];
  const double half = std::hypot(chord.x, chord.y) / 2, side = std::hypot(first.x, first.y);
  double size = 0;
  for (const auto& q : p) size = (std::max)({size, std::fabs(q.x), std::fabs(q.y)});
  const double slack = ROUNDING + ROUNDED * size / side;
  if (half == 0 || !(std::fabs(side - std::hypot(second.x, second.y)) <= slack * side) ||
      !(std::fabs(conic.w - half / side) <= slack))
    return std::nullopt;
  const double rise =
      cross(first, chord) / (2 * half * half);  // tangent of the angle at the ends, to the right above 0
  return ba::Arc_2{p[0], p[2], rise / (1 + std::sqrt(1 + rise * rise))};
}

// Whether a conic with another weight is the parabola of its control points: halfway it is off by a quarter of what the
// weight differs by, of the way from the chord to the middle control point.
bool is_parabola(const Conic& conic) {
  const ba::Xy<double> height = conic.p[1] - 0.5 * (conic.p[0] + conic.p[2]), side = conic.p[1] - conic.p[0];
  return std::fabs(conic.w - 1) * std::hypot(height.x, height.y) <= ROUNDING * std::hypot(side.x, side.y);
}

}  // namespace

Curve_look look_of(const ba::Curve_record& record) { return {record.layer, record.colour}; }

std::string json_members(const Curve_look& look) {
  std::string text = look.layer.empty() ? "" : "\"layer\":" + nlohmann::json(look.layer).dump() + ",";
  char rgb[16];
  std::snprintf(rgb, sizeof rgb, "\"#%06x\"", static_cast<unsigned>(look.colour.rgb));
  if (look.colour.rgb >= 0) text += std::string("\"colour\":") + rgb + ",";
  else if (look.colour.number > 0) text += "\"colour\":" + std::to_string(look.colour.number) + ",";
  return text;
}

std::string json_members(double unit_in_mm, bool y_is_down) {
  return (unit_in_mm > 0 ? "\"unit_in_mm\":" + number(unit_in_mm) + "," : "") +
         (y_is_down ? "\"y_is_down\":true," : "");
}

ba::Xy<double> start_of(const Written_piece& piece) {
  const auto* const arc = std::get_if<ba::Arc_2>(&piece);
  return arc != nullptr ? arc->from : std::get<1>(piece).control_points().front();
}

ba::Xy<double> end_of(const Written_piece& piece) {
  const auto* const arc = std::get_if<ba::Arc_2>(&piece);
  return arc != nullptr ? arc->to : std::get<1>(piece).control_points().back();
}

std::optional<ba::Arc_2> arc_of_both(const ba::Arc_2& a, const ba::Arc_2& b) {
  if (!(a.bulge * b.bulge > 0) || a.to != b.from) return std::nullopt;
  double bulge = std::tan(std::atan(a.bulge) + std::atan(b.bulge));
  if (std::fabs(std::fabs(bulge) - 1) < ROUNDING) bulge = std::copysign(1, bulge);
  const ba::Arc_2 both{a.from, b.to, bulge};
  if (!(bulge * a.bulge > 0) || std::fabs(bulge) > 1) return std::nullopt;
  const auto chord = [](const ba::Arc_2& arc) { return std::hypot(arc.to.x - arc.from.x, arc.to.y - arc.from.y); };
  const auto radius = [&](const ba::Arc_2& arc) {
    return chord(arc) * (1 + arc.bulge * arc.bulge) / std::fabs(4 * arc.bulge);
  };
  const double r = radius(both);
  // In parts of its chord an arc is off by its bulge times what its radius is off by.
  const auto is_of_it = [&](const ba::Arc_2& part) {
    return std::fabs((radius(part) - r) * part.bulge) <= ROUNDING * r;
  };
  const bool is_one =
      is_of_it(a) && is_of_it(b) && std::fabs(ba::signed_distance(a.to, both)) <= ROUNDING * chord(both);
  return is_one ? std::optional(both) : std::nullopt;
}

Written_piece written_piece(const ba::Bezier_curve_2<double>& curve) {
  const auto& p = curve.control_points();
  if (curve.degree() == 1) return ba::Arc_2{p.front(), p.back(), 0};
  const auto& w = curve.weights();
  if (curve.degree() == 2 && curve.is_rational()) {
    const Conic conic{{p[0], p[1], p[2]}, w[1] / std::sqrt(w[0] * w[2])};
    if (const std::optional<ba::Arc_2> arc = arc_of(conic)) return *arc;
    if (is_parabola(conic)) return ba::Bezier_curve_2<double>(p);
  }
  if (std::all_of(w.begin(), w.end(), [&](double x) { return x == w.front(); })) return ba::Bezier_curve_2<double>(p);
  return curve;
}

void add_piece(std::vector<Written_piece>& pieces, const Written_piece& piece) {
  auto* const before = pieces.empty() ? nullptr : std::get_if<ba::Arc_2>(&pieces.back());
  const auto* const arc = std::get_if<ba::Arc_2>(&piece);
  const std::optional<ba::Arc_2> both = before != nullptr && arc != nullptr ? arc_of_both(*before, *arc) : std::nullopt;
  if (both) *before = *both;
  else pieces.push_back(piece);
}

Written_curve written_curve(const std::string& name, const Curve_look& look,
                            const std::vector<ba::Bezier_curve_2<double>>& pieces) {
  Written_curve curve{name, look, {}};
  for (const auto& bezier : pieces) add_piece(curve.pieces, written_piece(bezier));
  return curve;
}

void for_each_run(const std::vector<Written_piece>& pieces,
                  const std::function<void(const Written_piece*, const Written_piece*)>& visit) {
  const Written_piece *first = pieces.data(), *const end = first + pieces.size();
  while (first != end) {
    const Written_piece* last = first + 1;
    while (last != end && start_of(*last) == end_of(last[-1])) ++last;
    visit(first, last);
    first = last;
  }
}

}  // namespace bounding_arcs_tool
