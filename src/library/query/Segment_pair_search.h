// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Common points of two segments in doubles.

#ifndef BOUNDING_ARCS_LIBRARY_QUERY_SEGMENT_PAIR_SEARCH_H
#define BOUNDING_ARCS_LIBRARY_QUERY_SEGMENT_PAIR_SEARCH_H

#include "../curve/exact_bezier.h"
#include "../tree/Segment_hierarchy.h"
#include "Newton_box.h"
#include "join_intersections.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

/// Proves each common point of two spiral segments, or tells the parameters between which doubles leave it open.
///
/// Pieces A and B are apart, or their tangents are nowhere parallel, or one is halved.
///
///  * Tangents nowhere parallel: they meet at most once, as a chord between two common points would have a direction of
///    both.  Newton's steps lead to a point, where a root is proven to be (Newton_box.h), or none on the pieces.
///  * A common end P is a common point.  With tangents nowhere parallel it is the only one.  It is, too, where A
///    backwards and then B run ahead in one direction u all the way, T.u > 0: such a path does not meet itself.
/// \tparam Curves Segment_hierarchy, or one that has regions of another kind
template <class Curves> class Segment_pair_search {
  using Pair = std::pair<std::uint32_t, std::uint32_t>;  // of Bezier pieces, numbered through
  using Piece = Piece_in_hand<typename Curves::Region>;

 public:
  /// \param is_self whether both are one
  Segment_pair_search(const Curves& a, const Curves& b, bool is_self)
      : a_(a), b_(b), joints_a_(a), joints_b_(b), is_self_(is_self) {}

  /// Finds the common points of two segments, each proven, or the parameters where doubles leave it open.
  void look_at(std::uint32_t segment_a, std::uint32_t segment_b) {
    error_ = a_.error(segment_a) + b_.error(segment_b);
    budget_ = MOST_PAIRS;
    const auto of_a = a_.region(segment_a), of_b = b_.region(segment_b);  // most are apart, and need no pieces
    if (!are_apart(of_a, of_b)) refine({directed(a_, segment_a), of_a}, {directed(b_, segment_b), of_b});
  }
  /// Takes a common end of pieces.
  void add_common_end(std::uint32_t i, double t, std::uint32_t j, double s) {
    if (!is_end(t) || !is_end(s)) return;  // a cut of one piece, or of two with the same numbers
    const Pair beziers{a_.bezier_of(i), b_.bezier_of(j)};
    if (is_self_ && is_joint_of_neighbours(beziers, {t, t}, {s, s})) return;
    ends_.push_back({beziers, {{t, t}, {s, s}}});
  }

  /// Roots in boxes, which may reach over ends of pieces.
  [[nodiscard]] std::vector<internal::Newton_box>& roots() { return roots_; }
  [[nodiscard]] const std::vector<internal::Newton_box>& roots() const { return roots_; }
  /// Parameters between which may be common points that doubles do not tell.
  [[nodiscard]] const std::vector<Numbered_point>& open() const { return open_; }
  /// Common ends.
  [[nodiscard]] const std::vector<Numbered_point>& ends() const { return ends_; }

  [[nodiscard]] const Curve_joints& joints_a() const { return joints_a_; }
  [[nodiscard]] const Curve_joints& joints_b() const { return joints_b_; }
  [[nodiscard]] bool is_joint_of_neighbours(const Pair& beziers, const Bracket& t, const Bracket& s) const {
    if (!t.is_single() || !is_end(t.lower) || !s.is_single() || !is_end(s.lower)) return false;
    const Joint_place at_a = joints_a_.place(beziers.first, t), at_b = joints_b_.place(beziers.second, s);
    return at_a.bezier == at_b.bezier && at_a.t.lower == at_b.t.lower;
  }
  /// Whether segments are of Bezier pieces with the same numbers, of different drawings or at different places of one.
  [[nodiscard]] bool is_same_piece(std::uint32_t i, std::uint32_t j) const {
    const std::uint32_t bezier_a = a_.bezier_of(i), bezier_b = b_.bezier_of(j);
    if (is_self_ && bezier_a == bezier_b) return false;
    const auto& p = a_.bezier(bezier_a);
    const auto& q = b_.bezier(bezier_b);
    if (!(p.control_points() == q.control_points()) || p.weights() != q.weights()) return false;
    if (a_.rounding(bezier_a) == 0 && b_.rounding(bezier_b) == 0) return true;
    const auto exact_p = a_.exact_bezier(bezier_a), exact_q = b_.exact_bezier(bezier_b);
    return exact_p.control_points() == exact_q.control_points() && exact_p.weights() == exact_q.weights();
  }

 private:
  [[nodiscard]] static bool is_end(double t) { return t == 0 || t == 1; }
  static constexpr int MOST_PAIRS = 400;  // halvings that a tangency within 2^-40 takes, twice

  // A segment as long as a cut is wide does not tell its directions at its ends. All of them are near the one in its
  // middle, as C'' has a bound.
  [[nodiscard]] static Spiral_piece_2 directed(const Curves& curves, std::uint32_t segment) {
    Spiral_piece_2 piece = curves.piece(segment);
    if (std::isfinite(tangent_error(piece.first, piece.last))) return piece;
    const std::uint32_t bezier = curves.bezier_of(segment);
    const Bezier_evaluator& curve = curves.evaluator(bezier);
    const double rounding = curves.rounding(bezier), span = piece.last.t - piece.first.t, t = piece.first.t + span / 2;
    const internal::Curve_jet jet = curve(t);
    const double speed = euclidean_norm(jet.first), error = curve.errors_at(t, jet).first,
                 change = span * (curve.second_bound() + curve.second_change(rounding));
    constexpr double MOST = 0.25;  // a cone that is told apart from others
    const double share = (error + curve.first_change(rounding, error) + change) / speed;
    if (!(share <= MOST)) return piece;
    // vectors that differ by that share of one of them differ by less than (1 + share^2) times as much as directions
    const double room = share * (1 + share * share) * (1 + 0x1p-40) + 4 * HALF_ULP;
    for (Spiral_sample* end : {&piece.first, &piece.last}) {
      end->tangent = (1 / speed) * jet.first;
      end->tangent_error = room;
    }
    return piece;
  }

  void leave_open(const Piece& a, const Piece& b) {
    open_.push_back(
        {{a_.bezier_of(a.piece.segment), b_.bezier_of(b.piece.segment)},
         {{a.piece.first.t, a.piece.last.t}, {b.piece.first.t, b.piece.last.t}, Intersection_kind::UNDECIDED}});
  }

  // \pre they are not apart
  void refine(const Piece& a, const Piece& b) {
    const Cones cones(a.piece, b.piece);
    if (is_settled_at_end(a.piece, b.piece, cones)) return;
    if (cones.are_transversal && is_settled_by_newton(a, b)) return;
    const Xy<double> chord_a = a.piece.last.point - a.piece.first.point,
                     chord_b = b.piece.last.point - b.piece.first.point;
    const double size_a = dot(chord_a, chord_a), size_b = dot(chord_b, chord_b);
    constexpr double LEAST = 64;  // times the errors: pieces that are no longer are points as far as doubles tell
    const double least = LEAST * error_;
    if (--budget_ < 0 || (std::max)(size_a, size_b) < least * least) return leave_open(a, b);
    const bool of_a = size_a >= size_b;
    const Piece& longer = of_a ? a : b;
    const Curves& curves = of_a ? a_ : b_;
    const auto middle = halves(curves, longer.piece);
    if (!middle) return leave_open(a, b);
    for (const Spiral_piece_2* half : {&middle->first, &middle->second}) {
      const Piece part{*half, curves.region(*half)};
      const Piece &first = of_a ? part : a, &second = of_a ? b : part;
      if (!are_apart(first.region, second.region)) refine(first, second);
    }
  }

  // How the tangents of two pieces, each in the cone between its ends', which is less than half a turn wide, lie.
  struct Cones {
    const Spiral_piece_2 &a, &b;
    double room;
    bool are_transversal;

    Cones(const Spiral_piece_2& first, const Spiral_piece_2& second) : a(first), b(second) {
      room = tangent_error(a.first, a.last) + tangent_error(b.first, b.last) + TANGENT_ROUNDING;
      const double c00 = cross(a.first.tangent, b.first.tangent), c01 = cross(a.first.tangent, b.last.tangent),
                   c10 = cross(a.last.tangent, b.first.tangent), c11 = cross(a.last.tangent, b.last.tangent);
      are_transversal = (std::min)((std::min)(c00, c01), (std::min)(c10, c11)) > room ||
                        (std::max)((std::max)(c00, c01), (std::max)(c10, c11)) < -room;
    }
    // Whether A away from its end and B away from its one run ahead in opposite directions.
    [[nodiscard]] bool run_apart(double sign_a, double sign_b) const {
      const Xy<double> a0 = -sign_a * a.first.tangent, a1 = -sign_a * a.last.tangent, b0 = sign_b * b.first.tangent,
                       b1 = sign_b * b.last.tangent;
      const Xy<double> ahead = (a0 + a1) + (b0 + b1);
      return (std::min)((std::min)(dot(ahead, a0), dot(ahead, a1)), (std::min)(dot(ahead, b0), dot(ahead, b1))) >
             4 * room;
    }
  };

  [[nodiscard]] bool is_settled_at_end(const Spiral_piece_2& a, const Spiral_piece_2& b, const Cones& cones) {
    for (const bool at_a : {false, true})
      for (const bool at_b : {false, true}) {
        const Spiral_sample &p = at_a ? a.last : a.first, &q = at_b ? b.last : b.first;
        if (!(p.point == q.point) || !is_same_end(a.segment, p.t, b.segment, q.t)) continue;
        if (!cones.are_transversal && !cones.run_apart(at_a ? -1 : 1, at_b ? -1 : 1)) return false;
        add_common_end(a.segment, p.t, b.segment, q.t);
        return true;
      }
    return false;
  }

  // \pre tangents are nowhere parallel
  [[nodiscard]] bool is_settled_by_newton(const Piece& a, const Piece& b) {
    const auto of = [](const Segment_hierarchy& curves, const Spiral_piece_2& p) {
      const std::uint32_t bezier = curves.bezier_of(p.segment);
      return internal::Newton_piece{
          curves.evaluator(bezier), curves.rounding(bezier), bezier, p.first.t, p.last.t, p.first.point, p.last.point};
    };
    const double t0 = a.piece.first.t, t1 = a.piece.last.t, s0 = b.piece.first.t, s1 = b.piece.last.t;
    const std::optional<internal::Newton_box> root = internal::newton_box(of(a_, a.piece), of(b_, b.piece));
    if (!root) return false;
    if (has_common_end(*root, a.piece.segment, b.piece.segment)) return root->is_unique_on(t0, t1, s0, s1);
    if (root->is_on(t0, t1, s0, s1)) {
      roots_.push_back(*root);
      return true;
    }
    return root->is_unique_on(t0, t1, s0, s1);
  }

  // Whether the only root in a box is a common end, which the pieces at that end tell.
  [[nodiscard]] bool has_common_end(const internal::Newton_box& root, std::uint32_t segment_a,
                                    std::uint32_t segment_b) const {
    if (root.is_inside()) return false;
    const auto end_of = [](const Curves& curves, std::uint32_t segment, double t) {
      const auto& p = curves.bezier(curves.bezier_of(segment)).control_points();
      Spiral_sample end;
      end.t = t;
      end.point = t == 0 ? p.front() : p.back();
      return end;
    };
    for (const double t : {0.0, 1.0})
      for (const double s : {0.0, 1.0}) {
        const Spiral_sample p = end_of(a_, segment_a, t), q = end_of(b_, segment_b, s);
        if (root.is_on(t, t, s, s) && p.point == q.point && is_same_end(segment_a, t, segment_b, s)) return true;
      }
    return false;
  }

  // Whether C_i(t) and C_j(s) are one point: both at ends of Bezier pieces, or the same cut of the same piece.
  [[nodiscard]] bool is_same_end(std::uint32_t i, double t, std::uint32_t j, double s) const {
    const bool is_one = is_self_ && a_.bezier_of(i) == b_.bezier_of(j);
    if (t == s && (is_one || is_same_piece(i, j))) return true;
    if (!is_end(t) || !is_end(s)) return false;
    const std::uint32_t bezier_a = a_.bezier_of(i), bezier_b = b_.bezier_of(j);
    if (a_.rounding(bezier_a) == 0 && b_.rounding(bezier_b) == 0) return true;  // as their doubles are
    const auto p = a_.exact_bezier(bezier_a).control_points(), q = b_.exact_bezier(bezier_b).control_points();
    return (t == 0 ? p.front() : p.back()) == (s == 0 ? q.front() : q.back());
  }

  const Curves &a_, &b_;
  Curve_joints joints_a_, joints_b_;
  bool is_self_;
  double error_ = 0;  // of the two segments that are looked at
  int budget_ = 0;
  std::vector<internal::Newton_box> roots_;
  std::vector<Numbered_point> open_, ends_;
};

}  // namespace CGAL::Bounding_arcs

#endif
