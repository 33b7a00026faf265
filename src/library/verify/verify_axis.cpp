// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of verify/verify_axis.h.

#include <CGAL/Bounding_arcs_2/curve/Unit.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/verify/verify_axis.h>
#include "../medial_axis/Axis_editor.h"
#include "Axis_checker_curves.h"
#include "Axis_tiling.h"
#include "Checked_axis.h"

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::Bounding_arcs {

namespace verify {

namespace {

// The steps of a check of an axis; see verify_axis.h.
class Axis_checker {
 public:
  /// Curves and axis have a size near 1.
  Axis_checker(const Drawing_2<double>& curves, const Medial_axis_2& axis, const Axis_verification::Options& options)
      : of_(curves, axis, options) {}

  [[nodiscard]] Axis_verification check() {
    of_.result.vertices = of_.axis.vertices.size();
    of_.result.edges = of_.axis.edges.size();
    if (!has_form()) return of_.result;
    const CGAL::Protect_FPU_rounding<true> protection;
    check_ends();
    check_euler();
    check_vertices();
    Axis_tiling tiling(of_);
    for (std::size_t i = 0; i < of_.axis.edges.size(); ++i) add_cells(i, tiling);
    of_.result.tiles = 2 * cells_.size();
    for (const Line& line : cells_)
      if (!are_in_order(line.cells)) of_.find(Fault::CELL, sample_name(line.edge, line.sample));
    tiling.check();
    CGAL::Protect_FPU_rounding<true> nearest(CGAL_FE_TONEAREST);
    for (std::size_t i = 0; i < of_.axis.edges.size(); ++i) check_discs(i);
    for (const Line& line : cells_) check_line(line);
    for (std::size_t i = 0; i < of_.axis.vertices.size(); ++i)
      expect_empty(of_.axis.vertices[i].center, of_.axis.vertices[i].radius, vertex_name(i));
    return of_.result;
  }

 private:
  using Fault = Axis_verification::Fault;
  static std::string vertex_name(std::size_t i) { return "vertex " + std::to_string(i); }
  static std::string sample_name(std::size_t edge, std::size_t sample) {
    return "edge " + std::to_string(edge) + ", sample " + std::to_string(sample);
  }
  [[nodiscard]] double bound(std::size_t edge) const {
    return of_.options.bounds.empty() ? of_.axis.eps : of_.options.bounds[edge];
  }

  [[nodiscard]] bool is_place(const Curve_place& p) const {
    return p.curve < of_.curves.curves().size() && p.bezier < of_.curves.curves()[p.curve].beziers.size() && p.t >= 0 &&
           p.t <= 1;
  }
  static bool is_disc(const Xy<double>& c, double r) {
    return std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(r) && r >= 0;
  }
  bool has_form() {
    for (std::size_t i = 0; i < of_.axis.vertices.size(); ++i) {
      const Medial_axis_2::Vertex& v = of_.axis.vertices[i];
      const bool is_on_curves =
          std::all_of(v.touches.begin(), v.touches.end(), [&](const Curve_place& p) { return is_place(p); });
      if (!is_disc(v.center, v.radius) || v.touches.empty() || !is_on_curves) of_.find(Fault::FORM, vertex_name(i));
    }
    for (std::size_t i = 0; i < of_.axis.edges.size(); ++i) {
      const Medial_axis_2::Edge& e = of_.axis.edges[i];
      if (e.samples.size() < 2 || e.from >= of_.axis.vertices.size() || e.to >= of_.axis.vertices.size())
        of_.find(Fault::FORM, "edge " + std::to_string(i));
      for (std::size_t k = 0; k < e.samples.size(); ++k) {
        const Medial_axis_2::Sample& s = e.samples[k];
        if (!is_disc(s.center, s.radius) || !is_place(s.left) || !is_place(s.right))
          of_.find(Fault::FORM, sample_name(i, k));
      }
      of_.result.samples += e.samples.size();
    }
    return of_.result.is_right();
  }

  void check_ends() {
    for (std::size_t i = 0; i < of_.axis.edges.size(); ++i) {
      const Medial_axis_2::Edge& e = of_.axis.edges[i];
      check_end(e.samples.front(), of_.axis.vertices[e.from], sample_name(i, 0));
      check_end(e.samples.back(), of_.axis.vertices[e.to], sample_name(i, e.samples.size() - 1));
    }
  }
  void check_end(const Medial_axis_2::Sample& s, const Medial_axis_2::Vertex& v, const std::string& place) {
    if (s.center != v.center || s.radius != v.radius) of_.find(Fault::END, place);
    for (const Curve_place& foot : {s.left, s.right}) {
      const auto is_foot = [&](const Curve_place& p) { return distance(of_.point(p), of_.point(foot)) <= of_.room; };
      if (std::none_of(v.touches.begin(), v.touches.end(), is_foot)) of_.find(Fault::END, place);
    }
  }
  // Vertices less edges, and parts that hang together.
  void check_euler() {
    if (of_.axis.vertices.size() + of_.axis.holes != of_.axis.edges.size() + of_.axis.regions)
      of_.find(Fault::EULER, "vertices, edges, regions and holes");
    boost::disjoint_sets_with_storage<> sets(of_.axis.vertices.size());
    std::size_t parts = of_.axis.vertices.size();
    for (const Medial_axis_2::Edge& e : of_.axis.edges) {
      const std::size_t a = sets.find_set(e.from), b = sets.find_set(e.to);
      if (a != b) sets.link(a, b), --parts;
    }
    if (parts != of_.axis.regions) of_.find(Fault::EULER, "parts that hang together");
  }

  void check_vertices() {
    for (std::size_t i = 0; i < of_.axis.vertices.size(); ++i) {
      const Medial_axis_2::Vertex& v = of_.axis.vertices[i];
      for (const Curve_place& p : v.touches) {
        const double miss = miss_of(of_.jet(p), v.center, v.radius);
        of_.result.miss = (std::max)(of_.result.miss, miss);
        if (miss > vertex_room()) of_.find(Fault::TOUCH, vertex_name(i), miss);
      }
    }
  }
  // What vertices are told to miss by and what they are found within, in no more than 2^-40 of the size, and by what
  // curves were moved.
  [[nodiscard]] double vertex_room() const {
    return (std::min)(of_.room, of_.axis.error + 0x1p-43 * of_.size + of_.moved_by);
  }
  struct Line {
    Cells cells;
    std::size_t edge, sample;
  };
  void add_cells(std::size_t edge, Axis_tiling& tiling) {
    const std::vector<Medial_axis_2::Sample>& samples = of_.axis.edges[edge].samples;
    for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
      const Medial_axis_2::Sample &s = samples[i], &t = samples[i + 1];
      const auto left = tiling.tile_of(t.left, s.left, t, s), right = tiling.tile_of(s.right, t.right, s, t);
      if (!left || !right) {
        of_.find(Fault::TILING, sample_name(edge, i));
        continue;
      }
      cells_.push_back({{*left, *right}, edge, i});
      for (const Axis_tile& tile : {*left, *right}) {
        tiling.add(tile);
        expect_foot(tile, tile.begin, *tile.first, sample_name(edge, i));
        expect_foot(tile, tile.end, *tile.last, sample_name(edge, i));
      }
    }
  }

  // A foot a little beside the normal changes a cell by as much, and the disc by its square over twice the radius:
  // where that is no more than rounding, no coordinate tells the foot. At a joint a curve may turn by less than what
  // makes a corner.
  void expect_foot(const Axis_tile& tile, const Curve_place& foot, const Medial_axis_2::Sample& s,
                   const std::string& place) {
    constexpr double LEAST_TURN = 0x1p-21, LEAST_TOLD = 0x1p-48;  // the latter of the size
    const Checked_point p = of_.jet(foot);
    const double miss = miss_of(p, s.center, s.radius);
    of_.result.miss = (std::max)(of_.result.miss, miss);
    if (miss > of_.room) of_.find(Fault::FOOT, place, miss);
    const double speed = length(p.derivative).inf();
    if (tile.is_point || !(speed > 0)) return;
    const double aside = most_of(dot(checked(s.center) - p.point, p.derivative)) / speed;
    of_.result.aside = (std::max)(of_.result.aside, aside);
    const bool is_joint = foot.t == 0 || foot.t == 1;
    const double most = (std::max)(of_.small(), std::sqrt(2 * s.radius * LEAST_TOLD * of_.size));
    if (aside > most + (is_joint ? LEAST_TURN * s.radius : 0) && !is_beside_turn(foot, s))
      of_.find(Fault::FOOT, place, aside);
  }
  // A handle beside its node makes a curve turn within less than coordinates tell. A foot there is one of a curve that
  // is nowhere farther from the given one: beside it that is a line for as long as it leaves its tangent beyond by
  // nothing, and one of the normals on the way is that of the foot.
  [[nodiscard]] bool is_beside_turn(const Curve_place& foot, const Medial_axis_2::Sample& s) const {
    const Bezier_curve_2<double>& piece = of_.piece(foot);
    const double at_foot = along(piece, foot.t, s);
    for (const double end : {0.0, 1.0}) {
      double near = foot.t, far = end;
      constexpr int STEPS = 60;
      for (int i = 0; i < STEPS; ++i) {
        const double t = near + 0.5 * (far - near);
        (distance_from_tangent(piece, t, foot.t) <= of_.room ? near : far) = t;
      }
      double way = near - foot.t;
      if (way == 0 || !turns_at_once(piece, foot.t, near)) continue;
      for (int i = 0; i < STEPS; ++i, way /= 2) {
        const double at = along(piece, foot.t + way, s);
        if (at_foot * at <= 0 || std::fabs(at) <= of_.small()) return true;
      }
    }
    return false;
  }
  // Whether most of what is turned between two parameters is within their first quarter: a curve that turns alike
  // everywhere has normals of its own.
  [[nodiscard]] static bool turns_at_once(const Bezier_curve_2<double>& piece, double from, double to) {
    const Checked_vector first = point_at(piece, from).derivative;
    const auto turn = [&](double t) {
      const Checked_vector d = point_at(piece, t).derivative;
      return std::fabs(std::atan2(CGAL::to_double(cross(first, d)), CGAL::to_double(dot(first, d))));
    };
    return 2 * turn(from + (to - from) / 4) >= turn(to);
  }
  // How far the center is along the tangent at a place.
  [[nodiscard]] static double along(const Bezier_curve_2<double>& piece, double t, const Medial_axis_2::Sample& s) {
    const Checked_point p = point_at(piece, t);
    return CGAL::to_double(dot(checked(s.center) - p.point, p.derivative) / length(p.derivative));
  }

  // Whether cells are not turned inside out. A line that crosses the boundary, in a tip, is parted by discs between:
  // nothing else of the cells changes.
  [[nodiscard]] bool are_in_order(const Cells& cells, int halvings = 0) const {
    if ((is_in_order(cells.left) && is_in_order(cells.right)) || is_tip_in_order(cells)) return true;
    constexpr int MOST_HALVINGS = 8;
    const auto middle = halvings < MOST_HALVINGS ? of_.disc_between(cells) : std::nullopt;
    if (!middle) return false;
    Cells first = cells, last = cells;
    first.left.begin = last.left.end = middle->left;
    first.right.end = last.right.begin = middle->right;
    first.left.first = last.left.last = first.right.last = last.right.first = &*middle;
    return are_in_order(first, halvings + 1) && are_in_order(last, halvings + 1);
  }

  // In a tip without an angle the line to the corner may cross a side, however short it is. Both cells together are the
  // triangle from a center to both feet, and what both sides and the chord between their feet x and y enclose, where
  // no side meets the chord again.
  [[nodiscard]] bool is_tip_in_order(const Cells& cells) const {
    const bool is_last = cells.right.last->radius == 0;
    if (!is_last && cells.right.first->radius != 0) return false;
    const Axis_tile &to = is_last ? cells.right : cells.left, &from = is_last ? cells.left : cells.right;
    const Checked_vector x = of_.jet(to.begin).point, y = of_.jet(from.end).point;
    const Checked_vector c = checked((is_last ? cells.right.first : cells.right.last)->center);
    if (!(distance(of_.point(to.end), of_.point(from.begin)) <= of_.room) || !is_left(x, y, c)) return false;
    for (const Axis_tile* tile : {&to, &from}) {
      const auto [low, high] = std::minmax(tile->begin.t, tile->end.t);
      if (low == high) continue;
      const Bezier_curve_2<double> part = of_.piece(tile->begin).subcurve(low, high);
      for (const Xy<double>& p : part.control_points())
        if (!is_left(y, x, checked(p))) return false;
    }
    return true;
  }
  // A cell is not turned inside out: either of its diagonals has two triangles to the left of their sides. What of the
  // boundary is on the inside of its chord is in the cell by its control points.
  [[nodiscard]] bool is_in_order(const Axis_tile& tile) const {
    const Checked_vector p = of_.jet(tile.begin).point, q = of_.jet(tile.end).point;
    const Checked_vector c = checked(tile.first->center), d = checked(tile.last->center);
    if (length(q - p).sup() + length(d - c).sup() <= of_.small()) return true;
    const bool is_by_first = is_left(p, q, d) && is_left(p, d, c), is_by_second = is_left(p, q, c) && is_left(q, d, c);
    if (!is_by_first && !is_by_second) return false;
    if (tile.begin.t == tile.end.t) return true;
    const double low = (std::min)(tile.begin.t, tile.end.t), high = (std::max)(tile.begin.t, tile.end.t);
    const Bezier_curve_2<double> part = of_.piece(tile.begin).subcurve(low, high);
    const Checked_vector chord = q - p;
    for (int i = 1; i < part.degree(); ++i) {
      const Checked_vector x = checked(part.control_points()[static_cast<std::size_t>(i)]);
      const bool is_inside = (cross(chord, x - p) - Checked_number(of_.room) * length(chord)).sup() > 0;
      if (is_inside && !(is_left(q, d, x) && is_left(d, c, x) && is_left(c, p, x))) return false;
    }
    return true;
  }
  // Whether r is to the left of the way from p to q, or within rounding on it.
  [[nodiscard]] bool is_left(const Checked_vector& p, const Checked_vector& q, const Checked_vector& r) const {
    const Checked_vector way = q - p;
    return length(way).sup() <= of_.room || (cross(way, r - p) + Checked_number(of_.room) * length(way)).inf() >= 0;
  }

  void expect_empty(const Xy<double>& center, double radius, const std::string& place) {
    constexpr double SHARE = 1.0 / 32;  // of eps, as verify_axis tells
    ++of_.result.discs;
    const double depth = of_.boxes.depth_in(center, radius - (std::max)(of_.room, SHARE * of_.axis.eps));
    if (depth > 0) of_.find(Fault::DISC, place, depth);
  }
  void check_discs(std::size_t edge) {
    const std::vector<Medial_axis_2::Sample>& samples = of_.axis.edges[edge].samples;
    for (std::size_t i = 0; i < samples.size(); ++i)
      expect_empty(samples[i].center, samples[i].radius, sample_name(edge, i));
  }
  // How far a disc is from the line between two others, centers and radii together.
  [[nodiscard]] static double distance_from_line(const Medial_axis_2::Sample& d, const Medial_axis_2::Sample& s,
                                                 const Medial_axis_2::Sample& t) {
    const Xy<double> chord = t.center - s.center, way = d.center - s.center;
    const double square = dot(chord, chord), share = square > 0 ? std::clamp(dot(way, chord) / square, 0.0, 1.0) : 0;
    return stable_norm(way - share * chord) + std::fabs(s.radius + share * (t.radius - s.radius) - d.radius);
  }
  void check_line(const Line& line) {
    const auto disc = of_.disc_between(line.cells);
    // where feet are next to each other radii are not to be had well enough from them
    constexpr double NEAR = 0x1p-16;
    if (!disc || distance(of_.point(disc->left), of_.point(disc->right)) <= NEAR * of_.size) return;
    const std::string place = sample_name(line.edge, line.sample);
    const double deviation = distance_from_line(*disc, *line.cells.right.first, *line.cells.right.last);
    of_.result.deviation = (std::max)(of_.result.deviation, deviation);
    if (deviation > bound(line.edge) + of_.room) of_.find(Fault::BOUND, place, deviation);
    expect_empty(disc->center, disc->radius, place + " and behind");
  }
  Checked_axis of_;
  std::vector<Line> cells_;
};

}  // namespace

}  // namespace verify

const char* Axis_verification::name_of(Fault fault) {
  static constexpr const char* NAMES[] = {"FORM",   "END",  "EULER", "TOUCH", "FOOT",
                                          "TILING", "CELL", "DISC",  "BOUND"};  // as they are declared
  return NAMES[static_cast<std::size_t>(fault)];
}

Axis_verification verify_axis(const Drawing_2<double>& curves, const Medial_axis_2& axis,
                              const Axis_verification::Options& options) {
  if (!options.bounds.empty() && options.bounds.size() != axis.edges.size())
    throw std::invalid_argument(
        expected("bounds", "one for each edge, " + text_of(axis.edges.size()), options.bounds.size()));
  const internal::Unit unit = internal::Unit::of_size(curves.coordinate_size());
  const Drawing_2<double> scaled_curves = internal::scaled(curves, unit);
  const Medial_axis_2 scaled_axis = internal::in(unit, axis);
  Axis_verification::Options scaled_options = options;
  for (double& b : scaled_options.bounds) b = unit.in(b);
  Axis_verification result = verify::Axis_checker(scaled_curves, scaled_axis, scaled_options).check();
  for (double* length : {&result.miss, &result.aside, &result.gap, &result.deviation}) *length = unit.out(*length);
  for (Axis_verification::Finding& f : result.findings) f.amount = unit.out(f.amount);
  return result;
}

}  // namespace CGAL::Bounding_arcs
