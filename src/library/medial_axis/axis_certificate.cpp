// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of medial_axis/axis_certificate.h.

#include <CGAL/Bounding_arcs_2/medial_axis/axis_certificate.h>
#include "../tree/Segment_hierarchy.h"
#include "Axis_editor.h"
#include "Line_prover.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

namespace {

// The proof of an axis: bounds of all lines, the worst of which are parted until they are near what is seen; and
// whether feet tile the boundary.

class Axis_prover {
 public:
  /// Curves and axis have a size near 1.
  Axis_prover(const Bounding_parts& bounds, const Medial_axis_2& axis)
      : bounds_(bounds), curves_(bounds.segments), axis_(axis), size_(curves_.drawing().coordinate_size()),
        least_((std::max)(LEAST * size_, 4 * bounds.moved)), runs_(bounds, LEAST * size_, least_),
        prover_(curves_, size_), ranges_(2 * curves_.number_of_segments()) {}

  [[nodiscard]] Medial_axis_2::Certificate prove() {
    Medial_axis_2::Certificate result;
    result.is_euler = axis_.vertices.size() + axis_.holes == axis_.edges.size() + axis_.regions;
    for (const Medial_axis_2::Edge& e : axis_.edges) result.edges.push_back(prove(e));
    result.is_tiled = is_tiled();
    bool is_bounded = result.is_tiled && result.is_euler;
    for (const Medial_axis_2::Certificate::Edge& e : result.edges) {
      result.bound = (std::max)(result.bound, e.bound);
      is_bounded = is_bounded && e.bound < Line_prover::UNBOUNDED;
    }
    for (Medial_axis_2::Certificate::Edge& e : result.edges)
      if (!is_bounded && e.status == Status::PROVEN) e.status = Status::ESTIMATED, e.reason = Reason::ELSEWHERE;
    return result;
  }

 private:
  using Status = Medial_axis_2::Certificate::Status;
  using Reason = Medial_axis_2::Certificate::Reason;
  static constexpr double NEAR = 1.5;          // times what is seen: goals
  static constexpr double SHORT = 1.0 / 16;    // of eps: longer lines are never left out
  static constexpr double LEAST = 0x1p-42;     // of the size: shorter parts of the boundary are left out
  static constexpr int MOST_PARTED = 1 << 18;  // lines within one that is given: a bound that needs more is not got

  [[nodiscard]] Medial_axis_2::Certificate::Edge prove(const Medial_axis_2::Edge& e) {
    Medial_axis_2::Certificate::Edge result;
    if (e.samples.size() < 2) return {Status::ESTIMATED, Reason::FEET, Line_prover::UNBOUNDED};
    lines_.clear();
    double moved = 0;  // by samples that are left out
    Medial_axis_2::Sample s = sample(e, 0);
    for (std::size_t i = 1; i < e.samples.size(); ++i) {
      const Medial_axis_2::Sample t = sample(e, i);
      const auto left = runs_.between(s.left, t.left), right = runs_.between(s.right, t.right);
      if (!left || !right) return {Status::ESTIMATED, Reason::FEET, Line_prover::UNBOUNDED};
      const Axis_line line{{s.center, s.radius}, {t.center, t.radius}, *left, *right};
      const double length = euclidean_norm(t.center - s.center) + std::fabs(t.radius - s.radius);
      // two discs of the same feet, back to front within rounding
      if (left->is_point && right->is_point && i + 1 < e.samples.size() && length < SHORT * axis_.eps &&
          !prover_.prove(line).is_in_order) {
        moved += length;  // from a place of the line beyond to as far along the one that is given
        continue;
      }
      add_range(*left, true), add_range(*right, false);
      lines_.push_back({line, {}});
      s = t;
    }
    const std::vector<Xy<double>> from = touched_by(axis_.vertices[e.from]), to = touched_by(axis_.vertices[e.to]);
    lines_.front().line.others[0] = &from, lines_.back().line.others[1] = &to;
    for (std::size_t i = 0; i + 1 < lines_.size(); ++i) {
      lines_[i].line.beyond[1] = lines_[i + 1].line.last;
      lines_[i + 1].line.beyond[0] = lines_[i].line.first;
    }
    double seen = 0;
    for (Proved_line& l : lines_) l.result = prover_.prove(l.line), seen = (std::max)(seen, l.result.seen);
    constexpr double FLOOR = 0x1p-41;  // of the size
    eps_ = axis_.eps - moved;
    const double goal = (std::min)(eps_, NEAR * seen + FLOOR * size_);
    bool is_in_order = true;
    for (Proved_line& l : lines_) {
      left_to_part_ = MOST_PARTED;
      l.result = parted(l.line, l.line, goal, 0, l.result);
      result.bound = (std::max)(result.bound, l.result.bound);
      is_in_order = is_in_order && l.result.is_in_order;
    }
    result.bound += moved;
    if (!is_in_order) result = {Status::ESTIMATED, Reason::CELL, Line_prover::UNBOUNDED};
    else if (!(result.bound <= axis_.eps)) result.reason = Reason::BAND;
    else result.status = Status::PROVEN;
    return result;
  }

  // A sample with feet on normals, and in a vertex with those that its other edges have.
  [[nodiscard]] Medial_axis_2::Sample sample(const Medial_axis_2::Edge& e, std::size_t i) const {
    Medial_axis_2::Sample s = e.samples[i];
    for (Curve_place* foot : {&s.left, &s.right}) {
      if (i == 0) *foot = shared(*foot, axis_.vertices[e.from]);
      if (i + 1 == e.samples.size()) *foot = shared(*foot, axis_.vertices[e.to]);
      *foot = runs_.on_normal(*foot, s.center);
    }
    return s;
  }
  // Where a curve is nearly as curved as the disc, edges may have feet apart that are one.
  [[nodiscard]] Curve_place shared(const Curve_place& foot, const Medial_axis_2::Vertex& v) const {
    constexpr double SAME = 0x1p-28;  // of the size; what is proven of feet is of those that are taken
    const Xy<double> at = point(foot);
    Curve_place nearest = foot;
    double least = SAME * size_;
    for (const Curve_place& p : v.touches) {
      if (p.curve != foot.curve || p.bezier != foot.bezier) continue;
      const double away = euclidean_norm(point(p) - at);
      if (away < least) least = away, nearest = p;
    }
    return nearest;
  }

  struct Proved_line {
    Axis_line line;
    Line_prover::Result result;
  };
  // Discs between part the line: the axis is near lines between these, and they are near the given one.
  [[nodiscard]] Line_prover::Result parted(const Axis_line& line, const Axis_line& whole, double goal, int halvings,
                                           const Line_prover::Result& own) {
    constexpr int MOST_HALVINGS = 24, ENOUGH = 4;
    constexpr double LITTLE = 0.75;
    // halves of a line that is too long have ends that are off by more than the goal
    const double most = own.off < eps_ ? eps_ : Line_prover::UNBOUNDED,
                 wanted = own.off > goal ? (std::min)(NEAR * own.off, most) : goal;
    if ((own.is_in_order && own.bound <= wanted) || halvings == MOST_HALVINGS || left_to_part_ == 0) return own;
    --left_to_part_;
    const auto middle = prover_.middle(line);
    if (!middle) return own;
    Axis_line halves[2] = {line, line};
    for (const int i : {0, 1}) {
      (i == 0 ? halves[i].last : halves[i].first) = middle->disc;
      halves[i].share = 0.5 * line.share;
      halves[i].left = middle->left[i], halves[i].right = middle->right[i];
    }
    Line_prover::Result all{0, own.seen, own.off, true};
    const double limit = own.is_in_order ? own.bound : Line_prover::UNBOUNDED;
    for (const Axis_line& half : halves) {
      if (!all.is_in_order || !(all.bound < limit)) return own;  // no better
      Line_prover::Result result = prover_.prove(half, whole);
      // rounding that makes a bound does not become less
      const bool is_rounding =
          limit <= eps_ && halvings >= ENOUGH && result.is_in_order && !(result.bound < LITTLE * limit);
      if (!is_rounding) result = parted(half, whole, goal, halvings + 1, result);
      all.bound = (std::max)(all.bound, result.bound);
      all.is_in_order = result.is_in_order;
    }
    return all.is_in_order && all.bound < limit ? all : own;
  }
  struct Range {
    double low, high;
  };
  void add_range(const Foot_run& run, bool is_left) {
    if (run.is_point) return;
    // left feet run against the boundary
    const bool is_right_of_curve = run.is_growing() == is_left;
    ranges_[2 * run.segment + is_right_of_curve].push_back(
        {(std::min)(run.from, run.to), (std::max)(run.from, run.to)});
  }

  [[nodiscard]] Xy<double> point(const Curve_place& p) const { return point_at(curves_, p); }
  // A touched arc is told by its ends alone, which may be two corners of a gap.
  [[nodiscard]] std::vector<Xy<double>> touched_by(const Medial_axis_2::Vertex& v) const {
    constexpr double NEAR = 0x1p-36;  // of the size; all points of the boundary are as right
    std::vector<Xy<double>> points;
    for (const Curve_place& p : v.touches) {
      points.push_back(point(p));
      for (const Xy<double>& q : runs_.points_beside(p))
        if (std::fabs(euclidean_norm(q - v.center) - v.radius) <= NEAR * size_) points.push_back(q);
    }
    return points;
  }
  // Round a vertex each line to a foot is where one cell ends and one begins.  Where its disc touches an arc the sector
  // between is a cell, too, and the arc is its part of the boundary.
  struct Feet {
    std::vector<Xy<double>> begins, ends;
  };
  void take_pairs(Feet& feet) const {
    const auto is_paired = [&](const Xy<double>& end) {
      const auto begin = std::find_if(feet.begins.begin(), feet.begins.end(),
                                      [&](const Xy<double>& p) { return euclidean_norm(p - end) <= least_; });
      if (begin == feet.begins.end()) return false;
      feet.begins.erase(begin);
      return true;
    };
    feet.ends.erase(std::remove_if(feet.ends.begin(), feet.ends.end(), is_paired), feet.ends.end());
  }
  [[nodiscard]] bool is_tiled() {
    feet_.assign(axis_.vertices.size(), {});
    for (const Medial_axis_2::Edge& e : axis_.edges) {
      const Medial_axis_2::Sample first = sample(e, 0), last = sample(e, e.samples.size() - 1);
      feet_[e.from].ends.push_back(point(first.left));
      feet_[e.from].begins.push_back(point(first.right));
      feet_[e.to].begins.push_back(point(last.left));
      feet_[e.to].ends.push_back(point(last.right));
    }
    for (std::size_t i = 0; i < feet_.size(); ++i) {
      const bool is_alone = feet_[i].ends.empty();
      take_pairs(feet_[i]);
      if (is_alone || !feet_[i].ends.empty()) on_arcs_.push_back(i);
    }
    if (!are_sides_tiled()) return false;
    return std::all_of(feet_.begin(), feet_.end(), [&](Feet& f) {
      take_pairs(f);
      return f.begins.empty() && f.ends.empty();
    });
  }
  // A side of a segment that has a region is tiled once, the other one not at all.
  [[nodiscard]] bool are_sides_tiled() {
    std::vector<char> has_region(ranges_.size(), 0);
    for (const Bounding_ring& ring : bounds_.rings)
      for (const Directed_segment& s : ring.way) has_region[s.side()] = 1;
    for (std::uint32_t side = 0; side < ranges_.size(); ++side) {
      const Spiral_piece_2 p = curves_.piece(side / 2);
      if (euclidean_norm(p.last.point - p.first.point) <= least_) continue;
      if (has_region[side] != 0 ? !is_side_tiled(p, side % 2 == 0, ranges_[side]) : !ranges_[side].empty())
        return false;
    }
    return true;
  }
  [[nodiscard]] bool is_side_tiled(const Spiral_piece_2& p, bool is_left, std::vector<Range>& ranges) {
    std::sort(ranges.begin(), ranges.end(), [](const Range& a, const Range& b) { return a.low < b.low; });
    const auto is_filled = [&](const Range& r) {
      return r.low == r.high || is_nothing(p.segment, r.low, r.high) ||
             (r.low < r.high && add_sector(p.segment, is_left, r));
    };
    double t = p.first.t;
    for (const Range& r : ranges) {
      if (!is_filled({t, r.low})) return false;
      t = r.high;
    }
    return is_filled({t, p.last.t});
  }
  [[nodiscard]] bool is_nothing(std::uint32_t segment, double t0, double t1) const {
    return euclidean_norm(curves_.sample(segment, t1).point - curves_.sample(segment, t0).point) <= least_;
  }
  // Whether a side of a part is an arc of a vertex's circle.
  [[nodiscard]] bool add_sector(std::uint32_t segment, bool is_left, const Range& r) {
    if (on_arcs_.empty()) return false;
    const Spiral_sample a = curves_.sample(segment, r.low), b = curves_.sample(segment, r.high),
                        m = curves_.sample(segment, 0.5 * (r.low + r.high));
    const Fat_arc_2 fat = curves_.region(Spiral_piece_2{segment, a, b});
    const double room = least_;
    if (fat.arc.bulge == 0 || !(fat.radius <= room)) return false;
    for (const std::size_t i : on_arcs_) {
      const Medial_axis_2::Vertex& v = axis_.vertices[i];
      const auto is_on = [&](const Spiral_sample& s) {
        return std::fabs(euclidean_norm(s.point - v.center) - v.radius) <= room;
      };
      const bool is_center_left = cross(m.tangent, v.center - m.point) > 0;
      if (is_center_left != is_left || !is_on(a) || !is_on(m) || !is_on(b)) continue;
      feet_[i].begins.push_back(is_left ? a.point : b.point);
      feet_[i].ends.push_back(is_left ? b.point : a.point);
      return true;
    }
    return false;
  }

  const Bounding_parts& bounds_;
  const Segment_hierarchy& curves_;
  const Medial_axis_2& axis_;
  double size_, least_, eps_ = 0;  // the latter of an edge, less what is moved
  Foot_runs runs_;
  Line_prover prover_;
  std::vector<std::vector<Range>> ranges_;  // by side
  std::vector<Feet> feet_;                  // of each vertex
  std::vector<std::size_t> on_arcs_;        // vertices that may touch one
  std::vector<Proved_line> lines_;
  int left_to_part_ = 0;
};

}  // namespace

}  // namespace CGAL::Bounding_arcs::internal

namespace CGAL::Bounding_arcs {

const char* Medial_axis_2::Certificate::name_of(Reason reason) {
  static constexpr const char* NAMES[] = {"NONE", "FEET", "CELL", "BAND", "ELSEWHERE"};  // as they are declared
  return NAMES[static_cast<std::size_t>(reason)];
}

bool Medial_axis_2::Certificate::is_proven() const {
  return is_tiled && is_euler && std::all_of(edges.begin(), edges.end(), [](const Medial_axis_2::Certificate::Edge& e) {
           return e.status == Medial_axis_2::Certificate::Status::PROVEN;
         });
}

Medial_axis_2::Certificate axis_certificate(const Bounding_arc_tree_2& curves, const Medial_axis_2& axis) {
  const internal::Unit& unit = curves.unit();
  const auto bounds = internal::bounds_of(axis, curves.in_unit());
  const Medial_axis_2 in_unit = internal::in(unit, axis);
  Medial_axis_2::Certificate result = internal::Axis_prover(*bounds, in_unit).prove();
  result.bound = unit.out(result.bound);
  for (Medial_axis_2::Certificate::Edge& e : result.edges) e.bound = unit.out(e.bound);
  return result;
}

}  // namespace CGAL::Bounding_arcs
