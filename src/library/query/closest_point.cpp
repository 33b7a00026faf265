// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of query/closest_point.h.

#include "query_units.h"

#include <CGAL/Bounding_arcs_2/query/Query_point.h>
#include <CGAL/Bounding_arcs_2/query/closest_point.h>
#include "../tree/Segment_hierarchy.h"
#include "Closest_search.h"
#include "Foot.h"

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

// The search for the k curves of a drawing that are nearest to a point: that for the nearest point, with an upper bound
// for each curve that was met and the k-th of them for others.

class Nearest_curves_search {
 public:
  /// \pre k > 0
  Nearest_curves_search(const Segment_hierarchy& curves, const Xy<double>& q, std::size_t k)
      : curves_(curves), q_(q), count_((std::min)(k, curves.drawing().curves().size())) {
    CGAL_precondition(k > 0);
    for_each_near(curves.boxes(), *this);
  }
  [[nodiscard]] std::vector<Closest_point<>> result() const {
    return {met_.begin(), met_.begin() + static_cast<std::ptrdiff_t>((std::min)(count_, met_.size()))};
  }

  // What boxes are asked for, see for_each_near.
  [[nodiscard]] const Xy<double>& point() const { return q_; }
  [[nodiscard]] double squared_reach() const { return most_square(most()); }
  [[nodiscard]] bool goes_on(double squared_distance) const { return squared_distance <= squared_reach(); }
  void look_at(std::uint32_t segment) {
    const std::uint32_t curve = curves_.place(segment).curve;
    const auto own =
        std::find_if(met_.begin(), met_.end(), [&](const Closest_point<>& p) { return p.place.curve == curve; });
    Closest_search search(curves_, q_, own == met_.end() ? most() : own->distance.upper);
    search.look_at(segment);
    const auto found = search.result();
    if (own == met_.end()) {
      if (found) met_.push_back(*found);
    } else {
      const double lower = (std::min)(own->distance.lower, search.lower());
      const Query_status before = own->status;
      if (found) *own = *found;
      own->distance.lower = lower;
      if (before != Query_status::COMPLETE || search.is_limited()) own->status = Query_status::LIMIT_REACHED;
    }
    if (found)
      std::sort(met_.begin(), met_.end(),
                [](const Closest_point<>& p, const Closest_point<>& r) { return p.distance.upper < r.distance.upper; });
  }

 private:
  [[nodiscard]] double most() const {
    return met_.size() < count_ ? std::numeric_limits<double>::infinity() : met_[count_ - 1].distance.upper;
  }

  const Segment_hierarchy& curves_;
  Xy<double> q_;
  std::size_t count_;
  std::vector<Closest_point<>> met_;  // the nearest point of each curve that was met, sorted
};

// The search for all points of a drawing where the distance from q is least among neighbours along the curve.
//
// Curves are cut into pieces with one nearest point each (Foot.h).  In an end of a piece the distance is least if it is
// for the piece that goes on from there, too, and then it is one point for both.  Where all of a piece is at one
// distance but for roundings, so may be its neighbours: one point stands for all of them.

class Feet_search {
 public:
  /// \param most nothing farther is looked for
  Feet_search(const Segment_hierarchy& curves, const Xy<double>& q, double most)
      : curves_(curves), q_(q), most_(most), limit_(work_of_point(curves.number_of_segments())) {
    if (curves.empty()) return;
    const auto is_near = [&](const Box_tree::Node& node, std::size_t k) {
      return squared_distance(q_, node, k) <= most_square(most_);
    };
    for_each_item(curves.boxes(), is_near, [&](const Box_tree::Node& node, std::size_t k) {
      cut(curves_.piece(node.child[k]), curves_.region(node.child[k]));
      return true;
    });
    const auto key = [](const Part& p) { return std::tuple(p.segment, p.t0); };
    std::sort(parts_.begin(), parts_.end(), [&](const Part& p, const Part& r) { return key(p) < key(r); });
  }

  /// Nearest ones first.
  [[nodiscard]] std::vector<Closest_point<>> result() const {
    std::vector<Part> feet;
    for (std::size_t begin = 0, end = 0; begin < parts_.size(); begin = end) {
      while (end < parts_.size() && curve(parts_[end]) == curve(parts_[begin])) ++end;
      add_feet(begin, end, feet);
    }
    std::vector<Closest_point<>> points;
    const Query_status status = limit_.is_reached() ? Query_status::LIMIT_REACHED : Query_status::COMPLETE;
    for (const Part& p : feet) {
      if (p.distance.lower > most_) continue;
      const Xy<double> point = curves_.evaluator(curves_.bezier_of(p.segment))(p.t).point;
      points.push_back({p.distance, point, curves_.place_at(p.segment, p.t), status});
    }
    std::stable_sort(points.begin(), points.end(), [](const Closest_point<>& p, const Closest_point<>& r) {
      return p.distance.upper < r.distance.upper;
    });
    return points;
  }

 private:
  enum class Where : std::uint8_t { FIRST, LAST, INSIDE, ALL };
  // A piece with its nearest point.
  struct Part {
    std::uint32_t segment;
    double t0, t1, t;
    Bracket distance;
    Where where;
  };

  void cut(const Spiral_piece_2& piece, const Fat_arc_2& fat) {
    const Bracket d = distance_bounds(q_, fat);
    if (!(d.lower <= most_)) return;
    const double error = curves_.error(piece.segment);
    const Foot_convexity f = foot_convexity(q_, piece, error);
    const auto bounds_at = [&](const Spiral_sample& s) { return bounds_of_point(euclidean_norm(s.point - q_), error); };
    if (f.is_rising) return add(piece, piece.first.t, bounds_at(piece.first), Where::FIRST);
    if (f.is_falling) return add(piece, piece.last.t, bounds_at(piece.last), Where::LAST);
    constexpr double LEAST = 0x1p-6;  // below, a foot is hard to tell
    if (f.least >= LEAST) {
      const Foot foot(curves_, q_, piece, f.least, most_);
      if (foot.outcome == Foot::Outcome::TOO_FAR) return;
      if (foot.outcome == Foot::Outcome::FOUND) {
        const double t = is_within(piece, foot.better_t, foot.distance.upper) ? foot.better_t : foot.t;
        return add(piece, t, foot.distance, where(piece, t, foot.distance.upper));
      }
    }
    const auto parts = halves(curves_, piece);
    if (!parts || is_level(*parts, d.lower, error) || !limit_.spend()) return add(piece, piece.first.t, d, Where::ALL);
    cut(parts->first, curves_.region(parts->first));
    cut(parts->second, curves_.region(parts->second));
  }
  // Whether ends and middle of a piece are as near as any of its points may be.
  [[nodiscard]] bool is_level(const Spiral_halves_2& h, double lower, double error) const {
    const double most = lower + 3 * distance_resolution(error, lower);
    for (const Spiral_sample* s : {&h.first.first, &h.first.last, &h.second.last})
      if (euclidean_norm(s->point - q_) > most) return false;
    return true;
  }
  [[nodiscard]] bool is_within(const Spiral_piece_2& piece, double t, double distance) const {
    return euclidean_norm(curves_.evaluator(curves_.bezier_of(piece.segment))(t).point - q_) <= distance;
  }
  // What Newton's steps end next to may as well be the end, where that is not certainly farther than `upper`.
  [[nodiscard]] Where where(const Spiral_piece_2& piece, double t, double upper) const {
    const double room = 0x1p-20 * (piece.last.t - piece.first.t), error = curves_.error(piece.segment);
    const auto may_be = [&](const Spiral_sample& end) {
      return std::fabs(t - end.t) <= room && bounds_of_point(euclidean_norm(end.point - q_), error).lower <= upper;
    };
    if (may_be(piece.first)) return Where::FIRST;
    return may_be(piece.last) ? Where::LAST : Where::INSIDE;
  }
  void add(const Spiral_piece_2& piece, double t, const Bracket& d, Where w) {
    parts_.push_back({piece.segment, piece.first.t, piece.last.t, t, d, w});
  }

  [[nodiscard]] std::uint32_t curve(const Part& p) const { return curves_.place(p.segment).curve; }
  [[nodiscard]] bool starts_segment(const Part& p) const { return p.t0 == curves_.piece(p.segment).first.t; }
  [[nodiscard]] bool ends_segment(const Part& p) const { return p.t1 == curves_.piece(p.segment).last.t; }
  // Whether a curve goes on from p to r, which comes later on it.
  [[nodiscard]] bool are_joined(const Part& p, const Part& r) const {
    if (p.segment == r.segment) return p.t1 == r.t0;
    return p.segment + 1 == r.segment && ends_segment(p) && starts_segment(r);
  }
  // Whether a closed curve goes on from its last part p to its first part r.
  [[nodiscard]] bool are_joined_round(const Part& p, const Part& r) const {
    const std::uint32_t last = p.segment + 1, of = curve(p);
    const bool starts_curve = r.segment == 0 || curves_.place(r.segment - 1).curve != of;
    const bool ends_curve = last == curves_.number_of_segments() || curves_.place(last).curve != of;
    return starts_curve && ends_curve && starts_segment(r) && ends_segment(p) &&
           curves_.drawing().curves()[of].is_closed;
  }

  // Parts [begin, end) of one curve that are joined are one way along it.
  void add_feet(std::size_t begin, std::size_t end, std::vector<Part>& feet) const {
    std::vector<std::size_t> starts;
    for (std::size_t i = begin; i < end; ++i)
      if (i == begin || !are_joined(parts_[i - 1], parts_[i])) starts.push_back(i);
    const std::size_t count = starts.size();
    starts.push_back(end);
    const bool is_round = are_joined_round(parts_[end - 1], parts_[begin]), is_led_on = is_round && count > 1;
    const auto at = [this](std::size_t i) { return parts_.begin() + static_cast<std::ptrdiff_t>(i); };
    for (std::size_t k = is_led_on ? 1 : 0; k < count; ++k) {
      std::vector<Part> way(at(starts[k]), at(starts[k + 1]));
      if (is_led_on && k + 1 == count) way.insert(way.end(), at(begin), at(starts[1]));
      add_feet_of(way, is_round && count == 1, feet);
    }
  }
  // The distance is least inside a part, or where it falls before and rises behind, with parts between that are all as
  // near: an end of a way counts as either. One point stands for all of such parts.
  static void add_feet_of(std::vector<Part>& way, bool is_ring, std::vector<Part>& feet) {
    // a ring is cut where no such point is
    const auto is_start = [](const Part& p) { return p.where == Where::INSIDE || p.where == Where::LAST; };
    const auto start = std::find_if(way.begin(), way.end(), is_start);
    is_ring = is_ring && start != way.end();
    if (is_ring) std::rotate(way.begin(), start, way.end());
    if (way.size() == 1) return feet.push_back(way.front());
    std::vector<Part> fallen;
    const auto finish = [&] {
      if (!fallen.empty()) feet.push_back(nearest_of(fallen));
      fallen.clear();
    };
    bool is_falling = !is_ring;
    for (const Part& p : way) {
      const bool was_falling =
          std::exchange(is_falling, p.where == Where::LAST || (p.where == Where::ALL && is_falling));
      if (p.where == Where::LAST || p.where == Where::INSIDE) fallen.clear();
      if (p.where == Where::INSIDE || was_falling || is_falling) fallen.push_back(p);
      if (!is_falling) finish();
    }
    if (!is_ring) finish();
  }
  // Newton's steps may have ended next to the end that parts share.
  [[nodiscard]] static Part nearest_of(const std::vector<Part>& parts) {
    const auto is_nearer = [](const Part& p, const Part& r) { return p.distance.upper < r.distance.upper; };
    Part nearest = *std::min_element(parts.begin(), parts.end(), is_nearer);
    for (const Part& p : parts) nearest.distance.lower = (std::min)(nearest.distance.lower, p.distance.lower);
    return nearest;
  }

  const Segment_hierarchy& curves_;
  Xy<double> q_;
  double most_;
  Work_limit limit_;
  std::vector<Part> parts_;
};

// What was found in a unit, about a point that was rounded by an error, in the drawing's own lengths.
[[nodiscard]] static Closest_point<> told(const Unit& unit, const Closest_point<>& found, double error) {
  Closest_point<> result = out(unit, found);
  if (error > 0) result.distance = widened(result.distance, error);
  return result;
}
[[nodiscard]] static std::optional<Closest_point<>> told(const Unit& unit, const std::optional<Closest_point<>>& found,
                                                         double error) {
  return found ? std::optional(told(unit, *found, error)) : std::nullopt;
}

std::optional<Closest_point<>> closest_point(const Bounding_arc_tree_2& curves, const Asked_point& q) {
  return told(curves.unit(), closest_point(curves.in_unit(), point_in(curves.unit(), q.point)), q.error);
}
std::optional<Closest_point<>> closest_point(const Bounding_arc_tree_2& curves, const Asked_point& q,
                                             const Curve_place& near) {
  return told(curves.unit(), closest_point(curves.in_unit(), point_in(curves.unit(), q.point), near), q.error);
}

std::vector<Closest_point<>> closest_points(const Bounding_arc_tree_2& curves, const Asked_point& q, double eps) {
  check_positive(eps);
  const Segment_hierarchy& in_unit = curves.in_unit();
  const Xy<double> p = point_in(curves.unit(), q.point);
  const auto nearest = closest_point(in_unit, p);
  if (!nearest) return {};
  const double most = nearest->distance.upper + curves.unit().tolerance_in(eps);
  auto found = Feet_search(in_unit, p, most).result();
  for (Closest_point<>& f : found) f = told(curves.unit(), f, q.error);
  return found;
}

std::vector<Closest_point<>> k_nearest_curves(const Bounding_arc_tree_2& curves, const Asked_point& q, std::size_t k) {
  const Xy<double> p = point_in(curves.unit(), q.point);
  if (k == 0) return {};
  Nearest_curves_search search(curves.in_unit(), p, k);
  auto found = search.result();
  for (Closest_point<>& f : found) f = told(curves.unit(), f, q.error);
  return found;
}

}  // namespace CGAL::Bounding_arcs::internal
