// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of medial_axis/voronoi_cells.h.

#include <CGAL/Bounding_arcs_2/medial_axis/voronoi_cells.h>
#include "../tree/Segment_hierarchy.h"
#include "Axis_editor.h"
#include "Bounding_parts.h"
#include "Line_parts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

namespace {

/// Places of curves near unit size.
class Places {
 public:
  explicit Places(const Segment_hierarchy& curves) : curves_(curves) {}

  [[nodiscard]] Xy<double> point(const Curve_place& p) const { return internal::point_at(curves_, p); }
  [[nodiscard]] std::uint32_t count(std::uint32_t curve) const {
    return static_cast<std::uint32_t>(curves_.drawing().curves()[curve].beziers.size());
  }
  [[nodiscard]] bool is_end(const Curve_place& p) const {
    return (p.bezier == 0 && p.t == 0) || (p.bezier + 1 == count(p.curve) && p.t == 1);
  }
  /// The name of a place of the same curve on a Bezier piece, if it is a joint of that.
  [[nodiscard]] Curve_place on_piece(const Curve_place& p, std::uint32_t bezier) const {
    const std::uint32_t n = count(p.curve);
    if (p.bezier == bezier || (is_end(p) && !curves_.drawing().curves()[p.curve].is_closed)) return p;
    if (p.t == 0 && (p.bezier + n - 1) % n == bezier) return {p.curve, bezier, 1};
    if (p.t == 1 && (p.bezier + 1) % n == bezier) return {p.curve, bezier, 0};
    return p;
  }
  /// +1 where the curve's parameter grows from one foot to the next, -1 where it falls, 0 where they are one place.
  [[nodiscard]] int direction(const Curve_place& from, const Curve_place& to) const {
    if (is_end(from) && is_end(to) && curves_.drawing().curves()[from.curve].is_closed) return 0;
    Curve_place p = from, q = on_piece(to, from.bezier);
    if (p.bezier != q.bezier) p = on_piece(from, to.bezier), q = to;
    if (p.bezier != q.bezier) return p.bezier < q.bezier ? 1 : -1;
    return (q.t > p.t) - (q.t < p.t);
  }
  [[nodiscard]] double distance(const Curve_place& p, const Curve_place& q) const {
    return euclidean_norm(point(q) - point(p));
  }

 private:
  const Segment_hierarchy& curves_;
};

/// Goes along the boundary of all regions by both sides of each edge: the right feet run along it, the left ones
/// against the edge's direction. Where a disc touches an arc of the boundary, feet go on along that.
class Cell_walk {
 public:
  Cell_walk(const Bounding_parts& bounds, const Medial_axis_2& axis)
      : places_(bounds.segments), curves_(bounds.segments), size_(curves_.drawing().coordinate_size()),
        least_((std::max)(LEAST * size_, 4 * bounds.moved)), runs_(bounds, LEAST * size_), axis_(axis),
        next_in_ring_(2 * curves_.number_of_segments(), NONE) {
    for (const Bounding_ring& ring : bounds.rings)
      for (std::size_t i = 0; i < ring.way.size(); ++i)
        next_in_ring_[ring.way[i].side()] = ring.way[(i + 1) % ring.way.size()].side();
    link();
  }

  [[nodiscard]] std::vector<Medial_axis_2::Cell> cells() {
    std::vector<bool> is_done(2 * axis_.edges.size());
    for (std::size_t side = 0; side < is_done.size(); ++side) {
      if (is_done[side]) continue;
      std::vector<Line> cycle;
      for (std::size_t at = side; !is_done[at]; at = next_[at]) {
        is_done[at] = true;
        for (std::size_t k = 0; k + 1 < size(at); ++k) cycle.push_back(line(at, k));
        const Curve_place &last = foot(at, size(at) - 1), &next = foot(next_[at], 0);
        if (places_.distance(last, next) > least_) add_way(end_of(at), last, next, cycle);
      }
      add_runs(cycle);
    }
    const std::vector<std::size_t> degree = axis_.degrees();
    for (std::size_t i = 0; i < degree.size(); ++i)
      if (degree[i] == 0) add_disc(i);
    std::stable_sort(cells_.begin(), cells_.end(),
                     [](const Medial_axis_2::Cell& a, const Medial_axis_2::Cell& b) { return a.curve < b.curve; });
    return std::move(cells_);
  }

 private:
  // From one sample of a side to the next one, or, along an arc, about the center of a vertex.
  struct Line {
    std::size_t side, first;
    Curve_place from, to;
    std::uint32_t beyond;
    int direction;
    std::optional<std::size_t> vertex{};  // of an arc
  };

  [[nodiscard]] static bool is_left(std::size_t side) { return side % 2 != 0; }
  [[nodiscard]] const Medial_axis_2::Edge& edge(std::size_t side) const { return axis_.edges[side / 2]; }
  [[nodiscard]] std::size_t size(std::size_t side) const { return edge(side).samples.size(); }
  [[nodiscard]] std::size_t sample(std::size_t side, std::size_t k) const {
    return is_left(side) ? size(side) - 1 - k : k;
  }
  [[nodiscard]] std::size_t end_of(std::size_t side) const { return is_left(side) ? edge(side).from : edge(side).to; }
  [[nodiscard]] const Curve_place& foot(std::size_t side, std::size_t k, bool is_own = true) const {
    const Medial_axis_2::Sample& s = edge(side).samples[sample(side, k)];
    return is_left(side) == is_own ? s.left : s.right;
  }

  // Along a boundary with the region on its left, feet go counterclockwise about a vertex: a side is followed by that
  // whose first foot is its last one, or the next one after an arc that the disc touches.
  void link() {
    next_.resize(2 * axis_.edges.size());
    std::vector<std::vector<std::size_t>> leaving(axis_.vertices.size());
    for (std::size_t i = 0; i < axis_.edges.size(); ++i) {
      leaving[axis_.edges[i].from].push_back(2 * i);
      leaving[axis_.edges[i].to].push_back(2 * i + 1);
    }
    for (std::size_t side = 0; side < next_.size(); ++side) {
      const std::size_t vertex = end_of(side);
      const Curve_place& last = foot(side, size(side) - 1);
      double least = HUGE_VAL;
      for (const std::size_t other : leaving[vertex]) {
        const double turn = turn_between(vertex, last, foot(other, 0));
        if (turn < least) least = turn, next_[side] = other;
      }
    }
  }
  [[nodiscard]] double turn_between(std::size_t vertex, const Curve_place& from, const Curve_place& to) const {
    if (from.curve == to.curve && places_.direction(from, to) == 0) return -1;
    const Xy<double> p = places_.point(from) - axis_.vertices[vertex].center,
                     q = places_.point(to) - axis_.vertices[vertex].center;
    const double turn = std::atan2(cross(p, q), dot(p, q));
    constexpr double FULL = 6.283185307179586, NOTHING = 1e-6;  // radians
    return turn < -NOTHING ? turn + FULL : turn;
  }

  [[nodiscard]] Line line(std::size_t side, std::size_t k) const {
    const auto run = [&](bool is_own) {
      const Curve_place &p = foot(side, k, is_own), &q = foot(side, k + 1, is_own);
      const std::optional<Foot_run> found = runs_.between(p, q);
      if (found && !found->is_point)
        return std::pair(curves_.place_at(found->segment, found->from), curves_.place_at(found->segment, found->to));
      return std::pair(p, p.curve == q.curve ? q : p);
    };
    const auto [from, to] = run(true);
    return {side, k, from, to, run(false).first.curve, places_.direction(from, to)};
  }

  // Adds the arcs that a vertex touches from one foot to the next one.
  void add_way(std::size_t vertex, const Curve_place& last, const Curve_place& next, std::vector<Line>& cycle) const {
    for (const Foot_run& run : arcs_between(last, next, axis_.vertices[vertex]))
      cycle.push_back({0, 0, curves_.place_at(run.segment, run.from), curves_.place_at(run.segment, run.to), 0,
                       run.is_growing() ? 1 : -1, vertex});
  }
  // The arcs of the boundary that the disc of a vertex touches between two places.
  // \param to the same place as `from` where a ring is an arc that the disc touches
  // \return the way along the boundary, empty where the disc does not touch it from one place to the other one
  [[nodiscard]] std::vector<Foot_run> arcs_between(const Curve_place& from, const Curve_place& to,
                                                   const Medial_axis_2::Vertex& v) const {
    const std::vector<Foot_runs::Name> ends = runs_.names(to);
    for (const Foot_runs::Name& start : runs_.names(from))
      for (const std::uint32_t is_reversed : {0U, 1U}) {
        std::vector<Foot_run> way = way_from(2 * start.segment + is_reversed, start.t, ends, v);
        if (!way.empty()) return way;
      }
    return {};
  }
  [[nodiscard]] double start_of(std::uint32_t side) const {
    const Spiral_piece_2 piece = curves_.piece(side / 2);
    return side % 2 != 0 ? piece.last.t : piece.first.t;
  }
  [[nodiscard]] std::vector<Foot_run> way_from(std::uint32_t side, double t, const std::vector<Foot_runs::Name>& ends,
                                               const Medial_axis_2::Vertex& v) const {
    std::vector<Foot_run> way;
    for (std::size_t sides = 0; sides <= next_in_ring_.size() && side != NONE; ++sides) {
      const Spiral_piece_2 piece = curves_.piece(side / 2);
      const bool is_reversed = side % 2 != 0;
      Foot_run run{side / 2, t, is_reversed ? piece.first.t : piece.last.t};
      bool is_there = false;
      for (const Foot_runs::Name& end : ends) {
        const bool is_ahead = is_reversed ? run.to <= end.t && end.t <= t : t <= end.t && end.t <= run.to;
        // a way that begins where it ends goes all round
        if (end.segment == run.segment && is_ahead && (end.t != t || !way.empty())) run.to = end.t, is_there = true;
      }
      if (run.from != run.to) {
        if (!is_touched(run, v)) return {};
        way.push_back(run);
      }
      if (is_there) return way;
      side = next_in_ring_[side];
      if (side != NONE) t = start_of(side);
    }
    return {};
  }
  // Whether a part of a segment, which is a spiral, is an arc of the vertex's circle, and the vertex to its left.
  [[nodiscard]] bool is_touched(const Foot_run& run, const Medial_axis_2::Vertex& v) const {
    const double middle = run.from + 0.5 * (run.to - run.from);
    for (const double t : {run.from, middle, run.to})
      if (std::fabs(euclidean_norm(curves_.sample(run.segment, t).point - v.center) - v.radius) > ROOM * size_)
        return false;
    const Spiral_sample m = curves_.sample(run.segment, middle);
    return (cross(m.tangent, v.center - m.point) > 0) == run.is_growing();
  }

  // The cells of a disc that is all of a region, which has no edge.
  void add_disc(std::size_t vertex) {
    const std::vector<Curve_place>& touches = axis_.vertices[vertex].touches;
    std::vector<Line> ring;
    if (!touches.empty()) add_way(vertex, touches.front(), touches.front(), ring);
    add_runs(ring);
  }

  // Whether a curve comes to one point at two places, and is elsewhere between them.
  [[nodiscard]] bool are_crossing(const Curve_place& p, const Curve_place& q) const {
    if (places_.direction(p, q) == 0 || places_.distance(p, q) > least_) return false;
    const Curve_place end = places_.on_piece(q, p.bezier);
    return end.bezier != p.bezier || places_.distance(p, {p.curve, p.bezier, 0.5 * (p.t + end.t)}) > least_;
  }

  // Cuts a cycle where feet come to another curve, or turn back at the end of one.
  void add_runs(const std::vector<Line>& cycle) {
    std::vector<int> directions(cycle.size());  // of the run that a line is in: feet that stay are in the one before
    int last = 0;
    for (int round = 0; round < 2; ++round)
      for (std::size_t i = 0; i < cycle.size(); ++i) {
        if (cycle[i].from.curve != cycle[(i + cycle.size() - 1) % cycle.size()].from.curve) last = 0;
        if (cycle[i].direction != 0) last = cycle[i].direction;
        directions[i] = last;
      }
    const auto is_cut = [&](std::size_t i) {
      const std::size_t k = (i + cycle.size() - 1) % cycle.size();
      return cycle[i].from.curve != cycle[k].from.curve || directions[i] * directions[k] < 0 ||
             are_crossing(cycle[k].to, cycle[i].from);
    };
    std::size_t start = 0;
    while (start < cycle.size() && !is_cut(start)) ++start;
    const bool is_uncut = start == cycle.size();
    for (std::size_t n = 0; n < cycle.size(); ++n) {
      const std::size_t i = (n + (is_uncut ? 0 : start)) % cycle.size();
      const Line& l = cycle[i];
      if (n == 0 || (!is_uncut && is_cut(i))) {
        cells_.emplace_back();
        cells_.back().curve = l.from.curve;
        cells_.back().first = l.from;
        cells_.back().is_whole = is_uncut;
      }
      add_line(l, directions[i], cells_.back());
    }
  }
  void add_line(const Line& l, int direction, Medial_axis_2::Cell& cell) const {
    if (direction != 0) cell.is_reversed = direction < 0;
    cell.last = l.to;
    // feet that move go one way alone, so that they are back only after all of a closed curve
    if (l.direction != 0 && places_.direction(cell.first, cell.last) == 0) cell.is_whole = true;
    if (l.vertex) {
      cell.vertex = *l.vertex;
      return;
    }
    const std::size_t number = l.side / 2, from = sample(l.side, l.first), to = sample(l.side, l.first + 1);
    if (!cell.rim.empty() && cell.rim.back().edge == number && cell.rim.back().last == from &&
        cell.rim.back().beyond == l.beyond && (cell.rim.back().first < from) == (from < to))
      cell.rim.back().last = to;
    else cell.rim.push_back({number, from, to, l.beyond});
  }

  static constexpr std::uint32_t NONE = Bounding_parts::NO_LABEL;
  static constexpr double ROOM = 0x1p-36;   // of the size; all points of the boundary are as right
  static constexpr double LEAST = 0x1p-42;  // of the size: lengths below are nothing

  Places places_;
  const Segment_hierarchy& curves_;
  double size_, least_;  // the latter: places no farther apart are one
  Foot_runs runs_;
  const Medial_axis_2& axis_;
  std::vector<std::size_t> next_;            // side 2i is the right one of edge i, 2i + 1 the left one
  std::vector<std::uint32_t> next_in_ring_;  // sides of segments
  std::vector<Medial_axis_2::Cell> cells_;
};

}  // namespace

}  // namespace CGAL::Bounding_arcs::internal

namespace CGAL::Bounding_arcs {

std::vector<Medial_axis_2::Cell> voronoi_cells(const Bounding_arc_tree_2& tree, const Medial_axis_2& axis) {
  const auto bounds = internal::bounds_of(axis, tree.in_unit());
  return internal::Cell_walk(*bounds, internal::in(tree.unit(), axis)).cells();
}

std::vector<Xy<double>> Medial_axis_2::Cell::polygon(const Bounding_arc_tree_2& tree, const Medial_axis_2& axis,
                                                     int per_piece) const {
  const Cell& cell = *this;
  const internal::Places places(tree.in_unit());
  const internal::Unit& unit = tree.unit();
  const std::uint32_t n = places.count(cell.curve);
  std::vector<Xy<double>> result{unit.out(places.point(cell.first))};
  const double end = cell.is_reversed ? 0 : 1;
  const auto is_behind = [&](double t, double u) { return cell.is_reversed ? t < u : t > u; };
  Curve_place at = cell.first;
  bool is_started = false;  // all of a closed curve ends where it began
  for (std::uint32_t pieces = 0; pieces <= n; ++pieces) {
    const Curve_place last = places.on_piece(cell.last, at.bezier);
    const bool is_last =
        last.bezier == at.bezier && !is_behind(at.t, last.t) && !(cell.is_whole && !is_started && at.t == last.t);
    const double stop = is_last ? last.t : end;
    for (int k = 1; k <= per_piece && at.t != stop; ++k)
      result.push_back(unit.out(places.point({at.curve, at.bezier, at.t + (stop - at.t) * k / per_piece})));
    if (is_last) break;
    is_started = true;
    at.bezier = cell.is_reversed ? (at.bezier + n - 1) % n : (at.bezier + 1) % n;
    at.t = 1 - end;
  }
  if (cell.rim.empty() && !cell.is_whole) result.push_back(axis.vertices[cell.vertex].center);
  for (auto part = cell.rim.rbegin(); part != cell.rim.rend(); ++part) {
    const auto step = part->first < part->last ? -1 : 1;
    const auto& samples = axis.edges[part->edge].samples;
    for (auto i = static_cast<std::ptrdiff_t>(part->last);; i += step) {
      result.push_back(samples[static_cast<std::size_t>(i)].center);
      if (i == static_cast<std::ptrdiff_t>(part->first)) break;
    }
  }
  return result;
}

}  // namespace CGAL::Bounding_arcs
