// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of Bounding_parts.h.

#include <CGAL/Bounding_arcs_2/arc/arc_pair.h>
#include "../query/Closest_search.h"
#include "../tree/Segment_hierarchy.h"
#include "Axis_boundary.h"
#include "Bounding_parts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <utility>

namespace CGAL::Bounding_arcs::internal {

namespace {

class Contact_finder {
 public:
  Contact_finder(const Bounding_parts& parts, double close) : parts_(parts), curves_(parts.segments), close_(close) {}

  [[nodiscard]] std::vector<Wall_contact> contacts() {
    const auto count = curves_.number_of_segments();
    const Box_tree boxes(count, [&](std::size_t i) {
      const auto s = static_cast<std::uint32_t>(i);
      return Segment_hierarchy::box(curves_.piece(s), curves_.error(s) + 0.5 * close_);
    });
    for_each_overlap(boxes, [&](std::uint32_t i, std::uint32_t j) {
      add(i, j);
      return true;
    });
    return std::move(contacts_);
  }

 private:
  struct Stretch {
    double from, to;
  };

  [[nodiscard]] std::uint32_t joint(std::uint32_t s, bool is_last) const { return parts_.joints[2 * s + is_last]; }
  [[nodiscard]] bool has_joint(std::uint32_t s, std::uint32_t j) const {
    return joint(s, false) == j || joint(s, true) == j;
  }
  [[nodiscard]] Spiral_sample end(std::uint32_t s, bool is_last) const {
    return is_last ? curves_.piece(s).last : curves_.piece(s).first;
  }
  [[nodiscard]] Xy<double> point(std::uint32_t s, double t) const {
    return curves_.evaluator(curves_.bezier_of(s))(t).point;
  }
  static constexpr double NEARLY = 1.5;  // what is farther by less may be taken for close
  /// The parameter of the point of a segment that is nearest to q, if it is close.
  [[nodiscard]] std::optional<double> near(std::uint32_t s, const Xy<double>& q) const {
    Closest_search search(curves_, q, 2 * close_);
    search.look_at(s);
    const auto found = search.result();
    if (!found || !(euclidean_norm(found->point - q) <= NEARLY * close_)) return std::nullopt;
    return found->place.t;
  }

  void add(std::uint32_t i, std::uint32_t j) {
    const bool is_joined = has_joint(i, joint(j, false)) || has_joint(i, joint(j, true));
    if (is_joined ? !may_run_together(i, j) : are_far(curves_.region(i), curves_.region(j))) return;
    std::vector<Stretch> stretches;
    add_stretches(curves_.piece(i), j, {curves_.piece(j)}, stretches);
    for (const Stretch& stretch : stretches) add(i, j, stretch);
  }
  // Whether an end of one that the other one has not is close to that.
  [[nodiscard]] bool may_run_together(std::uint32_t i, std::uint32_t j) const {
    const auto is_beside = [&](std::uint32_t s, std::uint32_t other) {
      return std::any_of(std::begin(BOTH), std::end(BOTH), [&](bool is_last) {
        return !has_joint(other, joint(s, is_last)) && near(other, end(s, is_last).point);
      });
    };
    const bool are_both = has_joint(j, joint(i, false)) && has_joint(j, joint(i, true));
    return are_both || is_beside(i, j) || is_beside(j, i);
  }
  static constexpr bool BOTH[] = {false, true};

  // The stretches of a piece along which segment j is close, in order.
  // \param others pieces of that which may be
  void add_stretches(const Spiral_piece_2& piece, std::uint32_t j, std::vector<Spiral_piece_2> others,
                     std::vector<Stretch>& stretches) const {
    constexpr double SHORT = 0.25;  // of what is close
    const double length = length_of(piece);
    const Fat_arc_2 region = curves_.region(piece);
    std::vector<Spiral_piece_2> left;
    while (!others.empty()) {
      const Spiral_piece_2 other = others.back();
      others.pop_back();
      if (are_far(region, curves_.region(other))) continue;
      const bool is_long = length_of(other) > (std::max)(2 * length, SHORT * close_);
      const auto parts = is_long ? halves(curves_, other) : std::nullopt;
      if (parts) others.push_back(parts->first), others.push_back(parts->second);
      else left.push_back(other);
    }
    if (left.empty()) return;
    const auto take = [&] {
      if (!stretches.empty() && stretches.back().to == piece.first.t) stretches.back().to = piece.last.t;
      else stretches.push_back({piece.first.t, piece.last.t});
    };
    if (is_close(piece, j)) return take();
    const auto parts = halves(curves_, piece);
    if (!parts || length <= SHORT * close_) return;
    add_stretches(parts->first, j, left, stretches);
    add_stretches(parts->second, j, left, stretches);
  }
  [[nodiscard]] bool are_far(const Fat_arc_2& a, const Fat_arc_2& b) const {
    return are_boxes_apart(a.arc, b.arc, close_ + a.radius + b.radius) || least_distance(a, b) > close_;
  }
  [[nodiscard]] static double length_of(const Spiral_piece_2& p) {
    return euclidean_norm(p.last.point - p.first.point);
  }
  // The distance hardly bends along a spiral piece: it is asked for at a few places.
  [[nodiscard]] bool is_close(const Spiral_piece_2& piece, std::uint32_t j) const {
    constexpr int PLACES = 8;
    for (int k = 0; k <= PLACES; ++k)
      if (!near(j, point(piece.segment, piece.first.t + (piece.last.t - piece.first.t) * k / PLACES))) return false;
    return true;
  }

  void add(std::uint32_t i, std::uint32_t j, const Stretch& stretch) {
    const Xy<double> from = point(i, stretch.from), to = point(i, stretch.to);
    const auto t0 = near(j, from), t1 = near(j, to);
    constexpr double SHORT = 4;
    if (!(euclidean_norm(to - from) > SHORT * close_) || !t0 || !t1) {
      return add_middle(i, j, stretch);
    }
    const bool is_from_end = is_at_end(i, stretch.from) || is_at_end(j, *t0),
               is_to_end = is_at_end(i, stretch.to) || is_at_end(j, *t1);
    // where they part so fast that a corner would be seen if they were one up to there, they touch
    const bool is_from_open = !is_from_end && parts_fast(i, stretch.from, j, *t0),
               is_to_open = !is_to_end && parts_fast(i, stretch.to, j, *t1);
    if (is_from_open && is_to_open) return add_middle(i, j, stretch);
    const bool is_from_joint = is_at_shared_joint(i, stretch.from, j, *t0),
               is_to_joint = is_at_shared_joint(i, stretch.to, j, *t1);
    if (is_from_open || is_to_open) {
      if (is_from_open && !is_to_joint) contacts_.push_back({i, j, stretch.to, *t1});
      if (is_to_open && !is_from_joint) contacts_.push_back({i, j, stretch.from, *t0});
      return;
    }
    // a corner, unless one ends there
    if (is_from_joint != is_to_joint && !(is_from_joint ? is_to_end : is_from_end)) return;
    contacts_.push_back({i, j, stretch.from, *t0});
    contacts_.push_back({i, j, stretch.to, *t1});
  }
  [[nodiscard]] bool parts_fast(std::uint32_t i, double s, std::uint32_t j, double t) const {
    const Xy<double> a = curves_.sample(i, s).tangent, b = curves_.sample(j, t).tangent;
    return std::fabs(cross(a, b)) > Boundary_element::LEAST_TURN / 4;
  }
  void add_middle(std::uint32_t i, std::uint32_t j, const Stretch& stretch) {
    const double s = 0.5 * (stretch.from + stretch.to);
    const auto t = near(j, point(i, s));
    if (t && !is_at_shared_joint(i, s, j, *t)) contacts_.push_back({i, j, s, *t});
  }
  [[nodiscard]] bool is_at(std::uint32_t s, double t, bool is_last) const {
    return euclidean_norm(point(s, t) - end(s, is_last).point) <= 2 * close_;
  }
  [[nodiscard]] bool is_at_end(std::uint32_t s, double t) const { return is_at(s, t, false) || is_at(s, t, true); }
  [[nodiscard]] bool is_at_shared_joint(std::uint32_t i, double s, std::uint32_t j, double t) const {
    for (const bool p : BOTH)
      for (const bool q : BOTH)
        if (joint(i, p) == joint(j, q) && is_at(i, s, p) && is_at(j, t, q)) return true;
    return false;
  }

  const Bounding_parts& parts_;
  const Segment_hierarchy& curves_;
  double close_;
  std::vector<Wall_contact> contacts_;
};

}  // namespace

std::vector<Wall_contact> wall_contacts(const Bounding_parts& parts, double close) {
  return Contact_finder(parts, close).contacts();
}

}  // namespace CGAL::Bounding_arcs::internal
