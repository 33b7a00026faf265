// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Common points of two spiral segments in doubles, each proven, or the parameters where doubles leave it open.
//
// Pieces A and B are apart, or their tangents are nowhere parallel, or one is halved.
//
//  * Tangents nowhere parallel: they meet at most once, as a chord between two common points would have a direction of
//    both.  Newton's steps lead to a point, where a root is proven to be (Newton_box.h), or none on the pieces.
//  * A common end P is a common point.  With tangents nowhere parallel it is the only one.  It is, too, where A
//    backwards and then B run ahead in one direction u all the way, T.u > 0: such a path does not meet itself.

#ifndef BOUNDING_ARCS_LIBRARY_QUERY_PAIR_SEARCH_H
#define BOUNDING_ARCS_LIBRARY_QUERY_PAIR_SEARCH_H

#include "../tree/Segment_hierarchy.h"
#include "Newton_box.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// Parameters of both pieces between which common points may be that doubles do not tell.
struct Open_pair {
  std::uint32_t a, b;  ///< segments
  double a0, a1, b0, b1;
};

/// What has been found so far, of all pairs of segments.
struct Pair_results {
  std::vector<Newton_box> roots;
  std::vector<Open_pair> open;
};

/// Whether two ends of pieces are one point for certain, told by the curves's owner: which parameter of which segment.
/// \tparam SameEnd bool(Spiral_sample of a, Spiral_sample of b)
/// \tparam Common void(Spiral_sample of a, Spiral_sample of b): takes a common end
/// \tparam Curves Segment_hierarchy, or one that has regions of another kind
template <class Curves, class SameEnd, class Common> class Pair_search {
  using Piece = Piece_in_hand<typename Curves::Region>;

 public:
  Pair_search(const Curves& a, const Curves& b, const SameEnd& same_end, const Common& common, Pair_results& results)
      : a_(a), b_(b), same_end_(same_end), common_(common), results_(results) {}

  void operator()(std::uint32_t segment_a, std::uint32_t segment_b) {
    pair_ = {segment_a, segment_b};
    error_ = a_.error(segment_a) + b_.error(segment_b);
    budget_ = MOST_PAIRS;
    const auto of_a = a_.region(segment_a), of_b = b_.region(segment_b);  // most are apart, and need no pieces
    if (!are_apart(of_a, of_b)) refine({a_.piece(segment_a), of_a}, {b_.piece(segment_b), of_b});
  }

 private:
  static constexpr int MOST_PAIRS = 400;  // halvings that a tangency within 2^-40 takes, twice

  void leave_open(const Piece& a, const Piece& b) {
    results_.open.push_back(
        {a.piece.segment, b.piece.segment, a.piece.first.t, a.piece.last.t, b.piece.first.t, b.piece.last.t});
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
        if (!(p.point == q.point) || !same_end_(a.segment, p, b.segment, q)) continue;
        if (!cones.are_transversal && !cones.run_apart(at_a ? -1 : 1, at_b ? -1 : 1)) return false;
        common_(a.segment, p, b.segment, q);
        return true;
      }
    return false;
  }

  // \pre tangents are nowhere parallel
  [[nodiscard]] bool is_settled_by_newton(const Piece& a, const Piece& b) {
    const auto of = [](const Segment_hierarchy& curves, const Spiral_piece_2& p) {
      const std::uint32_t bezier = curves.bezier_of(p.segment);
      return Newton_piece{
          curves.evaluator(bezier), curves.rounding(bezier), bezier, p.first.t, p.last.t, p.first.point, p.last.point};
    };
    const double t0 = a.piece.first.t, t1 = a.piece.last.t, s0 = b.piece.first.t, s1 = b.piece.last.t;
    const std::optional<Newton_box> root = newton_box(of(a_, a.piece), of(b_, b.piece));
    if (!root) return false;
    if (root->is_on(t0, t1, s0, s1)) {
      results_.roots.push_back(*root);
      return true;
    }
    return root->is_unique_on(t0, t1, s0, s1);
  }

  struct Pair {
    std::uint32_t a, b;
  };
  const Curves &a_, &b_;
  const SameEnd& same_end_;
  const Common& common_;
  Pair_results& results_;
  Pair pair_{};
  double error_ = 0;
  int budget_ = 0;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
