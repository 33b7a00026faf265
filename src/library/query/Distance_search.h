// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The search for the nearest points of two drawings.
//
// Pairs of boxes, then of regions leave out what is too far.  A pair of pieces that is left is done when distances
// grow all along one of them, whose end then is nearest, or when the squared distance is convex (see below); else
// the longer one is halved, and its new end is looked for on the other, which keeps pairs of coincident pieces apart
// from those that have something to tell.  Lower bounds of pairs of arcs are within a multiple of the cube of their
// length, so that parallel curves, where nothing is convex, end at the cube root of the tolerance.

#ifndef BOUNDING_ARCS_LIBRARY_QUERY_DISTANCE_SEARCH_H
#define BOUNDING_ARCS_LIBRARY_QUERY_DISTANCE_SEARCH_H

#include <CGAL/Bounding_arcs_2/query/Query_point.h>
#include <CGAL/Bounding_arcs_2/region/Fat_arc_2.h>
#include "../tree/Segment_hierarchy.h"
#include "Closest_search.h"
#include "Foot.h"
#include "query_units.h"

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

/// One of two curves: where a step is in its range.
class Newton_side {
 public:
  Newton_side(const Segment_hierarchy& curves, const Spiral_piece_2& piece)
      : curve_(curves.evaluator(curves.bezier_of(piece.segment))),
        rounding_(curves.rounding(curves.bezier_of(piece.segment))), first_(piece.first), last_(piece.last),
        error(curves.error(piece.segment)), low_(piece.first.t), high_(piece.last.t), t(low_ + (high_ - low_) / 2) {}

  void evaluate() {
    jet = jet_of_piece(curve_, first_, last_, t);
    speed = euclidean_norm(jet.first);
    first_error_ = derivative_error(curve_, rounding_, t, jet);
  }
  /// \param way from the other curve's point
  void look(const Xy<double>& way) {
    slope = dot(way, jet.first);
    rate = speed * speed + dot(way, jet.second);
    is_pinned = (t == low_ && slope >= 0) || (t == high_ && slope <= 0);
    noise = is_moving() ? euclidean_norm(way) * (first_error_ / least_speed() + 8 * HALF_ULP) : 0;
  }
  /// The amount by which f may fall along the curve per length at least; all is unknown where the curve has no
  /// direction.
  [[nodiscard]] double fall(double error_of_points) const {
    return (is_pinned ? 0 : std::fabs(slope) / least_speed()) + noise + error_of_points;
  }
  [[nodiscard]] bool move(double by) {
    const double before = t;
    t = (std::min)((std::max)(t + by, low_), high_);
    return t != before;
  }
  [[nodiscard]] double least_speed() const { return speed * ROUNDED_DOWN<8> - first_error_; }
  [[nodiscard]] bool is_moving() const { return least_speed() > 0; }

 private:
  const Bezier_evaluator& curve_;
  double rounding_, first_error_ = 0;
  const Spiral_sample &first_, &last_;

 public:
  double error;

 private:
  double low_, high_;

 public:
  double t, speed = 0, slope = 0, rate = 0, noise = 0;
  bool is_pinned = false;
  Curve_jet jet;
};

/// The nearest points of two pieces over which the squared distance is strictly convex: Newton's steps, held in the
/// rectangle of both parameters.
///
/// Where half the second derivatives by the arc lengths are at least m, f is at least f0 + 2 g.x + m |x|^2, and that is
/// at least f0 - |g|^2 / m, where components of g by which no x in the rectangle makes f fall are left out: so the
/// bracket does not hang on how well the steps converged.
class Pair_newton {
 public:
  Pair_newton(const Segment_hierarchy& curves_a, const Spiral_piece_2& piece_a, const Segment_hierarchy& curves_b,
              const Spiral_piece_2& piece_b)
      : a(curves_a, piece_a), b(curves_b, piece_b) {
    constexpr int MOST_STEPS = 40;
    for (int step = 0; step < MOST_STEPS; ++step) {
      look();
      if (!a.is_moving() || !b.is_moving() || is_done() || !make_step()) return;
    }
    look();
  }

  /// Bounds of the least distance. \param least a positive number, at most the least eigenvalue
  [[nodiscard]] Bracket bounds(double least) const {
    const double error = a.error + b.error, room = error + 4 * HALF_ULP * distance;
    if (!a.is_moving() || !b.is_moving()) return {0, distance + room};
    const double fall_a = a.fall(error), fall_b = b.fall(error), square = distance * distance;
    const double drop = (fall_a * fall_a + fall_b * fall_b) / least;
    const double beside = drop < square ? drop / (distance + std::sqrt(square - drop)) : distance;
    return {(std::max)(0.0, distance - beside * ROUNDED_UP<8> - room), distance + room};
  }

  Newton_side a, b;
  double distance = 0;

 private:
  void look() {
    a.evaluate();
    b.evaluate();
    const Xy<double> way = a.jet.point - b.jet.point;
    a.look(way);
    b.look(-way);
    distance = euclidean_norm(way);
  }
  [[nodiscard]] bool is_done() const {
    const auto is_zero = [&](const Newton_side& x) {
      return x.is_pinned || std::fabs(x.slope) <= x.speed * (x.noise + a.error + b.error);
    };
    return is_zero(a) && is_zero(b);
  }
  [[nodiscard]] bool make_step() {
    const double mixed = -dot(a.jet.first, b.jet.first), determinant = a.rate * b.rate - mixed * mixed;
    double da = 0, db = 0;
    if (!a.is_pinned && !b.is_pinned && a.rate > 0 && determinant > 0) {
      da = (mixed * b.slope - b.rate * a.slope) / determinant;
      db = (mixed * a.slope - a.rate * b.slope) / determinant;
    } else {
      const auto alone = [](const Newton_side& x) {
        return x.is_pinned ? 0 : -x.slope / (x.rate > 0 ? x.rate : x.speed * x.speed);
      };
      da = alone(a);
      db = alone(b);
    }
    const bool moves_a = a.move(da), moves_b = b.move(db);
    return moves_a || moves_b;
  }
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
      : curves_{&a, &b}, eps_(eps), of_distance_(of_distance),
        limit_(work_of_pairs(a.number_of_segments() + b.number_of_segments())) {}

  void search() {
    if (a().empty() || b().empty()) return;
    descend({&a().boxes().root(), 0}, {&b().boxes().root(), 0});
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
    Drawing_distance<>::End a, b;
  };
  [[nodiscard]] double allowed() const { return (std::max)(eps_, of_distance_ * upper_); }

  [[nodiscard]] const Curves& a() const { return *curves_[0]; }
  [[nodiscard]] const Curves& b() const { return *curves_[1]; }

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
      const CGAL::Bbox_2 of_p = box(a(), p, k);
      for (std::size_t l = 0; l < size(q); ++l) {
        const double d = squared_distance(of_p, box(b(), q, l));
        ++pairs_;
        if (!(d <= most)) continue;
        std::size_t i = count++;  // nearer ones first
        for (; i > 0 && pairs[i - 1].distance > d; --i) pairs[i] = pairs[i - 1];
        pairs[i] = {d, static_cast<std::uint8_t>(k), static_cast<std::uint8_t>(l)};
      }
    }
    for (std::size_t i = 0; i < count && pairs[i].distance <= most_square(upper_); ++i) {
      if (found_ && !limit_.spend()) return leave_out(std::sqrt(pairs[i].distance) * ROUNDED_DOWN<8>);
      descend(child(a(), p, pairs[i].k), child(b(), q, pairs[i].l));
    }
  }

  void look_at(std::uint32_t i, std::uint32_t j) {
    const Piece p{a().piece(i), a().region(i)}, q{b().piece(j), b().region(j)};
    const double lower = lower_bound(p, q);
    if (lower < upper_) refine(p, q, lower);
  }
  [[nodiscard]] double lower_bound(const Piece& p, const Piece& q) {
    ++pairs_;
    const double of_boxes = std::sqrt(squared_distance(a().box(p.piece), b().box(q.piece))) * ROUNDED_DOWN<8>;
    return of_boxes >= upper_ ? of_boxes : (std::max)(of_boxes, least_distance(p.region, q.region));
  }

  // How wide a bracket may be for pieces with these errors.
  [[nodiscard]] double width(double error) const { return (std::max)(allowed(), distance_resolution(error, upper_)); }
  [[nodiscard]] bool is_close(double lower, double error) const { return lower >= upper_ - width(error); }
  void leave_out(double lower) { lower_ = (std::min)(lower_, lower); }

  void refine(const Piece& p, const Piece& q, double lower) {
    const double error_p = a().error(p.piece.segment), error_q = b().error(q.piece.segment), error = error_p + error_q;
    if (is_close(lower, error)) return leave_out(lower);
    if (const int growth = internal::growth_along(p.piece, q.piece, error); growth != 0)
      return finish_at_end(0, p.piece, growth, q);
    if (const int growth = internal::growth_along(q.piece, p.piece, error); growth != 0)
      return finish_at_end(1, q.piece, growth, p);
    if (finish_convex(p, q)) return;
    if (!limit_.spend()) return give_up(p, q, lower);
    // where the longer one has no double between its ends, points of it are no nearer to each other than it is long:
    // halves of the other one tell no more
    const std::size_t own = is_first_to_halve(p, q, upper_ - lower) ? 0 : 1;
    if (const auto parts = halves(*curves_[own], (own == 0 ? p : q).piece)) return refine_halves(own, *parts, p, q);
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
    if (!found_ || !limit_.is_reached()) look_for_end(0, p.piece.segment, p.piece.first, q);
  }
  void refine_halves(std::size_t own, const Spiral_halves_2& h, const Piece& p, const Piece& q) {
    const Curves& curves = *curves_[own];
    look_for_end(own, h.first.segment, h.first.last, own == 0 ? q : p);
    const Piece parts[2] = {{h.first, curves.region(h.first)}, {h.second, curves.region(h.second)}};
    const auto of_a = [&](std::size_t i) -> const Piece& { return own == 0 ? parts[i] : p; };
    const auto of_b = [&](std::size_t i) -> const Piece& { return own == 0 ? q : parts[i]; };
    const double lower[2] = {lower_bound(of_a(0), of_b(0)), lower_bound(of_a(1), of_b(1))};
    const std::size_t nearer = lower[1] < lower[0] ? 1 : 0;
    for (const std::size_t i : {nearer, 1 - nearer})
      if (lower[i] < upper_) refine(of_a(i), of_b(i), lower[i]);
  }

  // The nearest point of a piece of the other drawing to an end of one of drawing `own`; a lower bound of all pairs
  // with that end.
  double look_for_end(std::size_t own, std::uint32_t segment, const Spiral_sample& end, const Piece& other) {
    const double error = curves_[own]->error(segment);
    Closest_search search(*curves_[1 - own], end.point, upper_, limit_);
    search.look_at(other.piece, other.region);
    if (const auto r = search.result()) {
      const Drawing_distance<>::End at{end.point, curves_[own]->place_at(segment, end.t)}, found{r->point, r->place};
      offer(r->distance.upper + error, own == 0 ? at : found, own == 0 ? found : at);
    }
    return search.lower() - error;
  }
  // No pair is nearer than those with an end of the first piece, the last one where distances fall along it.
  void finish_at_end(std::size_t own, const Spiral_piece_2& piece, int growth, const Piece& other) {
    leave_out((std::max)(0.0, look_for_end(own, piece.segment, growth > 0 ? piece.first : piece.last, other)));
  }
  // \return false if the pair may have several nearest points, or its bracket is too wide
  bool finish_convex(const Piece& p, const Piece& q) {
    const double error_p = a().error(p.piece.segment), error_q = b().error(q.piece.segment);
    const internal::Pair_convexity convexity(p.piece, q.piece, error_p, error_q);
    if (!(convexity.least > 0)) return false;
    const internal::Pair_newton foot(a(), p.piece, b(), q.piece);
    const Bracket d = foot.bounds(convexity.least);
    offer(d.upper, {foot.a.jet.point, a().place_at(p.piece.segment, foot.a.t)},
          {foot.b.jet.point, b().place_at(q.piece.segment, foot.b.t)});
    if (!is_close(d.lower, error_p + error_q)) return false;
    leave_out(d.lower);
    return true;
  }
  void offer(double upper, const Drawing_distance<>::End& a, const Drawing_distance<>::End& b) {
    if (found_ && !(upper < upper_)) return;
    upper_ = upper;
    found_ = {a, b};
  }

  const Curves* curves_[2];  // a and b
  double eps_, of_distance_;
  double upper_ = std::numeric_limits<double>::infinity(), lower_ = std::numeric_limits<double>::infinity();
  std::optional<Found> found_;
  std::size_t pairs_ = 0;
  Work_limit limit_;
};

}  // namespace CGAL::Bounding_arcs

#endif
