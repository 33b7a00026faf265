// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The search for the point of a drawing nearest to a point.
//
// Boxes, then regions of segments leave out what is too far.  A piece that is left has one nearest point, which is
// found (Foot.h), or it is halved.

#ifndef BOUNDING_ARCS_LIBRARY_QUERY_CLOSEST_SEARCH_H
#define BOUNDING_ARCS_LIBRARY_QUERY_CLOSEST_SEARCH_H

#include <CGAL/Bounding_arcs_2/query/Query_point.h>
#include "../tree/Segment_hierarchy.h"
#include "Foot.h"
#include "query_units.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace CGAL::Bounding_arcs {

/// What fat arcs tell of a distance where their pieces are as short as can be: twice what distance_room has for it, and
/// the radius of a piece without thickness, with as much again.
[[nodiscard]] inline double distance_resolution(double error, double distance) {
  return 8 * error + 4 * (ARC_DISTANCE_ERROR + 20 * HALF_ULP) * distance;
}

/// One search: pieces are looked at in any order, and what is found is the nearest of all.
/// \tparam Curves Segment_hierarchy, or one that has regions of another kind
template <class Curves = Segment_hierarchy> class Closest_search {
  using Region = typename Curves::Region;

 public:
  /// \param most nothing farther is looked for
  Closest_search(const Curves& curves, const Xy<double>& q, double most)
      : curves_(curves), q_(q), upper_(most), lower_(most), own_limit_(work_of_point(curves.number_of_segments())),
        limit_(&own_limit_) {}
  /// Makes a search that is a part of a larger one, which has the limit.
  Closest_search(const Curves& curves, const Xy<double>& q, double most, Work_limit& limit)
      : curves_(curves), q_(q), upper_(most), lower_(most), own_limit_(0), limit_(&limit) {}
  Closest_search(const Closest_search&) = delete;
  Closest_search& operator=(const Closest_search&) = delete;

  [[nodiscard]] double upper() const { return upper_; }
  /// Looks at all segments whose boxes are no farther than what was found.
  void search() { nodes_ += for_each_near(curves_.boxes(), *this); }
  /// Nodes of the tree of boxes that were looked at.
  [[nodiscard]] std::size_t nodes() const { return nodes_; }
  // What boxes are asked for, see for_each_near.
  [[nodiscard]] const Xy<double>& point() const { return q_; }
  [[nodiscard]] double squared_reach() const { return most_square(upper_); }
  [[nodiscard]] bool goes_on(double squared_distance) const { return squared_distance <= squared_reach(); }
  /// Looks at one segment.
  void look_at(std::uint32_t segment) {
    const double lower = distance_bounds(q_, curves_.region(segment)).lower;
    if (lower < upper_) refine(curves_.piece(segment), lower);
  }
  /// Looks at a piece of one.
  void look_at(const Spiral_piece_2& piece, const Region& region) {
    const double lower = distance_bounds(q_, region).lower;
    if (lower < upper_) refine(piece, lower);
  }
  /// Takes a point of the drawing for the nearest until a nearer one is found.
  void start_from(std::uint32_t segment, const Spiral_sample& sample) {
    const double d = euclidean_norm(sample.point - q_), error = curves_.error(segment);
    offer({upper_, internal::bounds_of_point(d, error).upper}, segment, sample);
  }
  /// The segment of what was found. \pre there is something
  [[nodiscard]] std::uint32_t segment() const { return segment_; }
  /// A lower bound of the distance of all that was looked at, or `most` where that is less.
  [[nodiscard]] double lower() const { return (std::min)(lower_, upper_); }
  /// Whether pieces were left as they were, as the limit was reached.
  [[nodiscard]] bool is_limited() const { return is_limited_; }
  /// \return nothing where all is farther than `most`
  [[nodiscard]] std::optional<Closest_point<>> result() const {
    if (!place_) return std::nullopt;
    const Bezier_evaluator& curve = curves_.evaluator(curves_.bezier_of(segment_));
    Curve_place place = *place_;
    Xy<double> point = curve(place.t).point;
    if (euclidean_norm(point - q_) > upper_) {
      place.t = sure_t_;
      point = curve(place.t).point;
    }
    const Query_status status = is_limited_ ? Query_status::LIMIT_REACHED : Query_status::COMPLETE;
    return Closest_point<>{{(std::min)(lower_, upper_), upper_}, point, place, status};
  }

 private:
  // What is within `most` but is not looked at is at least this far.
  void leave_out(double lower) { lower_ = (std::min)(lower_, lower); }

  bool offer(const Bracket& d, std::uint32_t segment, const Spiral_sample& s) {
    leave_out(d.lower);
    if (place_ ? !(d.upper < upper_) : d.upper > upper_) return false;
    upper_ = d.upper;
    segment_ = segment;
    place_ = curves_.place_at(segment, s.t);
    sure_t_ = s.t;
    return true;
  }

  void refine(const Spiral_piece_2& piece, double lower) {
    const double error = curves_.error(piece.segment);
    const internal::Foot_convexity f = internal::foot_convexity(q_, piece, error);
    if (f.is_rising || f.is_falling) return finish_at_end(piece, f.is_rising ? piece.first : piece.last);
    constexpr double LEAST = 0x1p-6;  // below, halving is worth more than a foot that is hard to tell
    if (f.least >= LEAST && finish_convex(piece, f.least)) return;
    // the ends are points of the curve: what is found first keeps others short
    const double resolution = distance_resolution(error, upper_);
    const auto middle = halves(curves_, piece);
    if (!middle || lower >= upper_ - resolution) return give_up(piece, lower);
    if (!limit_->spend()) {
      is_limited_ = true;
      return give_up(piece, lower);
    }
    const Bracket d[2] = {distance_bounds(q_, curves_.region(middle->first)),
                          distance_bounds(q_, curves_.region(middle->second))};
    const Xy<double> way = middle->first.last.point - q_;
    offer({lower_, internal::bounds_of_point(euclidean_norm(way), error).upper}, piece.segment, middle->first.last);
    const std::size_t nearer = d[1].lower < d[0].lower ? 1 : 0;
    for (const std::size_t i : {nearer, 1 - nearer}) {
      if (!(d[i].lower < upper_)) continue;
      refine(i == 0 ? middle->first : middle->second, d[i].lower);
    }
  }
  // Nothing more can be told of this piece.
  void give_up(const Spiral_piece_2& piece, double lower) {
    const double error = curves_.error(piece.segment);
    for (const Spiral_sample* s : {&piece.first, &piece.last})
      offer({lower, internal::bounds_of_point(euclidean_norm(s->point - q_), error).upper}, piece.segment, *s);
  }

  // No point of the piece is nearer than this end of it.
  void finish_at_end(const Spiral_piece_2& piece, const Spiral_sample& end) {
    offer(internal::bounds_of_point(euclidean_norm(end.point - q_), curves_.error(piece.segment)), piece.segment, end);
  }

  // \return false if the piece may have several nearest points
  bool finish_convex(const Spiral_piece_2& piece, double convexity) {
    const internal::Foot foot(curves_, q_, piece, convexity, upper_);
    if (foot.outcome != internal::Foot::Outcome::FOUND) return foot.outcome == internal::Foot::Outcome::TOO_FAR;
    Spiral_sample sample;
    sample.t = foot.better_t;
    if (offer(foot.distance, piece.segment, sample)) sure_t_ = foot.t;
    return true;
  }

  const Curves& curves_;
  Xy<double> q_;
  double upper_, lower_;
  Work_limit own_limit_, *limit_;
  bool is_limited_ = false;
  std::size_t nodes_ = 0;
  std::uint32_t segment_ = 0;
  double sure_t_ = 0;
  std::optional<Curve_place> place_;
};

/// An upper bound of what a search finds for the distance of a point that is no farther than a place of the drawing.
[[nodiscard]] inline double distance_to_look_within(const Segment_hierarchy& curves, const Xy<double>& q,
                                                    const Curve_place& near) {
  const std::uint32_t bezier = curves.number_of_bezier(near.curve, near.bezier);
  const Bezier_evaluator& curve = curves.evaluator(bezier);
  const double d = euclidean_norm(curve(near.t).point - q), error = 2 * curve.point_error() + curves.rounding(bezier);
  return d + 2 * distance_resolution(error, d);
}

/// Returns the point of the curves nearest to another one, if it is nearer than `most`.
[[nodiscard]] inline std::optional<Closest_point<>> closest_point(
    const Segment_hierarchy& curves, const Xy<double>& q, double most = std::numeric_limits<double>::infinity()) {
  Closest_search search(curves, q, most);
  search.search();
  return search.result();
}
/// Returns the nearest point, which is sought from a place on.
[[nodiscard]] inline std::optional<Closest_point<>> closest_point(const Segment_hierarchy& curves, const Xy<double>& q,
                                                                  const Curve_place& near) {
  auto result = closest_point(curves, q, distance_to_look_within(curves, q, near));
  return result ? result : closest_point(curves, q);
}

}  // namespace CGAL::Bounding_arcs

#endif
