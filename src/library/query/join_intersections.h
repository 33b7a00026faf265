// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What pairs of Bezier pieces have in common, as what whole curves have: a point at a joint of pieces is found by both
// of them and counts once, and parts of overlaps are joined where they go on.

#ifndef BOUNDING_ARCS_LIBRARY_QUERY_JOIN_INTERSECTIONS_H
#define BOUNDING_ARCS_LIBRARY_QUERY_JOIN_INTERSECTIONS_H

#include <CGAL/Bounding_arcs_2/query/Intersections_2.h>
#include "../tree/Segment_hierarchy.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

/// A common point of two Bezier pieces.
struct Numbered_point {
  std::pair<std::uint32_t, std::uint32_t> beziers;  // numbered through the drawing
  Piece_intersections::Intersection common;
};
/// A part along which two Bezier pieces run together.
struct Numbered_overlap {
  std::pair<std::uint32_t, std::uint32_t> beziers;
  Piece_intersections::Overlap common;
};
/// All that drawings have in common.
struct Numbered_intersections {
  std::vector<Numbered_point> points;
  std::vector<Numbered_overlap> overlaps;
};

/// A parameter range of a Bezier piece; the end of a piece that another one follows is that one's start.
struct Joint_place {
  std::uint32_t bezier;
  Bracket t;

  [[nodiscard]] bool is_start() const { return t.lower == 0 && t.upper == 0; }
  [[nodiscard]] bool touches(const Joint_place& other) const { return bezier == other.bezier && t.touches(other.t); }
};
/// Compares places by their order on the curves.
[[nodiscard]] inline bool operator<(const Joint_place& p, const Joint_place& q) {
  return std::tie(p.bezier, p.t.lower, p.t.upper) < std::tie(q.bezier, q.t.lower, q.t.upper);
}

/// Which Bezier piece follows which, told by the curves: tables would take the time of all pieces where few meet.
class Curve_joints {
 public:
  explicit Curve_joints(const Segment_hierarchy& curves) : curves_(&curves) {}
  [[nodiscard]] Joint_place place(std::uint32_t bezier, const Bracket& t) const {
    if (!(t.lower == 1 && t.upper == 1)) return {bezier, t};
    const std::size_t curve = curves_->curve_of_bezier(bezier);
    const auto& of_curve = curves_->drawing().curves()[curve];
    const std::uint32_t first = curves_->number_of_bezier(curve, 0);
    if (bezier - first + 1 < of_curve.beziers.size()) return {bezier + 1, {0, 0}};
    return of_curve.is_closed ? Joint_place{first, {0, 0}} : Joint_place{bezier, t};
  }
  [[nodiscard]] bool is_point(std::uint32_t bezier) const { return curves_->is_point(bezier); }
  /// Returns a place as the start of the next piece, where its own piece is a point.
  [[nodiscard]] Joint_place past_points(const Joint_place& p) const {
    Joint_place past = p;
    while (is_point(past.bezier)) {
      const Joint_place next = place(past.bezier, {1, 1});
      if (next.bezier == past.bezier || next.bezier == p.bezier) break;  // nothing follows, or all are points
      past = next;
    }
    return past;
  }
  [[nodiscard]] Curve_range curve_range(std::uint32_t bezier, const Bracket& t) const {
    const std::size_t curve = curves_->curve_of_bezier(bezier);
    return {static_cast<std::uint32_t>(curve), bezier - curves_->number_of_bezier(curve, 0), t};
  }
  [[nodiscard]] Curve_range curve_range(const Joint_place& p) const { return curve_range(p.bezier, p.t); }
  [[nodiscard]] Xy<double> point(const Joint_place& p) const {
    return curves_->evaluator(p.bezier)(p.t.lower + (p.t.upper - p.t.lower) / 2).point;
  }

 private:
  const Segment_hierarchy* curves_;
};

}  // namespace CGAL::Bounding_arcs

namespace CGAL::Bounding_arcs::internal {

/// Joins ranges of the same two pieces that touch, and appends them.
inline void add_clusters(std::vector<Numbered_point> open, std::vector<Numbered_point>& to) {
  const auto join = [](Bracket& p, const Bracket& q) {
    p = {(std::min)(p.lower, q.lower), (std::max)(p.upper, q.upper)};
  };
  std::sort(open.begin(), open.end(), [](const Numbered_point& p, const Numbered_point& q) {
    return std::tie(p.beziers, p.common.a.lower) < std::tie(q.beziers, q.common.a.lower);
  });
  const std::size_t first = to.size();
  for (Numbered_point& p : open) {
    for (std::size_t i = to.size(); i > first; --i) {  // what the new one joins may touch others
      const Numbered_point& known = to[i - 1];
      if (known.beziers != p.beziers || !known.common.a.touches(p.common.a) || !known.common.b.touches(p.common.b))
        continue;
      join(p.common.a, known.common.a);
      join(p.common.b, known.common.b);
      to.erase(to.begin() + static_cast<std::ptrdiff_t>(i) - 1);
      i = to.size() + 1;
    }
    to.push_back(p);
  }
}

/// A common part with both ways to name its ends.
class Joined_overlaps {
 public:
  Joined_overlaps(const std::vector<Numbered_overlap>& parts, const Curve_joints& a, const Curve_joints& b)
      : parts_(parts), a_(a), b_(b) {
    for (std::size_t i = 0; i < parts.size(); ++i) starts_.emplace(from(i).first.bezier, i);
  }
  /// Whether a point is an end of a part.
  [[nodiscard]] bool has_end(const Joint_place& p, const Joint_place& q) const {
    const auto range = starts_.equal_range(p.bezier);
    for (auto i = range.first; i != range.second; ++i)
      if (from(i->second).first.touches(p) && from(i->second).second.touches(q)) return true;
    for (std::size_t i = 0; i < parts_.size(); ++i)
      if (to(i).first.touches(p) && to(i).second.touches(q)) return true;
    return false;
  }
  [[nodiscard]] std::vector<Overlap_2> joined() const {
    std::vector<std::size_t> next(parts_.size(), parts_.size());
    std::vector<char> has_before(parts_.size(), 0), is_done(parts_.size(), 0);
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const auto end = to(i);
      const auto range = starts_.equal_range(end.first.bezier);
      for (auto j = range.first; j != range.second; ++j) {
        const auto start = from(j->second);
        if (has_before[j->second] != 0 || j->second == i || runs_forward(i) != runs_forward(j->second)) continue;
        if (!start.first.touches(end.first) || !start.second.touches(end.second)) continue;
        next[i] = j->second;
        has_before[j->second] = 1;
        break;
      }
    }
    std::vector<std::size_t> order(parts_.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return from(i) < from(j); });
    std::vector<Overlap_2> result;
    for (const bool is_loop : {false, true})  // what has a first part, then rings
      for (const std::size_t first : order) {
        if (is_done[first] != 0 || (!is_loop && has_before[first] != 0)) continue;
        std::size_t last = first;
        is_done[first] = 1;
        while (next[last] < parts_.size() && is_done[next[last]] == 0) {
          last = next[last];
          is_done[last] = 1;
        }
        result.push_back(overlap(first, last));
      }
    return result;
  }

 private:
  using Places = std::pair<Joint_place, Joint_place>;
  [[nodiscard]] Places from(std::size_t i) const {
    const Numbered_overlap& o = parts_[i];
    return {a_.place(o.beziers.first, o.common.a_from), b_.place(o.beziers.second, o.common.b_from)};
  }
  [[nodiscard]] Places to(std::size_t i) const {
    const Numbered_overlap& o = parts_[i];
    return {a_.place(o.beziers.first, o.common.a_to), b_.place(o.beziers.second, o.common.b_to)};
  }
  [[nodiscard]] Overlap_2 overlap(std::size_t first, std::size_t last) const {
    const Numbered_overlap &f = parts_[first], &l = parts_[last];
    return {a_.curve_range(f.beziers.first, f.common.a_from), a_.curve_range(l.beziers.first, l.common.a_to),
            b_.curve_range(f.beziers.second, f.common.b_from), b_.curve_range(l.beziers.second, l.common.b_to),
            !runs_forward(first)};
  }
  [[nodiscard]] bool runs_forward(std::size_t i) const {
    return parts_[i].common.b_from.lower <= parts_[i].common.b_to.lower;
  }

  const std::vector<Numbered_overlap>& parts_;
  const Curve_joints &a_, &b_;
  std::multimap<std::uint32_t, std::size_t> starts_;  // by Bezier piece
};

/// \param is_self of one drawing with itself: neighbours' joints are no points, and places are in order. Pieces that
///   are points do not count: what they have in common with others, the pieces beside them have, too
[[nodiscard]] inline Intersections_2<> joined(const Numbered_intersections& found, const Curve_joints& a,
                                              const Curve_joints& b, bool is_self) {
  struct Point {
    Joint_place a, b;
    Intersection_kind kind;
  };
  const auto is_of_point = [&](const auto& common) {
    return is_self && (a.is_point(common.beziers.first) || b.is_point(common.beziers.second));
  };
  std::vector<Numbered_overlap> parts;
  std::remove_copy_if(found.overlaps.begin(), found.overlaps.end(), std::back_inserter(parts), is_of_point);
  const Joined_overlaps overlaps(parts, a, b);
  // ends of pieces that ranges of undecided points reach: a common end there may belong to a part that is shared
  std::set<std::pair<Joint_place, Joint_place>> undecided;
  for (const Numbered_point& p : found.points) {
    if (p.common.kind != Intersection_kind::UNDECIDED) continue;
    for (const double t : {p.common.a.lower, p.common.a.upper})
      for (const double s : {p.common.b.lower, p.common.b.upper})
        undecided.emplace(a.place(p.beziers.first, {t, t}), b.place(p.beziers.second, {s, s}));
  }
  const auto is_undecided = [&](const Joint_place& p, const Joint_place& q) { return undecided.count({p, q}) != 0; };
  std::vector<Point> points;
  for (const Numbered_point& p : found.points) {
    if (is_of_point(p)) continue;
    Point q{a.place(p.beziers.first, p.common.a), b.place(p.beziers.second, p.common.b), p.common.kind};
    if (q.kind != Intersection_kind::UNDECIDED && (is_undecided(q.a, q.b) || (is_self && is_undecided(q.b, q.a))))
      continue;
    if (is_self && q.b < q.a) std::swap(q.a, q.b);
    if (q.kind != Intersection_kind::UNDECIDED && overlaps.has_end(q.a, q.b)) continue;  // more may be left open there
    if (is_self) {
      q.a = a.past_points(q.a), q.b = b.past_points(q.b);
      if (q.b < q.a) std::swap(q.a, q.b);
      if (q.a.is_start() && q.b.is_start() && q.a.bezier == q.b.bezier) continue;
    }
    points.push_back(q);
  }
  std::sort(points.begin(), points.end(),
            [](const Point& p, const Point& q) { return std::tie(p.a, p.b) < std::tie(q.a, q.b); });
  Intersections_2<> result;
  std::vector<Point> kept;
  for (const Point& p : points) {
    const bool is_at_joint = p.a.is_start() || p.b.is_start();
    bool is_known = false;
    for (std::size_t i = kept.size(); is_at_joint && i > 0 && kept[i - 1].a.touches(p.a); --i) {
      Point& q = kept[i - 1];
      if (!q.b.touches(p.b) || (q.kind == Intersection_kind::UNDECIDED) != (p.kind == Intersection_kind::UNDECIDED))
        continue;
      is_known = true;
      if (p.kind == Intersection_kind::TANGENTIAL) q.kind = p.kind;  // where a corner touches with one of its sides
    }
    if (!is_known) kept.push_back(p);
  }
  for (const Point& p : kept) result.points.push_back({a.point(p.a), p.kind, a.curve_range(p.a), b.curve_range(p.b)});
  result.overlaps = overlaps.joined();
  return result;
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
