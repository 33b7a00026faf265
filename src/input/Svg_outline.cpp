// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The drawing commands; the arc is found from its chord, without its center.

#include "Svg_outline.h"

#include "Input_text.h"
#include "Svg_scanner.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bounding_arcs_tool {

namespace {

constexpr double QUARTER_TURN = 1.57079632679489661923;

// Angles are found within some 1e-15, so that an arc of exactly 90, 180 or 270 degrees may come out that much longer;
// it is not worth another piece. Tenfold more changes nothing; without it such arcs fall into one piece too many.
constexpr double ANGLE_SLACK = 1e-12;

bool is_single_point(const std::vector<Xy<double>>& points) {
  return std::all_of(points.begin(), points.end(), [&](const Xy<double>& p) { return p == points.front(); });
}

}  // namespace

void Svg_outline::move_to(const Point& p) {
  start_ = current_ = p;
  placed_start_ = placed_current_ = placed(p);
  subpath_open_ = false;
}

void Svg_outline::curve_to(const std::vector<Point>& points, std::vector<double> weights) {
  std::vector<Point> control_points{placed_current_};
  for (const Point& p : points) control_points.push_back(placed(p));
  if (!subpath_open_) subpaths_.emplace_back();
  subpath_open_ = true;
  current_ = points.back();
  placed_current_ = control_points.back();
  // Pieces that are points are left out, but for one of a subpath that has no others.
  auto& beziers = subpaths_.back().beziers;
  const bool is_point = is_single_point(control_points);
  if (is_point && !beziers.empty()) return;
  if (!is_point && beziers.size() == 1 && is_single_point(beziers.front().control_points())) beziers.clear();
  beziers.emplace_back(std::move(control_points), std::move(weights));
}

void Svg_outline::quarter_to(const Point& corner, const Point& p) { curve_to({corner, p}, {1, std::sqrt(0.5), 1}); }

void Svg_outline::close() {
  if (subpath_open_) {
    if (placed_current_ != placed_start_) line_to(start_);
    subpaths_.back().closed = true;
  }
  move_to(start_);
}

// With the axes of the ellipse turned into those of the plane and its radii scaled to 1, the arc runs on a unit circle
// from m - r e to m + r e, where m is the middle and r half the length of the chord. It spans the angles -h ... h about
// the normal n of the chord on its side, sin h = r, and the point at angle t is m + sin(t) e + (cos t - cos h) n. The
// difference is 2 sin((h+t)/2) sin((h-t)/2), which keeps flat arcs accurate, whose center is far away.
// Between t - s and t + s the middle control point lies at m + sin(t)/cos(s) e + (cos(t)/cos(s) - cos h) n.
void Svg_outline::arc_to(const Svg_arc& arc, const Point& p) {
  const Point from = current_;
  if (from == p) return;
  double rx = std::abs(arc.rx), ry = std::abs(arc.ry);
  if (rx == 0 || ry == 0) return line_to(p);
  const Point middle{from.x / 2 + p.x / 2, from.y / 2 + p.y / 2};
  const Svg_transform turn = svg_rotation(arc.x_rotation), back = svg_rotation(-arc.x_rotation);
  const Point half = back({p.x / 2 - from.x / 2, p.y / 2 - from.y / 2});
  const double length = std::hypot(half.x / rx, half.y / ry), r = std::min(length, 1.0);
  if (length == 0) return line_to(p);
  if (!std::isfinite(length))
    throw Svg_error(0, "expected radii that are not lost beside the chord of the arc, found smaller ones");
  const Point e{half.x / rx / length, half.y / ry / length};
  const Point n = arc.sweep ? Point{e.y, -e.x} : Point{-e.y, e.x};
  if (length > 1) rx *= length, ry *= length;
  const double h = arc.large ? 2 * QUARTER_TURN - std::asin(r) : std::asin(r);
  const auto place = [&](double along, double across) {
    const Point q = turn({rx * (along * e.x + across * n.x), ry * (along * e.y + across * n.y)});
    return Point{middle.x + q.x, middle.y + q.y};
  };
  const auto rise = [&](double t) { return 2 * std::sin((h + t) / 2) * std::sin((h - t) / 2); };
  const int pieces = std::max(1, static_cast<int>(std::ceil(2 * h / QUARTER_TURN - ANGLE_SLACK)));
  const double s = h / pieces, half_sine = std::sin(s / 2), overshoot = 2 * half_sine * half_sine / std::cos(s);
  for (int i = 0; i < pieces; ++i) {
    const double t = (2 * i + 1 - pieces) * s;
    const Point control = place(std::sin(t) / std::cos(s), rise(t) + std::cos(t) * overshoot);
    const Point end = i + 1 == pieces ? p : place(std::sin(t + s), rise(t + s));
    curve_to({control, end}, {1, std::cos(s), 1});
  }
}

Xy<double> Svg_outline::placed(const Point& p) const {
  const Point q = transform_(p);
  if (!(std::abs(q.x) <= MAXIMUM_COORDINATE && std::abs(q.y) <= MAXIMUM_COORDINATE))
    throw Svg_error(0, "expected coordinates up to 2^1000 in the drawing, found larger ones");
  return q;
}

}  // namespace bounding_arcs_tool
