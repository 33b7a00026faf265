// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The search for the nearest points of two drawings.
//
// Pairs of boxes, then of regions leave out what is too far.  A pair of pieces that is left is done when distances
// grow all along one of them, whose end then is nearest, or when the squared distance is convex (Piece_pair.h); else
// the longer one is halved, and its new end is looked for on the other, which keeps pairs of coincident pieces apart
// from those that have something to tell.  Lower bounds of pairs of arcs are within a multiple of the cube of their
// length, so that parallel curves, where nothing is convex, end at the cube root of the tolerance.

#ifndef BOUNDING_ARCS_LIBRARY_QUERY_DISTANCE_SEARCH_H
#define BOUNDING_ARCS_LIBRARY_QUERY_DISTANCE_SEARCH_H

#include "Pair_newton.h"

#include <CGAL/Bounding_arcs_2/query/Query_point.h>
#include <CGAL/Bounding_arcs_2/region/Fat_arc_2.h>
#include "../tree/Segment_hierarchy.h"
#include "Closest_search.h"
#include "Foot.h"
#include "Work_limit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

// Two pieces of spiral segments, and how the squared distance f(s, t) = |D|^2, D = A(s) - B(t), of their points behaves
// over both arc lengths:
//   f_s / 2 = T_A.D,  f_t / 2 = -T_B.D,  f_ss / 2 = 1 + kappa_A n_A.D,  f_tt / 2 = 1 - kappa_B n_B.D,
//   f_st / 2 = -T_A.T_B.
//
// One sign of a derivative.  T_A is between the tangents at the ends of A, less than half a turn apart, so T_A.D is
// positive if it is at both for all D; those are in the difference of two boxes.
//
// Convexity.  Each of s and t is within half a length of an end.  From there T.D changes by at most 1 + kappa |D| per
// length of its own piece and by 1 of the other's; n.D by kappa |T.D| per length of its own and by |n_A.T_B| of the
// other's, which changes by kappa_A, kappa_B itself.  So values at the four pairs of ends bound all three, the second
// derivatives with them, a <= f_ss / 2, b <= f_tt / 2, (f_st / 2)^2 <= c, and the least eigenvalue is at least
// (a b - c) / (a + b).

namespace CGAL::Bounding_arcs::internal {

/// 1 where distances from all points of piece b grow all along piece a, -1 where they fall, 0 if that is not known.
/// \param error of points of both pieces together
[[nodiscard]] inline int growth_along(const Spiral_piece_2& a, const Spiral_piece_2& b, double error) {
  const Xy<double>&a0 = a.first.point, &a1 = a.last.point, &b0 = b.first.point, &b1 = b.last.point;
  const Xy<double> middle = 0.5 * ((a0 - b0) + (a1 - b1));
  const Xy<double> half{0.5 * (std::fabs(a1.x - a0.x) + std::fabs(b1.x - b0.x)),
                        0.5 * (std::fabs(a1.y - a0.y) + std::fabs(b1.y - b0.y))};
  const double unsure = tangent_error(a.first, a.last) + TANGENT_ROUNDING;
  const double size = std::fabs(middle.x) + std::fabs(middle.y) + half.x + half.y;
  const double room = unsure * size + 2 * error;
  int growth = 0;
  for (const Spiral_sample* s : {&a.first, &a.last}) {
    const double along = dot(s->tangent, middle),
                 change = std::fabs(s->tangent.x) * half.x + std::fabs(s->tangent.y) * half.y + room;
    const int own = along > change ? 1 : (along < -change ? -1 : 0);
    if (own == 0 || own == -growth) return 0;
    growth = own;
  }
  return growth;
}

/// A lower bound of the least eigenvalue of half the second derivatives of f, 0 if it is not known to be positive.
class Pair_convexity {
 public:
  Pair_convexity(const Spiral_piece_2& a, const Spiral_piece_2& b, double error_a, double error_b)
      : error_(error_a + error_b), of_a_(a, error_a), of_b_(b, error_b) {
    if (!(of_a_.most < LARGEST && of_b_.most < LARGEST)) return;
    const Spiral_sample *end_a[2] = {&a.first, &a.last}, *end_b[2] = {&b.first, &b.last};
    double least_sine = 1;
    for (const Spiral_sample* p : end_a)
      for (const Spiral_sample* q : end_b) {
        const Xy<double> way = p->point - q->point;
        const double sine = std::fabs(cross(p->tangent, q->tangent));
        farthest_ = (std::max)(farthest_, std::fabs(way.x) + std::fabs(way.y));
        sine_ = (std::max)(sine_, sine);
        least_sine = (std::min)(least_sine, sine);
        of_a_.add(p->tangent, way);
        of_b_.add(q->tangent, -way);
      }
    const double unsure = of_a_.unsure + of_b_.unsure + TANGENT_ROUNDING,
                 turn = 0.5 * (of_a_.most * of_a_.length + of_b_.most * of_b_.length) * UP + unsure;
    farthest_ = (farthest_ + 0.5 * (of_a_.length + of_b_.length)) * UP + error_;
    sine_ = (std::min)(1.0, sine_ + turn);
    const double sure_sine = (std::max)(0.0, least_sine - turn);
    room_ = unsure * farthest_ + error_;
    const double x = second(of_a_, of_b_), y = second(of_b_, of_a_), z = 1 - DOWN * (sure_sine * sure_sine);
    if (!(x > 0 && y > 0)) return;
    least = (std::max)(0.0, (DOWN * (x * y) - z) / (x + y) * DOWN);
  }

  double least = 0;

 private:
  static constexpr double UP = ROUNDED_UP<16>, DOWN = ROUNDED_DOWN<16>, LARGEST = 0x1p1000;

  // A piece: its left or right normal n, to the side it turns to, as seen along `way` from the other piece.
  struct Side {
    double length, most, least, unsure, turn, along = 0, inward = LARGEST;
    Side(const Spiral_piece_2& p, double error)
        : length(most_length(p, error)), most((std::max)(p.first.most_curvature, p.last.most_curvature)),
          least((std::min)(p.first.least_curvature, p.last.least_curvature)), unsure(tangent_error(p.first, p.last)),
          turn(cross(p.first.tangent, p.last.tangent) < 0 ? -1 : 1) {}
    void add(const Xy<double>& tangent, const Xy<double>& way) {
      along = (std::max)(along, std::fabs(dot(tangent, way)));
      inward = (std::min)(inward, turn * cross(tangent, way));
    }
  };
  // A lower bound of 1 + kappa n.D of a piece.
  [[nodiscard]] double second(const Side& own, const Side& other) const {
    const double along = own.along + 0.5 * (own.length * (1 + own.most * farthest_) + other.length) + room_,
                 change = 0.5 * (own.most * along * own.length + sine_ * other.length) + room_;
    const double inward = own.inward - change * UP;
    return (1 + (inward > 0 ? own.least : own.most) * inward) - 8 * HALF_ULP * (1 + own.most * farthest_);
  }

  double error_, farthest_ = 0, sine_ = 0, room_ = 0;
  Side of_a_, of_b_;
};

}  // namespace CGAL::Bounding_arcs::internal

namespace CGAL::Bounding_arcs {

/// Searches the nearest points of two drawings.
/// \tparam Curves Segment_hierarchy, or one that has regions of another kind
template <class Curves = Segment_hierarchy> class Distance_search {
  using Region = typename Curves::Region;
  using Piece = Piece_in_hand<Region>;

 public:
  /// \param eps how wide the bracket may be \param of_distance the same beside its upper bound: the larger counts
  Distance_search(const Curves& a, const Curves& b, double eps, double of_distance)
      : a_(a), b_(b), eps_(eps), of_distance_(of_distance),
        limit_(work_of_pairs(a.number_of_segments() + b.number_of_segments())) {}

  void search() {
    if (a_.empty() || b_.empty()) return;
    descend({&a_.boxes().root(), 0}, {&b_.boxes().root(), 0});
  }
  [[nodiscard]] std::optional<Drawing_distance<>> result() const {
    if (!found_) return std::nullopt;
    const double lower = (std::min)(lower_, upper_);
    const Query_status status = status_of(upper_ - lower, allowed(), limit_.is_reached());
    return Drawing_distance<>{{lower, upper_}, found_->a, found_->b, status};
  }
  /// Pairs of boxes and of pieces that were looked at.
  [[nodiscard]] std::size_t pairs() const { return pairs_; }

 private:
  struct Found {
    Drawing_point<> a, b;
  };
  [[nodiscard]] double allowed() const { return (std::max)(eps_, of_distance_ * upper_); }

  // A node of boxes, or a segment where it is none.
  struct Place {
    const Box_tree::Node* node;
    std::uint32_t segment;
  };
  static constexpr std::size_t WIDTH = Box_tree::WIDTH;

  [[nodiscard]] static Place child(const Curves& curves, const Place& p, std::size_t k) {
    if (p.node == nullptr) return p;
    const std::uint32_t i = p.node->child[k];
    return p.node->is_item(k) ? Place{nullptr, i} : Place{&curves.boxes().node(i), 0};
  }
  [[nodiscard]] static std::size_t size(const Place& p) { return p.node == nullptr ? 1 : p.node->size; }
  [[nodiscard]] static CGAL::Bbox_2 box(const Curves& curves, const Place& p, std::size_t k) {
    return p.node == nullptr ? curves.box(curves.piece(p.segment)) : p.node->box(k);
  }
  [[nodiscard]] static double squared_distance(const CGAL::Bbox_2& p, const CGAL::Bbox_2& q) {
    const double dx = (std::max)((std::max)(p.xmin() - q.xmax(), q.xmin() - p.xmax()), 0.0),
                 dy = (std::max)((std::max)(p.ymin() - q.ymax(), q.ymin() - p.ymax()), 0.0);
    return dx * dx + dy * dy;
  }

  void descend(const Place& p, const Place& q) {
    if (p.node == nullptr && q.node == nullptr) return look_at(p.segment, q.segment);
    struct Near {
      double distance;
      std::uint8_t k, l;
    };
    std::array<Near, WIDTH * WIDTH> pairs;
    std::size_t count = 0;
    const double most = most_square(upper_);
    for (std::size_t k = 0; k < size(p); ++k) {
      const CGAL::Bbox_2 of_p = box(a_, p, k);
      for (std::size_t l = 0; l < size(q); ++l) {
        const double d = squared_distance(of_p, box(b_, q, l));
        ++pairs_;
        if (!(d <= most)) continue;
        std::size_t i = count++;  // nearer ones first
        for (; i > 0 && pairs[i - 1].distance > d; --i) pairs[i] = pairs[i - 1];
        pairs[i] = {d, static_cast<std::uint8_t>(k), static_cast<std::uint8_t>(l)};
      }
    }
    for (std::size_t i = 0; i < count && pairs[i].distance <= most_square(upper_); ++i) {
      if (found_ && !limit_.spend()) return leave_out(std::sqrt(pairs[i].distance) * ROUNDED_DOWN<8>);
      descend(child(a_, p, pairs[i].k), child(b_, q, pairs[i].l));
    }
  }

  void look_at(std::uint32_t i, std::uint32_t j) {
    const Piece p{a_.piece(i), a_.region(i)}, q{b_.piece(j), b_.region(j)};
    const double lower = lower_bound(p, q);
    if (lower < upper_) refine(p, q, lower);
  }
  [[nodiscard]] double lower_bound(const Piece& p, const Piece& q) {
    ++pairs_;
    const double of_boxes = std::sqrt(squared_distance(a_.box(p.piece), b_.box(q.piece))) * ROUNDED_DOWN<8>;
    return of_boxes >= upper_ ? of_boxes : (std::max)(of_boxes, least_distance(p.region, q.region));
  }

  // How wide a bracket may be for pieces with these errors.
  [[nodiscard]] double width(double error) const { return (std::max)(allowed(), distance_resolution(error, upper_)); }
  [[nodiscard]] bool is_close(double lower, double error) const { return lower >= upper_ - width(error); }
  void leave_out(double lower) { lower_ = (std::min)(lower_, lower); }

  void refine(const Piece& p, const Piece& q, double lower) {
    const double error_p = a_.error(p.piece.segment), error_q = b_.error(q.piece.segment), error = error_p + error_q;
    if (is_close(lower, error)) return leave_out(lower);
    if (const int growth = internal::growth_along(p.piece, q.piece, error); growth != 0)
      return finish_at_end_of_a(p, growth > 0 ? p.piece.first : p.piece.last, q);
    if (const int growth = internal::growth_along(q.piece, p.piece, error); growth != 0)
      return finish_at_end_of_b(q, growth > 0 ? q.piece.first : q.piece.last, p);
    if (finish_convex(p, q)) return;
    if (!limit_.spend()) return give_up(p, q, lower);
    // where the longer one has no double between its ends, points of it are no nearer to each other than it is long:
    // halves of the other one tell no more
    if (is_first_to_halve(p, q, upper_ - lower)) {
      if (const auto parts = halves(a_, p.piece)) return refine_halves_of_a(*parts, p, q);
    } else if (const auto parts = halves(b_, q.piece)) {
      return refine_halves_of_b(*parts, p, q);
    }
    give_up(p, q, lower);
  }
  // The longer one is, as a rule. Where the widths of the regions are most of what the bracket misses, the wider one:
  // a long arc about a tip that hardly has a length is as far from it all along, and its halves tell no more.
  [[nodiscard]] static bool is_first_to_halve(const Piece& p, const Piece& q, double missing) {
    const double width_p = half_width(p.region), width_q = half_width(q.region);
    constexpr double MOST = 2;
    if (missing <= MOST * (width_p + width_q)) return width_p >= width_q;
    return internal::most_length(p.piece, 0) >= internal::most_length(q.piece, 0);
  }
  // Nothing more can be told of this pair, or nothing more is to be.
  void give_up(const Piece& p, const Piece& q, double lower) {
    leave_out(lower);
    if (!found_ || !limit_.is_reached()) look_for_end_of_a(p.piece.segment, p.piece.first, q);
  }
  void refine_halves_of_a(const Spiral_halves_2& h, const Piece& p, const Piece& q) {
    look_for_end_of_a(p.piece.segment, h.first.last, q);
    const Piece parts[2] = {{h.first, a_.region(h.first)}, {h.second, a_.region(h.second)}};
    const double lower[2] = {lower_bound(parts[0], q), lower_bound(parts[1], q)};
    const std::size_t nearer = lower[1] < lower[0] ? 1 : 0;
    for (const std::size_t i : {nearer, 1 - nearer})
      if (lower[i] < upper_) refine(parts[i], q, lower[i]);
  }
  void refine_halves_of_b(const Spiral_halves_2& h, const Piece& p, const Piece& q) {
    look_for_end_of_b(q.piece.segment, h.first.last, p);
    const Piece parts[2] = {{h.first, b_.region(h.first)}, {h.second, b_.region(h.second)}};
    const double lower[2] = {lower_bound(p, parts[0]), lower_bound(p, parts[1])};
    const std::size_t nearer = lower[1] < lower[0] ? 1 : 0;
    for (const std::size_t i : {nearer, 1 - nearer})
      if (lower[i] < upper_) refine(p, parts[i], lower[i]);
  }

  // The nearest point of q to an end of p; the bracket of all pairs with that end.
  double look_for_end_of_a(std::uint32_t segment, const Spiral_sample& end, const Piece& q) {
    const double error = a_.error(segment);
    Closest_search search(b_, end.point, upper_, limit_);
    search.look_at(q.piece, q.region);
    if (const auto r = search.result())
      offer(r->distance.upper + error, {end.point, a_.place_at(segment, end.t)}, {r->point, r->place});
    return search.lower() - error;
  }
  double look_for_end_of_b(std::uint32_t segment, const Spiral_sample& end, const Piece& p) {
    const double error = b_.error(segment);
    Closest_search search(a_, end.point, upper_, limit_);
    search.look_at(p.piece, p.region);
    if (const auto r = search.result())
      offer(r->distance.upper + error, {r->point, r->place}, {end.point, b_.place_at(segment, end.t)});
    return search.lower() - error;
  }
  void finish_at_end_of_a(const Piece& p, const Spiral_sample& end, const Piece& q) {
    leave_out((std::max)(0.0, look_for_end_of_a(p.piece.segment, end, q)));
  }
  void finish_at_end_of_b(const Piece& q, const Spiral_sample& end, const Piece& p) {
    leave_out((std::max)(0.0, look_for_end_of_b(q.piece.segment, end, p)));
  }
  // \return false if the pair may have several nearest points, or its bracket is too wide
  bool finish_convex(const Piece& p, const Piece& q) {
    const double error_p = a_.error(p.piece.segment), error_q = b_.error(q.piece.segment);
    const internal::Pair_convexity convexity(p.piece, q.piece, error_p, error_q);
    if (!(convexity.least > 0)) return false;
    const internal::Pair_newton foot(a_, p.piece, b_, q.piece);
    const Bracket d = foot.bounds(convexity.least);
    offer(d.upper, {foot.a.jet.point, a_.place_at(p.piece.segment, foot.a.t)},
          {foot.b.jet.point, b_.place_at(q.piece.segment, foot.b.t)});
    if (!is_close(d.lower, error_p + error_q)) return false;
    leave_out(d.lower);
    return true;
  }
  void offer(double upper, const Drawing_point<>& a, const Drawing_point<>& b) {
    if (found_ && !(upper < upper_)) return;
    upper_ = upper;
    found_ = {a, b};
  }

  const Curves &a_, &b_;
  double eps_, of_distance_;
  double upper_ = std::numeric_limits<double>::infinity(), lower_ = std::numeric_limits<double>::infinity();
  std::optional<Found> found_;
  std::size_t pairs_ = 0;
  Work_limit limit_;
};

}  // namespace CGAL::Bounding_arcs

#endif
