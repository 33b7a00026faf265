// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The offset of closed loops of arcs, by brute force: which points it has, by winding numbers and distances, and its
// area, by horizontal lines.  It shares nothing with the code under test but the arcs.
//
//   outwards: what the loops fill, and what is nearer to them than d
//   inwards:  what they fill, and is no nearer than d to the parts of them with what is filled on one side alone

#ifndef BOUNDING_ARCS_TEST_OFFSET_ORACLE_H
#define BOUNDING_ARCS_TEST_OFFSET_ORACLE_H

#include "bulge_arcs.h"

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>
#include <CGAL/Bounding_arcs_2/curve/Fill_rule.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace bounding_arcs_test {

using Loop_arc = CGAL::Bounding_arcs::Arc_2;
using Arc_loop = std::vector<Loop_arc>;

class Offset_oracle {
  using Point = CGAL::Bounding_arcs::Xy<double>;
  struct Interval {
    double from, to;
  };
  using Intervals = std::vector<Interval>;
  struct Circle {
    Point center;
    double radius;
  };

 public:
  /// \pre bulges from -1 to 1
  Offset_oracle(const std::vector<Arc_loop>& loops, CGAL::Bounding_arcs::Fill_rule rule, double d)
      : rule_(rule), d_(std::fabs(d)), is_inwards_(d < 0) {
    for (const Arc_loop& loop : loops) arcs_.insert(arcs_.end(), loop.begin(), loop.end());
    walls_ = arcs_;
    if (is_inwards_) keep_boundary();
  }

  [[nodiscard]] bool is_filled(const Point& q) const { return CGAL::Bounding_arcs::is_filled(rule_, winding(q)); }
  /// How far q is inside the offset, or, negative, no farther outside, seen from what it is an offset of.
  [[nodiscard]] double depth(const Point& q) const {
    double nearest = HUGE_VAL;
    for (const Loop_arc& a : walls_) nearest = (std::min)(nearest, distance_from(a, q));
    if (is_inwards_) return is_filled(q) ? nearest - d_ : -nearest - d_;
    return is_filled(q) ? nearest + d_ : d_ - nearest;
  }
  /// By so many lines, each somewhere in its strip, as the share says.
  [[nodiscard]] double area(int lines, double share) const {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const Loop_arc& a : arcs_) {
      const double room = d_ + std::hypot(a.to.x - a.from.x, a.to.y - a.from.y) / 2;
      low = (std::min)({low, a.from.y - room, a.to.y - room});
      high = (std::max)({high, a.from.y + room, a.to.y + room});
    }
    const double height = (high - low) / lines;
    double sum = 0;
    for (int i = 0; i < lines; ++i) sum += height * length_on(low + (i + share) * height);
    return sum;
  }

 private:
  [[nodiscard]] static bool is_straight(const Loop_arc& a) { return std::fabs(a.bulge) < 1e-9; }
  [[nodiscard]] static Circle circle_of(const Loop_arc& a) {
    const Point chord = a.to - a.from;
    const double b = a.bulge;
    return {0.5 * (a.from + a.to) + ((1 - b * b) / (4 * b)) * perp(chord),
            std::hypot(chord.x, chord.y) * (1 + b * b) / (4 * std::fabs(b))};
  }
  // Where an arc meets a horizontal line.
  [[nodiscard]] static std::vector<double> places_on(const Loop_arc& a, double y) {
    std::vector<double> result;
    if (is_straight(a)) {
      if ((a.from.y <= y) != (a.to.y <= y))
        result.push_back(a.from.x + (y - a.from.y) / (a.to.y - a.from.y) * (a.to.x - a.from.x));
      return result;
    }
    const Circle c = circle_of(a);
    const double square = (c.radius - (y - c.center.y)) * (c.radius + (y - c.center.y));
    if (square < 0) return result;
    for (const double x : {c.center.x - std::sqrt(square), c.center.x + std::sqrt(square)})
      if (cross(a.to - a.from, Point{x, y} - a.from) * a.bulge <= 0) result.push_back(x);
    return result;
  }
  // Upwards is 1, downwards -1.
  [[nodiscard]] static int direction_at(const Loop_arc& a, double x) {
    if (is_straight(a)) return a.to.y > a.from.y ? 1 : -1;
    return (x > circle_of(a).center.x) == (a.bulge > 0) ? 1 : -1;
  }
  [[nodiscard]] int winding(const Point& q) const {
    int sum = 0;
    for (const Loop_arc& a : arcs_)
      for (const double x : places_on(a, q.y))
        if (x > q.x) sum += direction_at(a, x);
    return sum;
  }

  // Cuts arcs where they meet and keeps the parts that what is filled ends at, which is asked at points beside them:
  // no nearer than need be, as rounding of points of a flat arc is some ulp of its radius.
  void keep_boundary() {
    walls_.clear();
    for (const Loop_arc& a : arcs_) {
      std::vector<double> cuts{0, 1};
      for (const Loop_arc& b : arcs_)
        if (&a != &b) add_cuts(a, b, cuts);
      std::sort(cuts.begin(), cuts.end());
      for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        // in the middle grid points may be as high
        const double middle = cuts[i] + 0.487351 * (cuts[i + 1] - cuts[i]);
        const Point from = point_on(a, cuts[i]), to = point_on(a, cuts[i + 1]), p = point_on(a, middle);
        constexpr double LEAST = 1e-11;  // of coordinates of about 10
        if (std::hypot(to.x - from.x, to.y - from.y) < LEAST) continue;
        const Point way = to - from;
        const double length = std::hypot(way.x, way.y);
        double near = std::clamp(1e-4 * length, LEAST, 1e-8);
        for (const Loop_arc& b : arcs_)  // the other side of a sliver is farther
          if (const double away = distance_from(b, p); &a != &b && away > LEAST)
            near = (std::min)(near, (std::max)(LEAST, away / 4));
        const Point aside = (near / length) * perp(way);
        if (is_filled(p + aside) == is_filled(p - aside)) continue;
        walls_.push_back({from, to, std::tan(std::atan(a.bulge) * (cuts[i + 1] - cuts[i]))});
      }
    }
  }
  static void add_cuts(const Loop_arc& a, const Loop_arc& b, std::vector<double>& cuts) {
    const auto add = [&](const Point& p) {
      const double share = share_of(a, p);
      if (share > 0 && share < 1 && is_beside(b, p)) cuts.push_back(share);
    };
    const bool is_flat = is_straight(a);
    if (is_flat && is_straight(b)) {
      const Point u = a.to - a.from, v = b.to - b.from;
      const double turn = cross(u, v);
      if (turn != 0) add(a.from + (cross(b.from - a.from, v) / turn) * u);
    } else if (is_flat || is_straight(b)) {
      const Loop_arc& line = is_flat ? a : b;
      const Circle c = circle_of(is_flat ? b : a);
      const double length = std::hypot(line.to.x - line.from.x, line.to.y - line.from.y);
      const Point u = (1 / length) * (line.to - line.from);
      const double away = cross(u, c.center - line.from), along = dot(u, c.center - line.from),
                   square = (c.radius - away) * (c.radius + away);
      if (square < 0) return;
      for (const double s : {along - std::sqrt(square), along + std::sqrt(square)}) add(line.from + s * u);
    } else {
      const Circle c = circle_of(a), e = circle_of(b);
      const Point way = e.center - c.center;
      const double apart = std::hypot(way.x, way.y);
      if (apart == 0) return;
      const double along = (apart + (c.radius - e.radius) * (c.radius + e.radius) / apart) / 2,
                   square = (c.radius - along) * (c.radius + along);
      if (square < 0) return;
      const Point u = (1 / apart) * way, foot = c.center + along * u, up = std::sqrt(square) * perp(u);
      add(foot + up);
      add(foot - up);
    }
  }
  // The share of an arc's angle before a point of its circle, outside of 0 to 1 if it is not on the arc.
  [[nodiscard]] static double share_of(const Loop_arc& a, const Point& p) {
    const Point chord = a.to - a.from;
    if (is_straight(a)) return dot(chord, p - a.from) / dot(chord, chord);
    const Point u = p - a.from, t = tangent_at_start(a);
    constexpr double HERE = 1e-12;  // of the chord, whose direction is none then
    if (dot(u, u) <= HERE * HERE * dot(chord, chord)) return 0;
    return std::atan2(a.bulge > 0 ? cross(t, u) : -cross(t, u), dot(t, u)) / (2 * std::atan(std::fabs(a.bulge)));
  }
  [[nodiscard]] static Point tangent_at_start(const Loop_arc& a) {
    const double b = a.bulge;
    return (1 - b * b) * (a.to - a.from) - 2 * b * perp(a.to - a.from);
  }
  [[nodiscard]] static bool is_beside(const Loop_arc& b, const Point& p) {
    constexpr double ON = 1e-9;
    const double share = share_of(b, p);
    return share > -ON && share < 1 + ON;
  }

  [[nodiscard]] double length_on(double y) const {
    Intervals filled, band;
    std::vector<std::pair<double, int>> crossings;
    for (const Loop_arc& a : arcs_)
      for (const double x : places_on(a, y)) crossings.emplace_back(x, direction_at(a, x));
    std::sort(crossings.begin(), crossings.end());
    int number = 0;  // seen from the left an upward crossing is one less
    for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
      number -= crossings[i].second;
      if (CGAL::Bounding_arcs::is_filled(rule_, number)) filled.push_back({crossings[i].first, crossings[i + 1].first});
    }
    for (const Loop_arc& a : walls_) add_band(a, y, band);
    if (!is_inwards_) {
      band.insert(band.end(), filled.begin(), filled.end());
      return length_of(band);
    }
    const double of_band = length_of(band);
    band.insert(band.end(), filled.begin(), filled.end());
    return length_of(band) - of_band;
  }
  [[nodiscard]] static double length_of(Intervals& parts) {
    std::sort(parts.begin(), parts.end(), [](const Interval& p, const Interval& q) { return p.from < q.from; });
    double sum = 0, last = -HUGE_VAL;
    for (const Interval& p : parts) {
      sum += (std::max)(0.0, p.to - (std::max)(p.from, last));
      last = (std::max)(last, p.to);
    }
    return sum;
  }
  // What of a line is nearer than d to an arc: discs about its ends, and what is beside it.
  void add_band(const Loop_arc& a, double y, Intervals& band) const {
    add_disc({a.from, d_}, y, {-HUGE_VAL, HUGE_VAL}, band);
    add_disc({a.to, d_}, y, {-HUGE_VAL, HUGE_VAL}, band);
    if (is_straight(a)) {
      const Point u = a.to - a.from;
      const double length = std::hypot(u.x, u.y);
      if (length == 0) return;
      const Point n = (1 / length) * perp(u);
      Interval i{-HUGE_VAL, HUGE_VAL};
      cut(i, u, a.from, y);
      cut(i, -u, a.to, y);
      cut(i, n, a.from - d_ * n, y);
      cut(i, -n, a.from + d_ * n, y);
      if (i.from < i.to) band.push_back(i);
      return;
    }
    const Circle c = circle_of(a);
    // the wedge of at most half a circle between the radii
    const double sign = a.bulge > 0 ? 1 : -1;
    Interval wedge{-HUGE_VAL, HUGE_VAL};
    cut(wedge, sign * perp(a.from - c.center), c.center, y);
    cut(wedge, -sign * perp(a.to - c.center), c.center, y);
    if (!(wedge.from < wedge.to)) return;
    Intervals outer, inner;
    add_disc({c.center, c.radius + d_}, y, wedge, outer);
    if (outer.empty()) return;
    if (c.radius > d_) add_disc({c.center, c.radius - d_}, y, wedge, inner);
    if (inner.empty()) {
      band.push_back(outer[0]);
    } else {
      band.push_back({outer[0].from, inner[0].from});
      band.push_back({inner[0].to, outer[0].to});
    }
  }
  // Leaves what is to the side of p that n shows.
  static void cut(Interval& i, const Point& n, const Point& p, double y) {
    const double rest = dot(n, p) - n.y * y;  // n.x x >= rest
    if (n.x > 0) i.from = (std::max)(i.from, rest / n.x);
    else if (n.x < 0) i.to = (std::min)(i.to, rest / n.x);
    else if (rest > 0) i.to = i.from;
  }
  static void add_disc(const Circle& c, double y, const Interval& within, Intervals& parts) {
    const double square = (c.radius - (y - c.center.y)) * (c.radius + (y - c.center.y));
    if (square <= 0) return;
    const double half = std::sqrt(square);
    const Interval i{(std::max)(c.center.x - half, within.from), (std::min)(c.center.x + half, within.to)};
    if (i.from < i.to) parts.push_back(i);
  }

  CGAL::Bounding_arcs::Fill_rule rule_;
  double d_;
  bool is_inwards_;
  std::vector<Loop_arc> arcs_, walls_;
};

}  // namespace bounding_arcs_test

#endif
