// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The steps of a check of an axis; see verify_axis.h.

#ifndef BOUNDING_ARCS_LIBRARY_VERIFY_AXIS_CHECKER_H
#define BOUNDING_ARCS_LIBRARY_VERIFY_AXIS_CHECKER_H

#include <CGAL/Bounding_arcs_2/curve/Unit.h>
#include <CGAL/Bounding_arcs_2/verify/verify_axis.h>
#include "Axis_checker_curves.h"
#include "Axis_tiles.h"

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::verify {

class Axis_checker {
 public:
  /// Curves and axis have a size near 1.
  Axis_checker(const Drawing_2<double>& curves, const Medial_axis_2& axis, const Axis_verification::Options& options)
      : curves_(curves), axis_(axis), options_(options), sides_(sides_of_curves(curves, options)),
        boxes_(with_a_side(curves, sides_)), size_(coordinate_size(curves)),
        moved_(axis.moved > 0 ? (std::min)(axis.moved, MOST * size_) : 0), room_(MOST * size_ + moved_) {}

  [[nodiscard]] Axis_verification check() {
    result_.vertices = axis_.vertices.size();
    result_.edges = axis_.edges.size();
    if (!has_form()) return result_;
    const CGAL::Protect_FPU_rounding<true> protection;
    check_ends();
    check_euler();
    check_vertices();
    for (std::size_t i = 0; i < axis_.edges.size(); ++i) add_cells(i);
    result_.tiles = 2 * cells_.size();
    for (const Line& line : cells_)
      if (!are_in_order(line.cells, 0)) find(Axis_verification::Fault::CELL, sample_name(line.edge, line.sample));
    match_feet();
    check_sides();
    check_gaps();
    check_shared_walls();
    check_sectors();
    CGAL::Protect_FPU_rounding<true> nearest(CGAL_FE_TONEAREST);
    for (std::size_t i = 0; i < axis_.edges.size(); ++i) check_discs(i);
    for (const Line& line : cells_) check_line(line);
    for (std::size_t i = 0; i < axis_.vertices.size(); ++i)
      expect_empty(axis_.vertices[i].center, axis_.vertices[i].radius, vertex_name(i));
    return result_;
  }

 private:
  static std::string vertex_name(std::size_t i) { return "vertex " + std::to_string(i); }
  static std::string sample_name(std::size_t edge, std::size_t sample) {
    return "edge " + std::to_string(edge) + ", sample " + std::to_string(sample);
  }
  void find(Axis_verification::Fault fault, std::string place, double amount = 0) {
    constexpr std::size_t MOST = 100;
    if (++result_.faults <= MOST) result_.findings.push_back({fault, std::move(place), amount});
  }
  [[nodiscard]] const Bezier_curve_2<double>& piece(const Curve_place& p) const { return piece_at(curves_, p); }
  [[nodiscard]] double bound(std::size_t edge) const {
    return options_.bounds.empty() ? axis_.eps : options_.bounds[edge];
  }

  [[nodiscard]] bool is_place(const Curve_place& p) const {
    return p.curve < curves_.curves().size() && p.bezier < curves_.curves()[p.curve].beziers.size() && p.t >= 0 &&
           p.t <= 1;
  }
  static bool is_disc(const Xy<double>& c, double r) {
    return std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(r) && r >= 0;
  }
  bool has_form() {
    for (std::size_t i = 0; i < axis_.vertices.size(); ++i) {
      const Medial_axis_2::Vertex& v = axis_.vertices[i];
      const bool is_on_curves =
          std::all_of(v.touches.begin(), v.touches.end(), [&](const Curve_place& p) { return is_place(p); });
      if (!is_disc(v.center, v.radius) || v.touches.empty() || !is_on_curves)
        find(Axis_verification::Fault::FORM, vertex_name(i));
    }
    for (std::size_t i = 0; i < axis_.edges.size(); ++i) {
      const Medial_axis_2::Edge& e = axis_.edges[i];
      if (e.samples.size() < 2 || e.from >= axis_.vertices.size() || e.to >= axis_.vertices.size())
        find(Axis_verification::Fault::FORM, "edge " + std::to_string(i));
      for (std::size_t k = 0; k < e.samples.size(); ++k) {
        const Medial_axis_2::Sample& s = e.samples[k];
        if (!is_disc(s.center, s.radius) || !is_place(s.left) || !is_place(s.right))
          find(Axis_verification::Fault::FORM, sample_name(i, k));
      }
      result_.samples += e.samples.size();
    }
    return result_.is_right();
  }

  void check_ends() {
    for (std::size_t i = 0; i < axis_.edges.size(); ++i) {
      const Medial_axis_2::Edge& e = axis_.edges[i];
      check_end(e.samples.front(), axis_.vertices[e.from], sample_name(i, 0));
      check_end(e.samples.back(), axis_.vertices[e.to], sample_name(i, e.samples.size() - 1));
    }
  }
  void check_end(const Medial_axis_2::Sample& s, const Medial_axis_2::Vertex& v, const std::string& place) {
    if (s.center != v.center || s.radius != v.radius) find(Axis_verification::Fault::END, place);
    for (const Curve_place& foot : {s.left, s.right}) {
      const auto is_foot = [&](const Curve_place& p) { return distance(point(p), point(foot)) <= room_; };
      if (std::none_of(v.touches.begin(), v.touches.end(), is_foot)) find(Axis_verification::Fault::END, place);
    }
  }
  [[nodiscard]] Xy<double> point(const Curve_place& p) const { return middle_at(curves_, p); }
  static double distance(const Xy<double>& p, const Xy<double>& q) { return stable_norm(p - q); }

  // Vertices less edges, and parts that hang together.
  void check_euler() {
    if (axis_.vertices.size() + axis_.holes != axis_.edges.size() + axis_.regions)
      find(Axis_verification::Fault::EULER, "vertices, edges, regions and holes");
    boost::disjoint_sets_with_storage<> sets(axis_.vertices.size());
    std::size_t parts = axis_.vertices.size();
    for (const Medial_axis_2::Edge& e : axis_.edges) {
      const std::size_t a = sets.find_set(e.from), b = sets.find_set(e.to);
      if (a != b) sets.link(a, b), --parts;
    }
    if (parts != axis_.regions) find(Axis_verification::Fault::EULER, "parts that hang together");
  }

  void check_vertices() {
    for (std::size_t i = 0; i < axis_.vertices.size(); ++i) {
      const Medial_axis_2::Vertex& v = axis_.vertices[i];
      for (const Curve_place& p : v.touches) {
        const double miss = miss_of(point_at(piece(p), p.t), v.center, v.radius);
        result_.miss = (std::max)(result_.miss, miss);
        if (miss > vertex_room()) find(Axis_verification::Fault::TOUCH, vertex_name(i), miss);
      }
    }
  }
  // What vertices are told to miss by and what they are found within, in no more than 2^-40 of the size, and by what
  // curves were moved.
  [[nodiscard]] double vertex_room() const { return (std::min)(room_, axis_.error + 0x1p-43 * size_ + moved_); }
  static double miss_of(const Checked_point& p, const Xy<double>& center, double radius) {
    return most_of(length(checked(center) - p.point) - Checked_number(radius));
  }

  struct Line {
    Cells cells;
    std::size_t edge, sample;
  };
  void add_cells(std::size_t edge) {
    const std::vector<Medial_axis_2::Sample>& samples = axis_.edges[edge].samples;
    for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
      const Medial_axis_2::Sample &s = samples[i], &t = samples[i + 1];
      const auto left = tile_of(t.left, s.left, t, s), right = tile_of(s.right, t.right, s, t);
      if (!left || !right) {
        find(Axis_verification::Fault::TILING, sample_name(edge, i));
        continue;
      }
      cells_.push_back({{*left, *right}, edge, i});
      for (const Axis_tile& tile : {*left, *right}) {
        expect_foot(tile, tile.begin, *tile.first, sample_name(edge, i));
        expect_foot(tile, tile.end, *tile.last, sample_name(edge, i));
      }
    }
  }

  [[nodiscard]] std::optional<Axis_tile> tile_of(const Curve_place& begin, const Curve_place& end,
                                                 const Medial_axis_2::Sample& first,
                                                 const Medial_axis_2::Sample& last) const {
    const auto plain =
        tile_between(curves_, names_of(curves_, begin, room_), names_of(curves_, end, room_), first, last, room_);
    if (plain || !options_.is_framed) return plain;
    return tile_between(curves_, all_names(begin), all_names(end), first, last, room_);
  }
  // A foot as a place on all pieces that have it: in a frame walls may run along each other.
  [[nodiscard]] std::vector<Curve_place> all_names(const Curve_place& foot) const {
    std::vector<Curve_place> result{foot};
    for (const Curve_place& p : boxes_.places_near(point(foot), room_))
      if (!is_of_piece(p, foot)) result.push_back(p);
    return result;
  }
  static bool is_of_piece(const Curve_place& p, const Curve_place& q) {
    return p.curve == q.curve && p.bezier == q.bezier;
  }

  // A line that crosses the boundary, in a tip, is parted by discs between: nothing else of the cells changes.
  [[nodiscard]] bool are_in_order(const Cells& cells, int halvings) const {
    if ((is_in_order(cells.left) && is_in_order(cells.right)) || is_tip_in_order(cells)) return true;
    constexpr int MOST_HALVINGS = 8;
    const auto middle = halvings < MOST_HALVINGS ? disc_between(curves_, cells, size_) : std::nullopt;
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
    const Checked_vector x = point_at(piece(to.begin), to.begin.t).point,
                         y = point_at(piece(from.end), from.end.t).point;
    const Checked_vector c = checked((is_last ? cells.right.first : cells.right.last)->center);
    if (!(distance(point(to.end), point(from.begin)) <= room_) || !is_left(x, y, c)) return false;
    for (const Axis_tile* tile : {&to, &from}) {
      const auto [low, high] = std::minmax(tile->begin.t, tile->end.t);
      if (low == high) continue;
      const Bezier_curve_2<double> part = piece(tile->begin).subcurve(low, high);
      for (const Xy<double>& p : part.control_points())
        if (!is_left(y, x, checked(p))) return false;
    }
    return true;
  }
  // A cell is not turned inside out: either of its diagonals has two triangles to the left of their sides. What of the
  // boundary is on the inside of its chord is in the cell by its control points.
  [[nodiscard]] bool is_in_order(const Axis_tile& tile) const {
    const Checked_vector p = point_at(piece(tile.begin), tile.begin.t).point,
                         q = point_at(piece(tile.end), tile.end.t).point;
    const Checked_vector c = checked(tile.first->center), d = checked(tile.last->center);
    if (length(q - p).sup() + length(d - c).sup() <= small()) return true;
    const bool is_by_first = is_left(p, q, d) && is_left(p, d, c), is_by_second = is_left(p, q, c) && is_left(q, d, c);
    if (!is_by_first && !is_by_second) return false;
    if (tile.begin.t == tile.end.t) return true;
    const double low = (std::min)(tile.begin.t, tile.end.t), high = (std::max)(tile.begin.t, tile.end.t);
    const Bezier_curve_2<double> part = piece(tile.begin).subcurve(low, high);
    const Checked_vector chord = q - p;
    for (int i = 1; i < part.degree(); ++i) {
      const Checked_vector x = checked(part.control_points()[static_cast<std::size_t>(i)]);
      const bool is_inside = (cross(chord, x - p) - Checked_number(room_) * length(chord)).sup() > 0;
      if (is_inside && !(is_left(q, d, x) && is_left(d, c, x) && is_left(c, p, x))) return false;
    }
    return true;
  }
  // What is moved by less is told with the bound.
  [[nodiscard]] double small() const {
    constexpr double SHARE = 1.0 / 16;  // of eps
    return (std::max)(room_, SHARE * axis_.eps);
  }
  // Whether r is to the left of the way from p to q, or within rounding on it.
  [[nodiscard]] bool is_left(const Checked_vector& p, const Checked_vector& q, const Checked_vector& r) const {
    const Checked_vector way = q - p;
    return length(way).sup() <= room_ || (cross(way, r - p) + Checked_number(room_) * length(way)).inf() >= 0;
  }
  // A foot a little beside the normal changes a cell by as much, and the disc by its square. At a joint a curve may
  // turn by less than what makes a corner.
  void expect_foot(const Axis_tile& tile, const Curve_place& foot, const Medial_axis_2::Sample& s,
                   const std::string& place) {
    constexpr double LEAST_TURN = 0x1p-21;
    const Checked_point p = point_at(piece(foot), foot.t);
    const double miss = miss_of(p, s.center, s.radius);
    result_.miss = (std::max)(result_.miss, miss);
    if (miss > room_) find(Axis_verification::Fault::FOOT, place, miss);
    const double speed = length(p.derivative).inf();
    if (tile.is_point || !(speed > 0)) return;
    const double aside = most_of(dot(checked(s.center) - p.point, p.derivative)) / speed;
    result_.aside = (std::max)(result_.aside, aside);
    const bool is_joint = foot.t == 0 || foot.t == 1;
    if (aside > small() + (is_joint ? LEAST_TURN * s.radius : 0)) find(Axis_verification::Fault::FOOT, place, aside);
  }

  template <class Visit> void for_each_tile(const Visit& visit) const {
    for (const Line& line : cells_) visit(line.cells.left), visit(line.cells.right);
  }

  // Each line to a foot is a side of two cells, or a sector about the center of its disc is between them.
  void match_feet() {
    struct Feet {
      std::vector<Curve_place> begins, ends;
    };
    std::map<std::pair<double, double>, Feet> of_centers;
    for_each_tile([&](const Axis_tile& t) {
      of_centers[{t.first->center.x, t.first->center.y}].begins.push_back(t.begin);
      of_centers[{t.last->center.x, t.last->center.y}].ends.push_back(t.end);
    });
    for (auto& [center, feet] : of_centers) {
      for (const Curve_place& end : feet.ends) {
        const auto begin = std::find_if(feet.begins.begin(), feet.begins.end(),
                                        [&](const Curve_place& p) { return distance(point(p), point(end)) <= room_; });
        if (begin != feet.begins.end()) feet.begins.erase(begin);
        else sectors_.push_back({{center.first, center.second}, end, {}});
      }
      // what is left touches an arc
      for (Sector& s : sectors_) {
        if (s.center.x != center.first || s.center.y != center.second || feet.begins.empty()) continue;
        s.end = feet.begins.back(), s.is_whole = true;
        feet.begins.pop_back();
      }
      if (!feet.begins.empty()) find(Axis_verification::Fault::TILING, "foot at " + text_of(feet.begins.front()));
    }
  }
  // The boundary between the feet of a sector is an arc of its curve that is there in place of tiles.
  void check_sectors() {
    for (const Sector& s : sectors_)
      if (!s.is_whole || s.begin.curve != s.end.curve || touched_arcs_[s.begin.curve] == 0)
        find(Axis_verification::Fault::TILING, "foot at " + text_of(s.begin));
  }
  static std::string text_of(const Curve_place& p) {
    return "curve " + std::to_string(p.curve) + ", piece " + std::to_string(p.bezier) + ", t " + std::to_string(p.t);
  }

  // Each side of a curve is tiled once where a region is, and else not at all. check_side() sorts its ranges.
  struct Range {
    std::size_t bezier;
    double low, high;
  };
  void check_sides() {
    for (auto& side : tiled_) side.resize(curves_.curves().size());
    for_each_tile([&](const Axis_tile& t) {
      if (!t.is_point)
        tiled(t.begin.curve, is_on_left(t))
            .push_back({t.begin.bezier, (std::min)(t.begin.t, t.end.t), (std::max)(t.begin.t, t.end.t)});
    });
    std::size_t rings = 0;
    for (std::size_t i = 0; i < curves_.curves().size(); ++i) {
      const auto [has_left, has_right] = sides_[i];
      for (const bool is_left : {true, false}) {
        const bool is_wanted = is_left ? has_left : has_right;
        rings += is_wanted ? 1 : 0;
        if (is_wanted) check_side(i, is_left);
        else if (!tiled(i, is_left).empty())
          find(Axis_verification::Fault::TILING, "a side without a region of curve " + std::to_string(i));
      }
    }
    if (!options_.is_framed && rings != axis_.regions + axis_.holes)
      find(Axis_verification::Fault::EULER, "sides of curves that bound a region");
  }
  static bool is_on_left(const Axis_tile& t) { return t.begin.t < t.end.t; }
  [[nodiscard]] std::vector<Range>& tiled(std::size_t curve, bool is_left) { return tiled_[is_left ? 0 : 1][curve]; }
  void check_side(std::size_t curve, bool is_left) {
    std::vector<Range>& ranges = tiled(curve, is_left);
    std::sort(ranges.begin(), ranges.end(), [](const Range& a, const Range& b) {
      return a.bezier != b.bezier ? a.bezier < b.bezier : a.low < b.low;
    });
    std::size_t next = 0;
    for (std::size_t b = 0; b < curves_.curves()[curve].beziers.size(); ++b) {
      double t = 0;
      for (; next < ranges.size() && ranges[next].bezier == b; ++next) {
        expect_joint(curve, b, t, ranges[next].low, is_left);
        t = ranges[next].high;
      }
      expect_joint(curve, b, t, 1, is_left);
    }
  }
  struct Gap {
    Curve_place from;
    double to, length;
    bool is_left;
  };
  void expect_joint(std::size_t curve, std::size_t bezier, double t, double next, bool is_left) {
    if (t == next) return;
    const auto at = [&](double s) {
      return Curve_place{static_cast<decltype(Curve_place::curve)>(curve),
                         static_cast<decltype(Curve_place::bezier)>(bezier), s};
    };
    const double gap = distance(point(at(t)), point(at(next)));
    if (gap <= room_) {
      result_.gap = (std::max)(result_.gap, gap);
      return;
    }
    if (next < t) find(Axis_verification::Fault::TILING, text_of(at(t)), gap);
    else if (is_touched_arc(piece(at(t)), t, next)) ++touched_arcs_[curve];
    else gaps_.push_back({at(t), next, gap, is_left});
  }
  // Whether curves run about the same way at two places.
  [[nodiscard]] bool is_along(const Curve_place& p, const Curve_place& q) const {
    return CGAL::to_double(dot(point_at(piece(p), p.t).derivative, point_at(piece(q), q.t).derivative)) > 0;
  }
  // Whether another piece has the place, and a tile there on the same side.
  [[nodiscard]] bool is_tiled_elsewhere(const Curve_place& at, bool is_left) const {
    if (!options_.is_framed) return false;
    const Xy<double> p = point(at);
    for (const Curve_place& q : boxes_.places_near(p, room_)) {
      if (is_of_piece(q, at)) continue;
      const std::vector<Range>& ranges = tiled_[is_left == is_along(at, q) ? 0 : 1][q.curve];
      const auto holds = [&](const Range& r) {
        return r.bezier == q.bezier &&
               distance(point({q.curve, q.bezier, std::clamp(q.t, r.low, r.high)}), p) <= 2 * room_;
      };
      const auto next = std::upper_bound(ranges.begin(), ranges.end(), q, [](const Curve_place& a, const Range& r) {
        return a.bezier != r.bezier ? a.bezier < r.bezier : a.t < r.low;
      });
      if ((next != ranges.end() && holds(*next)) || (next != ranges.begin() && holds(*std::prev(next)))) return true;
    }
    return false;
  }
  // Where walls run along each other, tiles are on one of them. Curves that touch are that near for less.
  void check_shared_walls() {
    constexpr double SHARE = 0x1p-8;  // of the size
    double twice = 0;
    for_each_tile([&](const Axis_tile& t) {
      if (!t.is_point && is_tiled_elsewhere(place_at(t, 0.5), is_on_left(t)))
        twice += distance(point(t.begin), point(t.end));
    });
    if (twice > SHARE * size_) find(Axis_verification::Fault::TILING, "walls that run along each other", twice);
  }
  // What no disc touches. In a tip whose sides leave it alike they are one for a way: no region is between these.
  void check_gaps() {
    for (const Gap& gap : gaps_) {
      const int count = 8 * piece(gap.from).degree() + 1;
      const auto is_beside_another = [&](const Curve_place& at) {
        return std::any_of(gaps_.begin(), gaps_.end(), [&](const Gap& other) {
          if (&other == &gap) return false;
          const Curve_place near = nearest_of(other, point(at));
          return distance(point(at), point(near)) <= room_ && (other.is_left == gap.is_left) != is_along(at, near) &&
                 !is_tiled_elsewhere(near, other.is_left);
        });
      };
      bool is_nothing = true;
      for (int i = 0; i < count && is_nothing; ++i) {
        const double t = gap.from.t + (gap.to - gap.from.t) * i / (count - 1);
        const Curve_place at{gap.from.curve, gap.from.bezier, t};
        is_nothing = is_beside_another(at) || is_tiled_elsewhere(at, gap.is_left);
      }
      if (!is_nothing) find(Axis_verification::Fault::TILING, text_of(gap.from), gap.length);
    }
  }
  // By halving: such a part hardly turns. Where it does, another point is farther away.
  [[nodiscard]] Curve_place nearest_of(const Gap& gap, const Xy<double>& p) const {
    const Bezier_curve_2<double>& bezier = piece(gap.from);
    double low = gap.from.t, high = gap.to;
    constexpr int STEPS = 60;
    for (int i = 0; i < STEPS; ++i) {
      const double t = low + 0.5 * (high - low);
      const Checked_point q = point_at(bezier, t);
      (CGAL::to_double(dot(checked(p) - q.point, q.derivative)) > 0 ? low : high) = t;
    }
    return {gap.from.curve, gap.from.bezier, low};
  }
  // A polynomial of twice the degree that is small in so many places is small between them.
  [[nodiscard]] bool is_touched_arc(const Bezier_curve_2<double>& bezier, double t0, double t1) const {
    const int count = 2 * bezier.degree() + 1;
    const auto is_on = [&](const Xy<double>& center, double radius) {
      for (int i = 0; i < count; ++i)
        if (miss_of(point_at(bezier, t0 + (t1 - t0) * i / (count - 1)), center, radius) > room_) return false;
      return true;
    };
    for (const Medial_axis_2::Vertex& v : axis_.vertices)
      if (is_on(v.center, v.radius)) return true;
    return false;
  }

  void expect_empty(const Xy<double>& center, double radius, const std::string& place) {
    constexpr double SHARE = 1.0 / 32;  // of eps, as verify_axis tells
    ++result_.discs;
    const double depth = boxes_.depth_in(center, radius - (std::max)(room_, SHARE * axis_.eps));
    if (depth > 0) find(Axis_verification::Fault::DISC, place, depth);
  }
  void check_discs(std::size_t edge) {
    const std::vector<Medial_axis_2::Sample>& samples = axis_.edges[edge].samples;
    for (std::size_t i = 0; i < samples.size(); ++i)
      expect_empty(samples[i].center, samples[i].radius, sample_name(edge, i));
  }
  void check_line(const Line& line) {
    const auto disc = disc_between(curves_, line.cells, size_);
    // where feet are next to each other radii are not to be had well enough from them
    constexpr double NEAR = 0x1p-16;
    if (!disc || distance(point(disc->left), point(disc->right)) <= NEAR * size_) return;
    const std::string place = sample_name(line.edge, line.sample);
    const double deviation = distance_from_line(*disc, *line.cells.right.first, *line.cells.right.last);
    result_.deviation = (std::max)(result_.deviation, deviation);
    if (deviation > bound(line.edge) + room_) find(Axis_verification::Fault::BOUND, place, deviation);
    expect_empty(disc->center, disc->radius, place + " and behind");
  }
  struct Sector {
    Xy<double> center;
    Curve_place begin, end;
    bool is_whole = false;
  };
  const Drawing_2<double>& curves_;
  const Medial_axis_2& axis_;
  const Axis_verification::Options& options_;
  std::vector<Curve_sides> sides_;
  Curves_in_boxes boxes_;                  // of what discs may touch; in a frame that is all, as they are numbered
  static constexpr double MOST = 0x1p-40;  // of the size
  double size_, moved_, room_;             // lengths below the latter are nothing
  Axis_verification result_;
  std::vector<Line> cells_;
  std::vector<Sector> sectors_;
  std::vector<std::vector<Range>> tiled_[2];         // of each curve, to the left and to the right
  std::vector<Gap> gaps_;                            // of the boundary, between feet
  std::map<std::size_t, std::size_t> touched_arcs_;  // of each curve
};

}  // namespace CGAL::Bounding_arcs::verify

#endif
