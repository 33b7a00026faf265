// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of query/closest_points.h.

#include "query_units.h"

#include <CGAL/Bounding_arcs_2/query/Query_point.h>
#include <CGAL/Bounding_arcs_2/query/closest_points.h>
#include "../tree/Segment_hierarchy.h"
#include "Closest_search.h"
#include "Foot.h"

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
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
    std::vector<Closest_point<>> points;
    const Query_status status = limit_.is_reached() ? Query_status::LIMIT_REACHED : Query_status::COMPLETE;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      if (!is_least(i)) continue;
      const Part p = nearest_with(i);
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
  static constexpr std::size_t NONE = static_cast<std::size_t>(-1);

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

  [[nodiscard]] bool starts_segment(const Part& p) const { return p.t0 == curves_.piece(p.segment).first.t; }
  [[nodiscard]] bool ends_segment(const Part& p) const { return p.t1 == curves_.piece(p.segment).last.t; }
  [[nodiscard]] std::uint32_t curve(std::uint32_t segment) const { return curves_.place(segment).curve; }
  [[nodiscard]] bool starts_curve(const Part& p) const {
    return starts_segment(p) && (p.segment == 0 || curve(p.segment - 1) != curve(p.segment));
  }
  [[nodiscard]] bool ends_curve(const Part& p) const {
    return ends_segment(p) &&
           (p.segment + 1 == curves_.number_of_segments() || curve(p.segment + 1) != curve(p.segment));
  }
  // Whether a curve goes on from p to r.
  [[nodiscard]] bool are_joined(const Part& p, const Part& r) const {
    if (curve(p.segment) != curve(r.segment)) return false;
    if (p.segment == r.segment && p.t1 == r.t0) return true;
    if (ends_curve(p) && starts_curve(r)) return curves_.drawing().curves()[curve(p.segment)].is_closed;
    return p.segment + 1 == r.segment && ends_segment(p) && starts_segment(r);
  }
  // The part of a curve after and before part i, the first one after the last of a closed curve.
  [[nodiscard]] std::size_t after(std::size_t i) const {
    if (i + 1 < parts_.size() && are_joined(parts_[i], parts_[i + 1])) return i + 1;
    if (!ends_curve(parts_[i])) return NONE;
    const auto first = std::partition_point(parts_.begin(), parts_.end(),
                                            [&](const Part& p) { return curve(p.segment) < curve(parts_[i].segment); });
    return are_joined(parts_[i], *first) ? static_cast<std::size_t>(first - parts_.begin()) : NONE;
  }
  [[nodiscard]] std::size_t before(std::size_t i) const {
    if (i > 0 && are_joined(parts_[i - 1], parts_[i])) return i - 1;
    if (!starts_curve(parts_[i])) return NONE;
    const auto next = std::partition_point(parts_.begin(), parts_.end(),
                                           [&](const Part& p) { return curve(p.segment) <= curve(parts_[i].segment); });
    const auto last = static_cast<std::size_t>(next - parts_.begin()) - 1;
    return are_joined(parts_[last], parts_[i]) ? last : NONE;
  }
  // Whether the nearest point of part i is one of the curve, and this part the one to tell it.
  [[nodiscard]] bool is_least(std::size_t i) const {
    const Part& p = parts_[i];
    if (p.where == Where::INSIDE) return true;
    const std::size_t next = after(i), previous = before(i);
    if (p.where == Where::LAST) return next == NONE || next == i || parts_[next].where == Where::FIRST;
    if (p.where == Where::FIRST) return previous == NONE || previous == i;
    // where a curve falls away from a run of such parts, that is farthest, not nearest
    if (previous != NONE && parts_[previous].where != Where::ALL && parts_[previous].where != Where::LAST) return false;
    std::size_t end = next;
    while (end != NONE && end != i && parts_[end].where == Where::ALL) end = after(end);
    if (end != NONE && end != i && parts_[end].where != Where::FIRST) return false;
    // of a run of parts that are all near the first one tells, or of a whole curve its first part
    const bool is_first = previous == NONE || parts_[previous].where != Where::ALL || starts_curve(p);
    return is_first && !(previous != NONE && previous != i && starts_curve(p) && parts_[previous].where == Where::ALL &&
                         !all_near(i));
  }
  // The nearest point of the parts that part i tells for: Newton's steps may have ended next to the end that they
  // share.
  [[nodiscard]] Part nearest_with(std::size_t i) const {
    Part nearest = parts_[i];
    const auto take = [&](std::size_t k, Where w) {
      if (k == NONE || k == i || parts_[k].where != w) return false;
      const double lower = (std::min)(nearest.distance.lower, parts_[k].distance.lower);
      if (parts_[k].distance.upper < nearest.distance.upper) nearest = parts_[k];
      nearest.distance.lower = lower;
      return true;
    };
    if (parts_[i].where == Where::LAST) take(after(i), Where::FIRST);
    if (parts_[i].where != Where::ALL) return nearest;
    take(before(i), Where::LAST);
    std::size_t k = after(i);
    while (take(k, Where::ALL)) k = after(k);
    take(k, Where::FIRST);
    return nearest;
  }
  // Whether all parts of a curve, from its first one on, are near.
  [[nodiscard]] bool all_near(std::size_t i) const {
    for (std::size_t k = i;;) {
      if (parts_[k].where != Where::ALL) return false;
      k = after(k);
      if (k == NONE || k == i) return k == i;
    }
  }

  const Segment_hierarchy& curves_;
  Xy<double> q_;
  double most_;
  Work_limit limit_;
  std::vector<Part> parts_;
};

// Brackets in their unit as those of the point that was asked about.
static void take_out(const Unit& unit, double error, std::vector<Closest_point<>>& found) {
  for (Closest_point<>& f : found) {
    f = out(unit, f);
    if (error > 0) f.distance = widened(f.distance, error);
  }
}

std::vector<Closest_point<>> closest_points(const Bounding_arc_tree_2& curves, const Asked_point& q, double eps) {
  check_positive(eps);
  const Segment_hierarchy& in_unit = curves.in_unit();
  const Xy<double> p = point_in(curves.unit(), q.point);
  const auto nearest = closest_point(in_unit, p);
  if (!nearest) return {};
  const double most = nearest->distance.upper + curves.unit().tolerance_in(eps);
  auto found = Feet_search(in_unit, p, most).result();
  take_out(curves.unit(), q.error, found);
  return found;
}

std::vector<Closest_point<>> k_nearest_curves(const Bounding_arc_tree_2& curves, const Asked_point& q, std::size_t k) {
  const Xy<double> p = point_in(curves.unit(), q.point);
  if (k == 0) return {};
  Nearest_curves_search search(curves.in_unit(), p, k);
  auto found = search.result();
  take_out(curves.unit(), q.error, found);
  return found;
}

}  // namespace CGAL::Bounding_arcs::internal
