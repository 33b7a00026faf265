// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "order_passes.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>
#include <tuple>
#include <utility>

namespace bounding_arcs_tool {
namespace {

namespace ba = CGAL::Bounding_arcs;

CGAL::Bbox_2 box_of(const Tool_pass& pass) {
  CGAL::Bbox_2 all = ba::box(pass.pieces.front());
  for (const Arc_2& piece : pass.pieces) all += ba::box(piece);
  return all;
}
bool holds(const CGAL::Bbox_2& a, const CGAL::Bbox_2& b) {
  return a.xmin() <= b.xmin() && a.ymin() <= b.ymin() && b.xmax() <= a.xmax() && b.ymax() <= a.ymax();
}

// Whether q is between an arc and its chord.
bool is_beside_chord(const Xy<double>& q, const Arc_2& arc) {
  if (arc.bulge == 0) return false;
  const Arc_2 left = arc.bulge > 0 ? arc : ba::reversed(arc);
  return cross(left.to - left.from, q - left.from) < 0 && ba::view(q, left).side > 0;
}
// How often a closed pass runs round q: by the angles under which chords are seen, and what is beside these.
long winding_number(const Tool_pass& closed, const Xy<double>& q) {
  constexpr double TURN = 6.283185307179586;
  double angle = 0;
  long turns = 0;
  for (const Arc_2& piece : closed.pieces) {
    const Xy<double> u = piece.from - q, v = piece.to - q;
    angle += std::atan2(cross(u, v), dot(u, v));
    if (is_beside_chord(q, piece)) turns += piece.bulge > 0 ? 1 : -1;
  }
  return turns + std::lround(angle / TURN);
}

// The area that a closed pass encloses.
double area_of(const Tool_pass& closed) {
  double twice = 0;
  const Xy<double> origin = closed.from();
  for (const Arc_2& piece : closed.pieces) {
    twice += cross(piece.from - origin, piece.to - origin);
    const double turn = 2 * piece.half_turn();
    if (piece.bulge != 0 && piece.from != piece.to)
      twice += (turn - std::sin(turn)) * std::pow(ba::radius(piece), 2);  // of the arc and its chord
  }
  return std::fabs(twice) / 2;
}

Xy<double> middle_of_longest(const Tool_pass& pass) {
  const auto is_shorter = [](const Arc_2& a, const Arc_2& b) { return ba::length(a) < ba::length(b); };
  return ba::point(*std::max_element(pass.pieces.begin(), pass.pieces.end(), is_shorter), 0.5);
}

// Where passes may start, and which of these places is nearest: by a walk along x to both sides.
class Starts {
 public:
  explicit Starts(const std::vector<Tool_pass>& passes) : passes_(passes) {}

  void add(std::size_t number) {
    for (const Start& start : starts_of(number)) starts_.insert(start);
  }
  [[nodiscard]] bool is_empty() const { return starts_.empty(); }

  /// Takes the pass that starts nearest to a place, the first of those as near, and starts it there.
  std::pair<std::size_t, Tool_pass> take(const Xy<double>& place) {
    const Start best = nearest(place);
    for (const Start& start : starts_of(best.pass)) starts_.erase(start);
    const Tool_pass& pass = passes_[best.pass];
    if (best.joint == 0) return {best.pass, pass};
    return {best.pass, pass.is_closed() ? started_at(pass, best.joint) : reversed(pass)};
  }

 private:
  struct Start {
    Xy<double> point;
    std::size_t pass, joint;  // of an open one its start is joint 0, and its end 1
    bool is_deep = false;     // the other end of the pass is higher: the tool starts here if it is there already
    bool operator<(const Start& other) const {
      return std::tie(point.x, point.y, pass, joint) < std::tie(other.point.x, other.point.y, other.pass, other.joint);
    }
  };

  [[nodiscard]] std::vector<Start> starts_of(std::size_t number) const {
    const Tool_pass& pass = passes_[number];
    if (!pass.is_closed()) {
      const double rise = pass.height_at(pass.pieces.size()) - pass.height_at(0);
      return {{pass.from(), number, 0, rise > 0}, {pass.to(), number, 1, rise < 0}};
    }
    std::vector<Start> result;
    for (const Arc_2& piece : pass.pieces) result.push_back({piece.from, number, result.size()});
    return result;
  }
  [[nodiscard]] Start nearest(const Xy<double>& place) const {
    double least = std::numeric_limits<double>::infinity();
    const Start* best = nullptr;
    const auto is_nearer = [&](const Start& s) {  // false where none behind it is, either
      if (std::fabs(s.point.x - place.x) > least) return false;
      const double d = std::hypot(s.point.x - place.x, s.point.y - place.y);
      if (s.is_deep && d > 0) return true;
      const auto rank = [](const Start& start) { return std::tie(start.pass, start.joint); };
      if (best == nullptr || d < least || (d == least && rank(s) < rank(*best))) {
        least = d;
        best = &s;
      }
      return true;
    };
    const auto middle = starts_.lower_bound({place, 0, 0});
    for (auto it = middle; it != starts_.end() && is_nearer(*it); ++it) {
    }
    for (auto it = middle; it != starts_.begin() && is_nearer(*std::prev(it)); --it) {
    }
    return *best;
  }

  const std::vector<Tool_pass>& passes_;
  std::set<Start> starts_;
};

}  // namespace

std::vector<std::optional<std::size_t>> passes_around(const std::vector<Tool_pass>& passes) {
  std::vector<CGAL::Bbox_2> boxes;
  std::vector<double> areas;
  std::vector<std::size_t> closed;  // the smallest first, of equal ones the last
  for (std::size_t i = 0; i < passes.size(); ++i) {
    boxes.push_back(box_of(passes[i]));
    areas.push_back(passes[i].is_closed() ? area_of(passes[i]) : 0);
    if (areas.back() > 0) closed.push_back(i);
  }
  const auto size = [&](std::size_t i) { return std::make_tuple(areas[i], passes.size() - i); };
  std::sort(closed.begin(), closed.end(), [&](std::size_t a, std::size_t b) { return size(a) < size(b); });
  std::vector<std::optional<std::size_t>> around(passes.size());
  for (std::size_t i = 0; i < passes.size(); ++i) {
    const Xy<double> place = middle_of_longest(passes[i]);
    for (const std::size_t k : closed) {
      if (i == k || !(size(i) < size(k)) || !holds(boxes[k], boxes[i])) continue;
      if (winding_number(passes[k], place) == 0) continue;
      around[i] = k;
      break;
    }
  }
  return around;
}

std::vector<Tool_pass> inside_out(const std::vector<Tool_pass>& passes, const Xy<double>& from) {
  const std::vector<std::optional<std::size_t>> around = passes_around(passes);
  std::vector<std::size_t> inside(passes.size());  // how many are right inside of each and not yet cut
  for (const auto& outer : around)
    if (outer) ++inside[*outer];
  Starts starts(passes);
  for (std::size_t i = 0; i < passes.size(); ++i)
    if (inside[i] == 0) starts.add(i);
  std::vector<Tool_pass> result;
  Xy<double> place = from;
  while (!starts.is_empty()) {
    auto [number, pass] = starts.take(place);
    result.push_back(std::move(pass));
    place = result.back().to();
    if (around[number] && --inside[*around[number]] == 0) starts.add(*around[number]);
  }
  return result;
}

std::vector<Tool_pass> group_by_group(const std::vector<Tool_pass>& passes, const std::vector<std::size_t>& groups) {
  Starts firsts(passes), others(passes);
  for (std::size_t i = 0; i < passes.size(); ++i)
    if (i == 0 || groups[i] != groups[i - 1]) firsts.add(i);
  std::vector<Tool_pass> result;
  Xy<double> place{0, 0};
  const auto cut_next = [&](Starts& starts) {
    auto [number, pass] = starts.take(place);
    result.push_back(std::move(pass));
    place = result.back().to();
    return number;
  };
  while (!firsts.is_empty()) {
    const std::size_t first = cut_next(firsts);
    for (std::size_t i = first + 1; i < passes.size() && groups[i] == groups[first]; ++i) others.add(i);
    while (!others.is_empty()) (void)cut_next(others);
  }
  return result;
}

}  // namespace bounding_arcs_tool
