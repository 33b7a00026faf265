// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether the feet of an axis tile the boundary of its regions: each side of a curve once where a region is, and else
// not at all, and with feet in common.

#ifndef BOUNDING_ARCS_LIBRARY_VERIFY_AXIS_TILING_H
#define BOUNDING_ARCS_LIBRARY_VERIFY_AXIS_TILING_H

#include "Axis_checker_curves.h"
#include "Checked_axis.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::verify {

class Axis_tiling {
 public:
  using Fault = Axis_verification::Fault;
  explicit Axis_tiling(Checked_axis& of) : of_(of) {}

  /// The part of the boundary between two feet.
  /// \return nothing where they are on no common piece
  [[nodiscard]] std::optional<Axis_tile> tile_of(const Curve_place& begin, const Curve_place& end,
                                                 const Medial_axis_2::Sample& first,
                                                 const Medial_axis_2::Sample& last) const {
    const auto plain = of_.tile_between(of_.names_of(begin), of_.names_of(end), first, last);
    if (plain || !of_.options.is_framed) return plain;
    return of_.tile_between(all_names(begin), all_names(end), first, last);
  }

  void add(const Axis_tile& tile) { tiles_.push_back(tile); }
  /// Checks all tiles together.
  void check() {
    match_feet();
    check_sides();
    check_gaps();
    check_shared_walls();
    check_sectors();
  }

 private:
  // A foot as a place on all pieces that have it: in a frame walls may run along each other.
  [[nodiscard]] std::vector<Curve_place> all_names(const Curve_place& foot) const {
    std::vector<Curve_place> result{foot};
    for (const Curve_place& p : of_.boxes.places_near(of_.point(foot), of_.room))
      if (!is_of_piece(p, foot)) result.push_back(p);
    return result;
  }
  static bool is_of_piece(const Curve_place& p, const Curve_place& q) {
    return p.curve == q.curve && p.bezier == q.bezier;
  }

  struct Sector {
    Xy<double> center;
    Curve_place begin, end;
    bool is_whole = false;
  };
  // Each line to a foot is a side of two cells, or a sector about the center of its disc is between them.
  void match_feet() {
    struct Feet {
      std::vector<Curve_place> begins, ends;
    };
    std::map<std::pair<double, double>, Feet> of_centers;
    for (const Axis_tile& t : tiles_) {
      of_centers[{t.first->center.x, t.first->center.y}].begins.push_back(t.begin);
      of_centers[{t.last->center.x, t.last->center.y}].ends.push_back(t.end);
    }
    for (auto& [center, feet] : of_centers) {
      for (const Curve_place& end : feet.ends) {
        const auto begin = std::find_if(feet.begins.begin(), feet.begins.end(), [&](const Curve_place& p) {
          return distance(of_.point(p), of_.point(end)) <= of_.room;
        });
        if (begin != feet.begins.end()) feet.begins.erase(begin);
        else sectors_.push_back({{center.first, center.second}, end, {}});
      }
      // what is left touches arcs
      for (Sector& sector : sectors_) {
        if (sector.center.x != center.first || sector.center.y != center.second || feet.begins.empty()) continue;
        auto end = std::find_if(feet.begins.begin(), feet.begins.end(),
                                [&](const Curve_place& p) { return !common_curves(sector.begin, p).empty(); });
        if (end == feet.begins.end()) --end;
        sector.end = *end, sector.is_whole = true;
        feet.begins.erase(end);
      }
      if (!feet.begins.empty()) of_.find(Fault::TILING, "foot at " + text_of(feet.begins.front()));
    }
  }
  // The boundary between the feet of a sector is an arc of a curve that is there in place of tiles.
  void check_sectors() {
    for (const Sector& s : sectors_)
      if (!s.is_whole || !is_beside_touched_arc(s)) of_.find(Fault::TILING, "foot at " + text_of(s.begin));
  }
  [[nodiscard]] bool is_beside_touched_arc(const Sector& s) const {
    // round a joint: a gap on either side of it
    if (distance(of_.point(s.begin), of_.point(s.end)) <= 2 * of_.room) return true;
    const std::vector<std::size_t> curves = common_curves(s.begin, s.end);
    return std::any_of(curves.begin(), curves.end(), [&](std::size_t curve) { return touched_arcs_.count(curve) > 0; });
  }
  // Curves that both feet are on. In a frame either may have the name of another wall, which goes on from there.
  [[nodiscard]] std::vector<std::size_t> common_curves(const Curve_place& a, const Curve_place& b) const {
    const auto names = [this](const Curve_place& foot) {
      return of_.options.is_framed ? all_names(foot) : std::vector<Curve_place>{foot};
    };
    std::vector<std::size_t> curves;
    for (const Curve_place& p : names(a))
      for (const Curve_place& q : names(b))
        if (p.curve == q.curve) curves.push_back(p.curve);
    return curves;
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
    for (auto& side : tiled_) side.resize(of_.curves.curves().size());
    short_.resize(of_.curves.curves().size());
    for (const Axis_tile& t : tiles_)
      (t.is_point ? short_[t.begin.curve] : tiled(t.begin.curve, is_on_left(t)))
          .push_back({t.begin.bezier, (std::min)(t.begin.t, t.end.t), (std::max)(t.begin.t, t.end.t)});
    for (std::vector<Range>& ranges : short_) sort(ranges);
    std::size_t rings = 0;
    for (std::size_t i = 0; i < of_.curves.curves().size(); ++i) {
      const auto [has_left, has_right] = of_.sides[i];
      for (const bool is_left : {true, false}) {
        const bool is_wanted = is_left ? has_left : has_right;
        rings += is_wanted ? 1 : 0;
        if (is_wanted) check_side(i, is_left);
        else if (!tiled(i, is_left).empty())
          of_.find(Fault::TILING, "a side without a region of curve " + std::to_string(i));
      }
    }
    if (!of_.options.is_framed && rings != of_.axis.regions + of_.axis.holes)
      of_.find(Fault::EULER, "sides of curves that bound a region");
  }
  static bool is_on_left(const Axis_tile& t) { return t.begin.t < t.end.t; }
  [[nodiscard]] std::vector<Range>& tiled(std::size_t curve, bool is_left) { return tiled_[is_left ? 0 : 1][curve]; }
  static void sort(std::vector<Range>& ranges) {
    std::sort(ranges.begin(), ranges.end(), [](const Range& a, const Range& b) {
      return a.bezier != b.bezier ? a.bezier < b.bezier : a.low < b.low;
    });
  }
  void check_side(std::size_t curve, bool is_left) {
    std::vector<Range>& ranges = tiled(curve, is_left);
    sort(ranges);
    std::size_t next = 0;
    for (std::size_t b = 0; b < of_.curves.curves()[curve].beziers.size(); ++b) {
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
    const auto length = [&](double from) { return distance(of_.point(at(from)), of_.point(at(next))); };
    double gap = length(t);
    if (gap > of_.room && t < next) gap = length(t = behind_short_tiles(at(t), next));
    if (gap <= of_.room) {
      of_.result.gap = (std::max)(of_.result.gap, gap);
      return;
    }
    if (next < t) of_.find(Fault::TILING, text_of(at(t)), gap);
    else if (is_touched_arc(of_.piece(at(t)), t, next)) ++touched_arcs_[curve];
    else gaps_.push_back({at(t), next, gap, is_left});
  }
  // Where a gap begins when tiles too short to tell their side are counted, each of which begins where one ends.
  [[nodiscard]] double behind_short_tiles(const Curve_place& from, double to) const {
    double t = from.t;
    for (const Range& r : short_[from.curve]) {
      if (r.bezier == from.bezier && r.low <= t && r.high > t) t = (std::min)(r.high, to);
    }
    return t;
  }
  // Whether curves run about the same way at two places.
  [[nodiscard]] bool is_along(const Curve_place& p, const Curve_place& q) const {
    return CGAL::to_double(dot(of_.jet(p).derivative, of_.jet(q).derivative)) > 0;
  }
  // Whether another piece has the place, and a tile there on the same side.
  [[nodiscard]] bool is_tiled_elsewhere(const Curve_place& at, bool is_left) const {
    if (!of_.options.is_framed) return false;
    const Xy<double> p = of_.point(at);
    for (const Curve_place& q : of_.boxes.places_near(p, of_.room)) {
      if (is_of_piece(q, at)) continue;
      const std::vector<Range>& ranges = tiled_[is_left == is_along(at, q) ? 0 : 1][q.curve];
      const auto holds = [&](const Range& r) {
        return r.bezier == q.bezier &&
               distance(of_.point({q.curve, q.bezier, std::clamp(q.t, r.low, r.high)}), p) <= 2 * of_.room;
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
    for (const Axis_tile& t : tiles_) {
      if (!t.is_point && is_tiled_elsewhere(place_at(t, 0.5), is_on_left(t)))
        twice += distance(of_.point(t.begin), of_.point(t.end));
    }
    if (twice > SHARE * of_.size) of_.find(Fault::TILING, "walls that run along each other", twice);
  }
  // What no disc touches. In a tip whose sides leave it alike they are one for a way: no region is between these.
  void check_gaps() {
    for (const Gap& gap : gaps_) {
      const int count = 8 * of_.piece(gap.from).degree() + 1;
      const auto is_beside_another = [&](const Curve_place& at) {
        return std::any_of(gaps_.begin(), gaps_.end(), [&](const Gap& other) {
          if (&other == &gap) return false;
          const Curve_place near = nearest_of(other, of_.point(at));
          return distance(of_.point(at), of_.point(near)) <= of_.room &&
                 (other.is_left == gap.is_left) != is_along(at, near) && !is_tiled_elsewhere(near, other.is_left);
        });
      };
      bool is_nothing = true;
      for (int i = 0; i < count && is_nothing; ++i) {
        const double t = gap.from.t + (gap.to - gap.from.t) * i / (count - 1);
        const Curve_place at{gap.from.curve, gap.from.bezier, t};
        is_nothing = is_beside_another(at) || is_tiled_elsewhere(at, gap.is_left);
      }
      if (!is_nothing) of_.find(Fault::TILING, text_of(gap.from), gap.length);
    }
  }
  // By halving: such a part hardly turns. Where it does, another point is farther away.
  [[nodiscard]] Curve_place nearest_of(const Gap& gap, const Xy<double>& p) const {
    const Bezier_curve_2<double>& bezier = of_.piece(gap.from);
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
        if (miss_of(point_at(bezier, t0 + (t1 - t0) * i / (count - 1)), center, radius) > of_.room) return false;
      return true;
    };
    for (const Medial_axis_2::Vertex& v : of_.axis.vertices)
      if (is_on(v.center, v.radius)) return true;
    return false;
  }

  Checked_axis& of_;
  std::vector<Axis_tile> tiles_;
  std::vector<Sector> sectors_;
  std::vector<std::vector<Range>> tiled_[2];         // of each curve, to the left and to the right
  std::vector<std::vector<Range>> short_;            // of each curve
  std::vector<Gap> gaps_;                            // of the boundary, between feet
  std::map<std::size_t, std::size_t> touched_arcs_;  // of each curve
};

}  // namespace CGAL::Bounding_arcs::verify

#endif
