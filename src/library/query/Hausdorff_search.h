// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The search for the farthest point.

#ifndef BOUNDING_ARCS_LIBRARY_QUERY_HAUSDORFF_SEARCH_H
#define BOUNDING_ARCS_LIBRARY_QUERY_HAUSDORFF_SEARCH_H

#include <CGAL/Bounding_arcs_2/query/Query_point.h>
#include <CGAL/assertions.h>
#include "../tree/Segment_hierarchy.h"
#include "Closest_search.h"
#include "Farthest_bound.h"
#include "query_units.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <queue>
#include <vector>

namespace CGAL::Bounding_arcs {

/// The search for the point of one drawing that is farthest from another. What may be farthest is looked at first:
/// boxes by their middles, then pieces by the nearest points of their ends (Farthest_bound.h). Pieces are halved until
/// the largest bound is near to the distance of a point that was looked at.
/// \tparam Curves Segment_hierarchy, or one that has regions of another kind
template <class Curves = Segment_hierarchy> class Hausdorff_search {
 public:
  /// \param least what is no farther is not looked for
  /// \pre neither curves is empty
  Hausdorff_search(const Curves& a, const Curves& b, double tolerance, double least = 0)
      : a_(a), b_(b), tolerance_(tolerance), lower_(least),
        limit_(work_of_points(a.number_of_segments() + b.number_of_segments())) {
    CGAL_precondition(a.number_of_segments() > 0 && b.number_of_segments() > 0);
  }

  void search() {
    add_boxes(a_.boxes().root());
    while (!nodes_.empty()) {
      const Node node = nodes_.top();
      nodes_.pop();
      const bool is_enough = node.upper <= lower_ + (seen_.empty() ? 0 : tolerance_) && is_started();
      if (is_enough || is_settled(node)) upper_ = (std::max)(upper_, node.upper);
      if (is_enough) return;
      if (is_settled(node)) continue;
      if (!limit_.spend()) {
        upper_ = (std::max)(upper_, node.upper);
        return;
      }
      if (node.kind == Kind::BOXES) add_boxes(a_.boxes().node(node.first));
      else if (node.kind == Kind::SEGMENT) add_segment(node.first);
      else halve(node);
    }
  }
  /// Bounds of the largest distance, or of `least` where that is larger.
  [[nodiscard]] Bracket bounds() const { return {lower_, (std::max)(upper_, lower_)}; }
  /// Whether a point that is farther than `least` was found, and that point with the nearest one to it.
  [[nodiscard]] bool has_result() const { return farthest_ != NONE; }
  [[nodiscard]] Drawing_distance<> result() const {
    const Seen& s = seen_[farthest_];
    return {bounds(),
            {s.sample.point, a_.place_at(s.segment, s.sample.t)},
            {s.foot.point, b_.place_at(s.foot_segment, s.foot.t)},
            status_of(bounds().upper - bounds().lower, tolerance_, limit_.is_reached())};
  }
  /// Whether the search ended at its limit.
  [[nodiscard]] bool is_limited() const { return limit_.is_reached(); }
  /// Points whose nearest one was looked for.
  [[nodiscard]] std::size_t points() const { return seen_.size() + middles_; }

 private:
  enum class Kind : std::uint8_t { BOXES, SEGMENT, PIECE };
  struct Node {
    double upper;
    std::uint32_t first, last;  // a node of boxes, a segment, or two points that were seen
    Kind kind;
    friend bool operator<(const Node& p, const Node& q) { return p.upper < q.upper; }
  };
  // A point of a with the nearest one of b.
  struct Seen {
    Spiral_sample sample, foot;
    std::uint32_t segment, foot_segment;
    double upper;
  };
  static constexpr std::uint32_t NONE = std::numeric_limits<std::uint32_t>::max();

  // Whether there is something to compare with: a point, where all is less than a positive number of no interest.
  [[nodiscard]] bool is_started() const { return lower_ > 0 || !seen_.empty(); }
  void add(const Node& node) {
    if (node.upper > lower_ || !is_started()) nodes_.push(node);
  }
  // All of a box is within half its diagonal of the middle.
  void add_boxes(const Box_tree::Node& node) {
    for (std::size_t k = 0; k < node.size; ++k) {
      const Xy<double> middle{node.x_low[k] / 2 + node.x_high[k] / 2, node.y_low[k] / 2 + node.y_high[k] / 2},
          half{node.x_high[k] / 2 - node.x_low[k] / 2, node.y_high[k] / 2 - node.y_low[k] / 2};
      const double size = euclidean_norm(half),
                   rounding = 8 * HALF_ULP * (std::fabs(middle.x) + std::fabs(middle.y) + size);
      const double upper = nearest_upper(middle, lower_ - size) + size + rounding;
      add({upper, node.child[k], 0, node.is_item(k) ? Kind::SEGMENT : Kind::BOXES});
    }
  }
  // An upper bound of the distance of b that exceeds it by no more than the thickness of its segments, or a number less
  // than `enough`.
  [[nodiscard]] double nearest_upper(const Xy<double>& q, double enough) {
    ++middles_;
    Coarse_search search{b_, q, enough, std::numeric_limits<double>::infinity()};
    for_each_near(b_.boxes(), search);
    return search.upper;
  }
  struct Coarse_search {
    const Curves& curves;
    Xy<double> q;
    double enough, upper;

    [[nodiscard]] const Xy<double>& point() const { return q; }
    [[nodiscard]] double squared_reach() const { return upper * upper; }
    [[nodiscard]] bool goes_on(double squared_distance) const {
      return upper > enough && squared_distance < squared_reach();
    }
    void look_at(std::uint32_t segment) { upper = (std::min)(upper, distance_bounds(q, curves.region(segment)).upper); }
  };

  void add_segment(std::uint32_t segment) {
    const Spiral_piece_2 piece = a_.piece(segment);
    const std::uint32_t first = see(segment, piece.first, NONE, NONE), last = see(segment, piece.last, first, NONE);
    add({upper_bound(first, last), first, last, Kind::PIECE});
  }
  // Whether halving tells no more of a piece: its bound is beyond the farthest point, or what is known of its own ends,
  // by no more than what doubles leave open of its and its nearest points' places.
  [[nodiscard]] bool is_settled(const Node& node) const {
    if (node.kind != Kind::PIECE) return false;
    const Seen &p = seen_[node.first], &q = seen_[node.last];
    const double error = a_.error(p.segment) + (std::max)(b_.error(p.foot_segment), b_.error(q.foot_segment));
    return node.upper <= (std::max)({lower_, p.upper, q.upper}) + distance_resolution(error, lower_);
  }
  void halve(const Node& node) {
    const Seen &first = seen_[node.first], &last = seen_[node.last];
    const auto parts = halves(a_, {first.segment, first.sample, last.sample});
    if (!parts) {
      upper_ = (std::max)(upper_, node.upper);
      return;
    }
    const std::uint32_t middle = see(first.segment, parts->first.last, node.first, node.last);
    add({(std::min)(node.upper, upper_bound(node.first, middle)), node.first, middle, Kind::PIECE});
    add({(std::min)(node.upper, upper_bound(middle, node.last)), middle, node.last, Kind::PIECE});
  }

  // Looks for the nearest point; those of neighbours are near to it.
  [[nodiscard]] std::uint32_t see(std::uint32_t segment, const Spiral_sample& sample, std::uint32_t left,
                                  std::uint32_t right) {
    constexpr std::size_t OF_POINT = 8;  // as much as so many halvings, at least
    static_cast<void>(limit_.spend(OF_POINT));
    Closest_search search(b_, sample.point, std::numeric_limits<double>::infinity(), limit_);
    for (const std::uint32_t near : {left, right})
      if (near != NONE) search.start_from(seen_[near].foot_segment, seen_[near].foot);
    search.search();
    const auto r = search.result();
    const double error = a_.error(segment);
    Seen seen{sample, {}, segment, search.segment(), r->distance.upper};
    seen.foot = b_.sample(seen.foot_segment, r->place.t);
    const auto place = static_cast<std::uint32_t>(seen_.size());
    seen_.push_back(seen);
    const double lower = r->distance.lower - error;
    if (lower > lower_ || (farthest_ == NONE && lower_ == 0)) farthest_ = place;
    lower_ = (std::max)(lower_, lower);
    return place;
  }

  [[nodiscard]] double upper_bound(std::uint32_t i, std::uint32_t j) const {
    const Seen &p = seen_[i], &q = seen_[j];
    const double error_a = a_.error(p.segment),
                 error_b = (std::max)(b_.error(p.foot_segment), b_.error(q.foot_segment)), error = error_a + error_b;
    const internal::Bent_piece a(p.sample, q.sample, error_a);
    double upper = 0.5 * (p.upper + q.upper + a.length) + error_a;
    if (a.is_known) {
      const Xy<double> d00 = p.sample.point - p.foot.point, d11 = q.sample.point - q.foot.point;
      upper = (std::min)(
          upper, std::sqrt(internal::largest_of_lesser(internal::from_point(a, d00, q.sample.point - p.foot.point),
                                                       internal::from_point(a, p.sample.point - q.foot.point, d11))));
      if (p.foot_segment == q.foot_segment) {
        const internal::Bent_piece b(p.foot, q.foot, error_b);
        if (b.is_known) upper = (std::min)(upper, internal::from_piece(a, b, d00, d11));
      }
    }
    return upper * ROUNDED_UP<16> + 2 * error;
  }

  const Curves &a_, &b_;
  double tolerance_, lower_, upper_ = 0;
  std::priority_queue<Node> nodes_;
  std::vector<Seen> seen_;
  std::uint32_t farthest_ = NONE;
  std::size_t middles_ = 0;
  Work_limit limit_;
};

}  // namespace CGAL::Bounding_arcs

#endif
