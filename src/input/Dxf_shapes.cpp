// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Dxf_shapes.h"

#include "Input_text.h"

#include <CGAL/Bounding_arcs_2/arc/arc_beziers.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace bounding_arcs_tool {
namespace {

using CGAL::Bounding_arcs::Bezier_curve_2;
using CGAL::Bounding_arcs::perp;

void append(Dxf_curve& curve, Dxf_curve&& more) { std::move(more.begin(), more.end(), std::back_inserter(curve)); }

// More than half a circle is two arcs, which meet at the apex.
void append_arc(Dxf_curve& curve, const Xy<double>& from, const Xy<double>& to, double bulge) {
  if (from == to) return;
  if (std::abs(bulge) <= 1) return append(curve, CGAL::Bounding_arcs::arc_beziers<double>(from, to, bulge));
  const Xy<double> chord = to - from, apex = from + 0.5 * chord - (bulge / 2) * perp(chord);
  const double half = bulge / (1 + std::hypot(1, bulge));
  if (apex == from || apex == to) return append(curve, CGAL::Bounding_arcs::arc_beziers<double>(from, to, 0));
  append(curve, CGAL::Bounding_arcs::arc_beziers<double>(from, apex, half));
  append(curve, CGAL::Bounding_arcs::arc_beziers<double>(apex, to, half));
}

}  // namespace

Dxf_curve polyline_curve(const std::vector<Dxf_vertex>& vertices, bool is_closed) {
  Dxf_curve curve;
  for (std::size_t i = 0; i + 1 < vertices.size(); ++i)
    append_arc(curve, vertices[i].point, vertices[i + 1].point, vertices[i].bulge);
  if (is_closed && !vertices.empty())
    append_arc(curve, vertices.back().point, vertices.front().point, vertices.back().bulge);
  return curve;
}

double end_of_range(double from, double to, double last_place) {
  constexpr double TURN = 360, SLACK = 1e-4;  // degrees: programs compute angles in floats, too
  // A difference of two numbers that were rounded, or cut off, is off by less than a last place of them.
  const double allowed = std::max(SLACK, last_place * (1 + 0x1p-20));
  return std::fabs(std::fabs(to - from) - TURN) <= allowed ? from + TURN : to;
}

Dxf_curve conic_curve(const Svg_transform& of_unit_circle, double from, double to) {
  constexpr double TURN = 360, QUARTER = 90;
  // Angles come rounded: one that is so little more than 90 degrees is not worth another piece.
  constexpr double ANGLE_SLACK = 1e-9;
  // A turn further than an angle comes rounded, too: as no turn it would be open, or next to nothing.
  const bool is_turn = std::fabs(std::fabs(to - from) - TURN) <= 0x1p-52 * (TURN + std::fabs(from));
  double sweep = is_turn ? TURN : std::fmod(to - from, TURN);
  if (sweep <= 0) sweep += TURN;
  const bool is_closed = sweep == TURN;
  const int pieces = std::max(1, static_cast<int>(std::ceil(sweep / QUARTER - ANGLE_SLACK)));
  const double step = sweep / pieces, weight = step == QUARTER ? std::sqrt(0.5) : svg_rotation(step / 2).a;
  const auto at = [&](double angle, double radius) {
    const Svg_transform turn = svg_rotation(angle);
    return of_unit_circle({radius * turn.a, radius * turn.b});
  };
  const auto corner = [&](int i) {
    const Svg_transform a = svg_rotation(from + i * step), b = svg_rotation(from + (i + 1) * step);
    const double factor = 1 / (1 + svg_rotation(step).a);  // the tangents meet there, at (a + b) / (1 + cos step)
    return of_unit_circle({factor * (a.a + b.a), factor * (a.b + b.b)});
  };
  Dxf_curve curve;
  Xy<double> last = at(from, 1);
  for (int i = 0; i < pieces; ++i) {
    const bool is_last = i + 1 == pieces;
    const Xy<double> end =
        is_last ? (is_closed ? curve.front().control_points().front() : at(to, 1)) : at(from + (i + 1) * step, 1);
    curve.push_back(Bezier_curve_2<double>({last, corner(i), end}, {1, weight, 1}));
    last = end;
  }
  return curve;
}

Dxf_curve transformed(const Dxf_curve& curve, const Svg_transform& transform) {
  Dxf_curve result;
  for (const auto& bezier : curve) {
    std::vector<Xy<double>> points;
    for (const Xy<double>& p : bezier.control_points()) {
      points.push_back(transform(p));
      if (!(std::abs(points.back().x) <= MAXIMUM_COORDINATE && std::abs(points.back().y) <= MAXIMUM_COORDINATE))
        throw std::invalid_argument(
            "expected coordinates of magnitude at most 2^1000 in the drawing, found a larger one");
    }
    result.emplace_back(std::move(points), bezier.weights());
  }
  return result;
}

}  // namespace bounding_arcs_tool
