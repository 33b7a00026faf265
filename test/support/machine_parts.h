// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Machine parts as CAD programs write them: lines and arcs by ends and bulges of few decimals, so that arcs end a
// rounding beside the lines that they turn into; and polygons in place of ellipses.

#ifndef BOUNDING_ARCS_TEST_MACHINE_PARTS_H
#define BOUNDING_ARCS_TEST_MACHINE_PARTS_H

#include "nudged_drawings.h"
#include "query_drawings.h"

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace bounding_arcs_test {

/// Lines and arcs from vertex to vertex, closed. A bulge is the tangent of a quarter of an arc's angle, above 0 where
/// it is counterclockwise.
class Bulge_polyline {
 public:
  /// \param turn points are turned by that angle, and then rounded to so many decimals; bulges have two more
  Bulge_polyline(double turn, int decimals) : turn_(turn), unit_(std::pow(10, decimals)) {}
  void add(const Point& p, double bulge = 0) {
    const double c = std::cos(turn_), s = std::sin(turn_);
    vertices_.push_back(
        {{rounded(c * p.x - s * p.y, unit_), rounded(s * p.x + c * p.y, unit_)}, rounded(bulge, 100 * unit_)});
  }
  [[nodiscard]] std::vector<Bezier> beziers() const {
    std::vector<Bezier> chain;
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      const Vertex &v = vertices_[i], &next = vertices_[(i + 1) % vertices_.size()];
      if (v.bulge == 0 && v.point != next.point) chain.push_back(Bezier({v.point, next.point}));
      else if (v.bulge != 0) add_arc(v.point, next.point, v.bulge, chain);
    }
    return chain;
  }

 private:
  struct Vertex {
    Point point;
    double bulge;
  };
  [[nodiscard]] static double rounded(double v, double unit) { return std::round(v * unit) / unit; }
  // Two halves, as an arc may be half a circle.
  static void add_arc(const Point& p, const Point& q, double bulge, std::vector<Bezier>& chain) {
    const Point chord = q - p, top = 0.5 * (p + q) + 0.5 * bulge * Point{chord.y, -chord.x};
    const double angle = std::atan(bulge), rise = 0.5 * std::tan(angle);
    const auto half = [&](const Point& from, const Point& to) {
      const Point way = to - from;
      return Bezier({from, 0.5 * (from + to) + rise * Point{way.y, -way.x}, to}, {1, std::cos(angle), 1});
    };
    chain.push_back(half(p, top));
    chain.push_back(half(top, q));
  }

  double turn_, unit_;
  std::vector<Vertex> vertices_;
};

/// A part in the coordinates that a file has.
class Part_source {
 public:
  explicit Part_source(std::mt19937& random) : random_(random), decimals_(whole(random, 3, 8)) {}

  /// An angle bracket with fillets.
  [[nodiscard]] Drawing bracket() const {
    constexpr double QUARTER = 0.41421356237309503;
    const double thick = one_of({5, 8, 10}), inner = one_of({2, thick}), outer = one_of({1, 2});
    const Point corners[] = {{0, 0}, {60, 0}, {60, thick}, {thick, thick}, {thick, 40}, {0, 40}};
    const double radii[] = {0, outer, outer, inner, outer, outer};
    Bulge_polyline line = polyline(one_of({0, 0.3, 0.5235987755982988}));
    for (int i = 0; i < 6; ++i) {
      const Point &before = corners[(i + 5) % 6], &at = corners[i], &behind = corners[(i + 1) % 6];
      if (radii[i] == 0) {
        line.add(at);
        continue;
      }
      line.add(at + radii[i] * direction(at, before), i == 3 ? -QUARTER : QUARTER);
      line.add(at + radii[i] * direction(at, behind));
    }
    return drawing_of(line.beziers());
  }
  /// A disc with two or three kidney slots about its middle.
  [[nodiscard]] Drawing kidney_plate() const {
    const double radius = one_of({30, 35, 40}), half = one_of({3, 4, 5, 6}), sweep = one_of({0.7, 1, 1.2});
    Drawing drawing = drawing_of(circle_at_origin(one_of({55, 60})));
    const int count = whole(random_, 2, 3);
    for (int k = 0; k < count; ++k) {
      Bulge_polyline slot = polyline(k * FULL / count);
      slot.add(polar(radius + half, 0), std::tan(sweep / 4));
      slot.add(polar(radius + half, sweep), 1);
      slot.add(polar(radius - half, sweep), -std::tan(sweep / 4));
      slot.add(polar(radius - half, 0), 1);
      drawing.add(slot.beziers());
    }
    return drawing;
  }
  /// A wheel with teeth whose tops and roots are arcs, and a bore.
  [[nodiscard]] Drawing gear() const {
    const double teeth = one_of({8, 12, 17, 20}), step = FULL / teeth, top = teeth + 1, root = teeth - 1.25;
    Bulge_polyline line = polyline(0);
    for (int k = 0; k < static_cast<int>(teeth); ++k) {
      const double at = k * step;
      line.add(polar(root, at - 0.3 * step));
      line.add(polar(top, at - 0.14 * step), std::tan(0.07 * step));
      line.add(polar(top, at + 0.14 * step));
      line.add(polar(root, at + 0.3 * step), std::tan(0.1 * step));
    }
    Drawing drawing = drawing_of(line.beziers());
    drawing.add(circle_at_origin(0.3 * teeth));
    return drawing;
  }
  /// A polygon that some programs write in place of an ellipse.
  [[nodiscard]] Drawing ellipse_polygon() const {
    const double corners = one_of({36, 48, 64, 100, 200}), a = one_of({12, 25.4, 30}),
                 b = a * one_of({0.5, 0.6667, 0.9, 0.99});
    Bulge_polyline line = polyline(std::uniform_real_distribution<double>(0, 3)(random_));
    for (int k = 0; k < static_cast<int>(corners); ++k) {
      const Point on_circle = polar(1, FULL * k / corners);
      line.add({a * on_circle.x, b * on_circle.y});
    }
    return drawing_of(line.beziers());
  }

 private:
  static constexpr double FULL = 6.283185307179586;
  [[nodiscard]] Bulge_polyline polyline(double turn) const { return {turn, decimals_}; }
  [[nodiscard]] double one_of(const std::vector<double>& numbers) const {
    return numbers[static_cast<std::size_t>(whole(random_, 0, static_cast<int>(numbers.size()) - 1))];
  }
  [[nodiscard]] static Point polar(double radius, double angle) {
    return {radius * std::cos(angle), radius * std::sin(angle)};
  }
  [[nodiscard]] static Point direction(const Point& from, const Point& to) {
    const Point way = to - from;
    return (1 / std::hypot(way.x, way.y)) * way;
  }
  [[nodiscard]] std::vector<Bezier> circle_at_origin(double radius) const {
    Bulge_polyline line = polyline(0);
    line.add({radius, 0}, 1);
    line.add({-radius, 0}, 1);
    return line.beziers();
  }

  std::mt19937& random_;
  int decimals_;
};

inline Drawing any_machine_part(std::mt19937& random) {
  const Part_source part(random);
  switch (random() % 4) {
    case 0:
      return part.bracket();
    case 1:
      return part.kidney_plate();
    case 2:
      return part.gear();
    default:
      return part.ellipse_polygon();
  }
}

}  // namespace bounding_arcs_test

#endif
