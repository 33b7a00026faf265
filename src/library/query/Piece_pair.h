// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
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

#ifndef BOUNDING_ARCS_LIBRARY_QUERY_PIECE_PAIR_H
#define BOUNDING_ARCS_LIBRARY_QUERY_PIECE_PAIR_H

#include <CGAL/Bounding_arcs_2/query/internal/Foot.h>
#include <CGAL/Bounding_arcs_2/region/Fat_arc_2.h>
#include <CGAL/Bounding_arcs_2/tree/Segment_hierarchy.h>

#include <algorithm>
#include <cmath>

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

#endif
