// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The points of a segment for regions in hand, and how far these regions may be from the exact curve.
//
// A point is C(middle), rounded from twice the digits, and the local polynomial's way from there.  With u = 2^-53, h
// the segment's half length and c_k its Taylor coefficients, each coordinate errs by half an ulp of the largest one for
// C(middle), as much for the last sum, and for the way, by Horner's scheme, (3 k + 1) u |c_k| h^k in its k-th term: one
// of the coefficient, k of sigma, k products and k sums.  The ends of the segment err by half an ulp.
//
// The widening.  A curve piece lies in its region R of exact numbers.  In doubles a side p0 + (p1 - p0) z, z over the
// unit chord, has both ends moved by a vector no longer than e, its joint by rounding, and its bulges changed by db.  A
// point moves by e (|1 - z| + |z|) <= MOST_MOVED e for the first, which each method tells for its regions, and c/2 db
// for the last: two arcs over one chord c are so far from each other.  What lies between the sides moves as they do.
// A joint is p0 + (p1 - p0) z in doubles: half an ulp in each coordinate of the sum, and what the product errs by is
// part of what z does.  So the piece is within
//   MOST_MOVED e + 0.71 ulp + what joints and bulges err by
// of R in doubles.
//
// Ends are rounded parameters, up to half an ulp, u / 2 or less, beyond the true cut: the curve beyond it, no longer
// than d = u V / 2 with V >= |C'|, is no part of the spiral.  It is within d of the end, and that end and the
// directions there move the region by less than 2 d: the chord's direction turns by d / c and the tangent's by kappa d
// <= 2 d / c, which is half that in a bulge.  Where regions have osculating circles it matters only that they stay
// nested, that is, beyond vertices: there they stand still, as kappa' = 0, and what touches them moves along.
//
// So the widening is 8 ulp of the largest coordinate for all segments where this leaves room for what joints and
// bulges err by (Bca_arcs.h, Bilens_arcs.h, Spiral_fat_arc_arcs.h), 1 ulp at least. Segments as long as the whole
// drawing may need more, and have as much as leaves 2 ulp, but no more than regions that are made one by one.
// Coarse pieces, whose own size makes bulges err by more, have 64 ulp more, which is nothing beside their thickness:
// made one by one, a tenth of the regions at an eps of 1e-3 would take most of the time.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_INTERNAL_BATCH_ARC_POINTS_H
#define CGAL_BOUNDING_ARCS_2_TREE_INTERNAL_BATCH_ARC_POINTS_H

#include <CGAL/Bounding_arcs_2/number/Xy.h>
#include <CGAL/Bounding_arcs_2/number/number_types.h>
#include <CGAL/Bounding_arcs_2/spiral/Local_curve.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Bounding_arcs::filter {

inline constexpr int WIDENING_ULPS = 8, LEAST_ROOM_ULPS = 1, WIDER_ROOM_ULPS = 2, COARSE_ROOM_ULPS = 64;

/// The points of a segment in doubles, for arcs that are made in batches, and their widening.
struct Arc_points {
  Xy<double> middle;    ///< C(middle)
  Xy<double> unit;      ///< of the local polynomial, mirrored as that is
  double turn = 1;      ///< -1 where arcs turn right in the direction of t
  double widening = 0;  ///< as a rule 8 ulp of the largest coordinate
  double room = -1;     ///< what bulges and joints may err by, in units of the local polynomial; negative: none
};

/// Bounds of a rational curve's weights in the segment: the least and the largest of their Bernstein coefficients.
struct Weights {
  double least, most;
};
[[nodiscard]] inline Weights weights_of(const Local_curve& curve) {
  const int degree = degree_of_kind(curve.kind);
  double c[MAX_RATIONAL_DEGREE + 1],
      power = 1;  // Taylor coefficients about the segment's start, in units of its length
  for (int k = 0; k <= degree; ++k, power *= curve.half) c[k] = curve.form.coefficients.w[k] * power;
  for (int i = 0; i < degree; ++i)
    for (int k = degree - 1; k >= i; --k) c[k] -= c[k + 1];
  power = 1;
  for (int k = 0; k <= degree; ++k, power *= 2) c[k] *= power;
  Weights w{HUGE_VAL, 0};
  for (int i = 0; i <= degree; ++i) {
    double sum = 0, ratio = 1;  // binomial(i, k) / binomial(degree, k)
    for (int k = 0; k <= i; ++k) {
      sum += ratio * c[k];
      ratio = ratio * (i - k) / (degree - k > 0 ? degree - k : 1);
    }
    w = {(std::min)(w.least, sum), (std::max)(w.most, sum)};
  }
  return w;
}

/// \param at_middle C(curve.middle), each coordinate within half an ulp and less
/// \param most_widening that of regions made one by one: there is no room where more is needed
/// \tparam Arcs of the regions to be made
template <class Arcs>
[[nodiscard]] Arc_points arc_points(const Local_curve& curve, const Xy<double>& at_middle, double coordinate_size,
                                    double most_widening) {
  constexpr double U = Local_precision<double>::HALF_ULP, OF_JOINTS = Arcs::HAS_JOINTS ? 0.71 : 0;
  const auto& c = curve.form.coefficients;
  const bool is_rational = is_rational_kind(curve.kind);
  Xy<double> most, way, speed;  // bounds of the numerator, its error in u, and its derivative
  double weight_error = 0, weight_speed = 0, power = 1;
  for (int k = 1; k <= degree_of_kind(curve.kind); ++k) {
    const double errors = 3 * k + 1, x = std::fabs(c.x[k]) * power, y = std::fabs(c.y[k]) * power;
    speed = {speed.x + k * x, speed.y + k * y};
    most = {most.x + x * curve.half, most.y + y * curve.half};
    way = {way.x + errors * (x * curve.half), way.y + errors * (y * curve.half)};
    if (is_rational) {
      const double w = std::fabs(c.w[k]) * power;
      weight_speed += k * w;
      weight_error += errors * (w * curve.half);
    }
    power *= curve.half;
  }
  if (is_rational) {
    constexpr double SLACK = 1 + 0x1p-20;  // for second order
    const Weights weights = weights_of(curve);
    const double inverse = SLACK / weights.least, of_weight = (weight_error + weights.most) * inverse + 1;
    way = {inverse * (way.x + most.x * of_weight), inverse * (way.y + most.y * of_weight)};
    weight_speed *= inverse;
    speed = {inverse * (speed.x + most.x * weight_speed), inverse * (speed.y + most.y * weight_speed)};
  }
  const double unit = curve.form.unit, ulp = ulp_of(coordinate_size), ex = ulp + U * (way.x * unit),
               ey = ulp + U * (way.y * unit),
               points = Arcs::MOST_MOVED * std::sqrt(ex * ex + ey * ey) + OF_JOINTS * ulp,
               beyond = U * (std::sqrt(speed.x * speed.x + speed.y * speed.y) * unit);
  const double needed = points + beyond, usual = WIDENING_ULPS * ulp;
  const double widening = usual - needed >= LEAST_ROOM_ULPS * ulp ? usual : needed + WIDER_ROOM_ULPS * ulp;
  Arc_points r{at_middle, {unit, curve.mirror * unit}, curve.direction * curve.mirror, widening, -1};
  constexpr double LEAST = 0x1p-900, MOST = 0x1p900;  // between which C(middle) is that accurate
  if (coordinate_size >= LEAST && coordinate_size <= MOST && (widening == usual || widening <= most_widening))
    r.room = (widening - needed) / unit;
  return r;
}

}  // namespace CGAL::Bounding_arcs::filter

#endif
