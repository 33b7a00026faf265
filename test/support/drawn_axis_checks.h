// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether an axis of a drawing is whole and right: its discs beside closest points, and discs that grow beside its
// branches.

#ifndef BOUNDING_ARCS_TEST_DRAWN_AXIS_CHECKS_H
#define BOUNDING_ARCS_TEST_DRAWN_AXIS_CHECKS_H

#include "../../src/library/medial_axis/Bounding_parts.h"
#include "axis_checks.h"
#include "drawn_shapes.h"
#include "faults.h"

#include <CGAL/Bounding_arcs_2/boolean/boolean_operations.h>
#include <CGAL/Bounding_arcs_2/medial_axis/medial_axis.h>
#include <CGAL/Bounding_arcs_2/query/closest_point.h>
#include <CGAL/Bounding_arcs_2/query/point_location.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>

namespace bounding_arcs_test {

// What bounds the regions, found in another way: the outline, or all that is drawn in a frame.
class Bounds {
 public:
  // \param are_slits_walls whether slits are there that are narrower than curves may be moved by
  Bounds(const Axis_case& of, bool are_slits_walls)
      : size_(size_of(of.drawing)), frame_(of.drawing), rule_(of.options.rule) {
    if (of.options.is_framed) {
      rule_ = ba::Fill_rule::NONZERO;
      frame_ = drawing_of(of.drawing.curves().back().beziers);
    }
    inside_ = std::make_unique<ba::Bounding_arc_tree_2>(frame_);
    if (of.options.is_framed) walls_ = of.drawing;
    else add_outline(of, are_slits_walls);
    tree_ = std::make_unique<ba::Bounding_arc_tree_2>(walls_);
  }
  [[nodiscard]] double size() const { return size_; }
  [[nodiscard]] bool has_slits() const { return has_slits_; }
  [[nodiscard]] bool empty() const { return walls_.curves().empty(); }
  [[nodiscard]] auto closest(const Point& p) const { return ba::closest_point(*tree_, p); }
  [[nodiscard]] bool is_inside(const Point& p) const { return ba::locate(*inside_, p, rule_) == CGAL::ON_BOUNDED_SIDE; }

 private:
  void add_outline(const Axis_case& of, bool are_slits_walls) {
    const ba::Bounding_arc_tree_2 tree(of.drawing);
    for (const auto& curve : ba::drawn_outline({&tree}, ba::outline(tree, of.options.rule), {false}).drawing.curves()) {
      if (is_speck(curve.beziers)) continue;
      for (const Bezier& piece : curve.beziers) {
        if (!is_slit(piece) || are_slits_walls) walls_.add({piece});
        else has_slits_ = true;
      }
    }
  }
  // Whether a loop is no larger than what curves may be moved by.
  [[nodiscard]] bool is_speck(const std::vector<Bezier>& loop) const {
    const Point at = loop.front().control_points().front();
    const auto is_there = [&](const Point& p) { return std::hypot(p.x - at.x, p.y - at.y) <= 0x1p-40 * size_; };
    return std::all_of(loop.begin(), loop.end(), [&](const Bezier& piece) {
      return std::all_of(piece.control_points().begin(), piece.control_points().end(), is_there);
    });
  }
  // Whether all is inside beside the middle of a piece.
  [[nodiscard]] bool is_slit(const Bezier& piece) const {
    const Point q = piece.point(0.5), way = piece.point(0.75) - piece.point(0.25);
    const double length = std::hypot(way.x, way.y), beside = 4 * 0x1p-40 * size_ / length;
    if (!(length > 0x1p-40 * size_)) return false;
    return is_inside(q + beside * Point{-way.y, way.x}) && is_inside(q + beside * Point{way.y, -way.x});
  }

  double size_;
  bool has_slits_ = false;
  Drawing walls_, frame_;
  ba::Fill_rule rule_;
  std::unique_ptr<ba::Bounding_arc_tree_2> tree_, inside_;
};

inline double distance_between(const Point& a, const Point& b) { return std::hypot(a.x - b.x, a.y - b.y); }
inline double distance_to_line(const Point& q, const Point& a, const Point& b) {
  const Point way = b - a;
  const double square = way.x * way.x + way.y * way.y,
               t = square > 0 ? ((q.x - a.x) * way.x + (q.y - a.y) * way.y) / square : 0;
  return distance_between(q, a + std::clamp(t, 0.0, 1.0) * way);
}

inline void require_disc(const Bounds& bounds, const Point& center, double radius, double room, const char* what) {
  const auto d = bounds.closest(center)->distance;
  if (d.upper < radius - room || d.lower > radius + room)
    throw Fault(what, "radius " + std::to_string(radius) + " for a distance that is off by " +
                          std::to_string((d.upper - radius) / bounds.size() * 1e12) + "e-12 of the size");
}
// Discs touch, and hold nothing; between samples they do so within eps.
inline void require_discs(const Bounds& bounds, const ba::Medial_axis_2& axis) {
  const double room = 0x1p-40 * bounds.size();
  if (!(axis.moved <= room)) throw Fault("moved", "it is too much");
  for (const auto& v : axis.vertices) require_disc(bounds, v.center, v.radius, axis.moved + room, "vertex");
  for (const auto& e : axis.edges)
    for (std::size_t i = 0; i < e.samples.size(); ++i) {
      const auto& s = e.samples[i];
      require_disc(bounds, s.center, s.radius, axis.moved + room, "sample");
      if (i > 0)
        require_disc(bounds, 0.5 * (e.samples[i - 1].center + s.center), 0.5 * (e.samples[i - 1].radius + s.radius),
                     axis.eps + room, "between samples");
    }
}
// No branch is missing: discs that grow from random points, where these are nearest, end on the axis.
inline void require_whole(const Bounds& bounds, const ba::Medial_axis_2& axis, std::mt19937& random, int count) {
  const double size = bounds.size();
  std::uniform_real_distribution<double> coordinate(-size, size);
  for (int i = 0; i < count; ++i) {
    const Point q{coordinate(random), coordinate(random)};
    const auto nearest = bounds.closest(q);
    const double d = nearest->distance.lower;
    if (!(d > 1e-3 * size) || !bounds.is_inside(q)) continue;
    const Point p = nearest->point, way = q - p, normal = (1 / std::hypot(way.x, way.y)) * way;
    double low = d, high = 8 * size;
    for (int k = 0; k < 60; ++k) {
      const double r = (low + high) / 2;
      (bounds.closest(p + r * normal)->distance.upper < r - 1e-9 * size ? high : low) = r;
    }
    const Point center = p + low * normal;
    double least = HUGE_VAL;
    for (const auto& v : axis.vertices) least = (std::min)(least, distance_between(center, v.center));
    for (const auto& e : axis.edges)
      for (std::size_t k = 1; k < e.samples.size(); ++k)
        least = (std::min)(least, distance_to_line(center, e.samples[k - 1].center, e.samples[k].center));
    // where discs grow along a curve that hardly bends away, 1e-9 of the distance is much of the radius
    if (!(least <= 2e-3 * size))
      throw Fault("missing branch", "at " + std::to_string(center.x) + " " + std::to_string(center.y));
  }
}

inline ba::Medial_axis_2 axis_of_case(const Axis_case& of, double eps) {
  return ba::medial_axis(ba::Bounding_arc_tree_2(of.drawing), eps, of.options);
}
template <class Check> void told_of(const Axis_case& of, const Check& check) {
  try {
    check();
  } catch (const std::exception& e) {
    std::string text = e.what();
    if (text.find(": ") == std::string::npos) text = "exception: " + text;
    const char* how =
        of.options.is_framed ? "frame" : (of.options.rule == ba::Fill_rule::NONZERO ? "nonzero" : "evenodd");
    throw std::runtime_error(text + '\n' + how + '\n' + json_text(of.drawing));
  }
}

// The curves that an axis is of: those that were given, or these moved by no more than it tells.
inline Axis_case moved_case(const Axis_case& drawn, const ba::Medial_axis_2& axis) {
  if (!axis.bounds) return drawn;  // far from the origin, where parts are not kept
  Axis_case moved{axis.bounds->segments.drawing(), drawn.options};
  for (std::size_t c = 0; c < drawn.drawing.curves().size(); ++c)
    for (std::size_t b = 0; b < drawn.drawing.curves()[c].beziers.size(); ++b) {
      const Bezier &given = drawn.drawing.curves()[c].beziers[b], &now = moved.drawing.curves()[c].beziers[b];
      if (given.weights() != now.weights()) throw Fault("moved", "weights are others");
      for (std::size_t i = 0; i < given.control_points().size(); ++i)
        if (distance_between(given.control_points()[i], now.control_points()[i]) > axis.moved)
          throw Fault("moved", "it is less than what curves were");
    }
  return moved;
}

inline void check_case(const Axis_case& drawn, std::mt19937& random) {
  const ba::Medial_axis_2 axis = axis_of_case(drawn, 1e-4 * size_of(drawn.drawing));
  if (axis.status != ba::Medial_axis_2::Status::COMPLETE)
    throw Fault("unresolved", axis.unresolved.empty() ? "anywhere"
                                                      : std::to_string(axis.unresolved.front().x) + " " +
                                                            std::to_string(axis.unresolved.front().y));
  if (!axis.is_valid()) throw Fault("invalid", std::to_string(axis.vertices.size()));
  const auto require_axis_of = [&](const Bounds& bounds) {
    if (bounds.empty()) return;
    require_discs(bounds, axis);
    require_whole(bounds, axis, random, 8);
  };
  const Axis_case moved = moved_case(drawn, axis);
  const Bounds bounds(moved, false);
  try {
    require_axis_of(bounds);
  } catch (const Fault&) {
    if (!bounds.has_slits()) throw;
    require_axis_of(Bounds(moved, true));  // less than curves may be moved by: there or not, both are right
  }
}

}  // namespace bounding_arcs_test

#endif
