// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Length of a part of a Bezier piece: its speed integrated by 16 nodes (Gauss), with a certified bound of what that
// misses.
//
// With t = m + h s, the part is over s in [-1, 1].  Seen from C(m) and with its weight in m as 1, the piece is N / W,
// W(0) = 1, and its speed |H| / W^2 with H = N' W - N W'.  Let a_k, w_k bound the coefficients of s^k in N and W, and
//   A = a_1 R + a_2 R^2 + ...,  V = w_1 R + w_2 R^2 + ....
// For complex s with |s| <= R,  |H(s) - H(0)| <= A' (1 + V) + A V' - a_1  and  |W(s) - 1| <= V.  Where the former is at
// most 3/4 of c = |H(0)|, the speed in m, and the latter at most 1/4, neither vanishes and so the root of H times its
// conjugate is analytic; |H| / W^2 is at most (7/4 c) / (3/4)^2 < 4 c.  The ellipse about -1 and 1 with the half axis R
// has a sum of half axes r = R + sqrt(R^2 - 1), and with |speed| <= M in it Chebyshev coefficients are at most
// 2 M r^-k (Bernstein, 1912).  Sixteen nodes are exact up to s^31, a term is integrated and summed up to 2 at most
// each:
//   |error| <= sum over k >= 32 of 4 * 2 M r^-k = 8 M r^-32 / (1 - 1 / r) <= 32 c r^-32 / (1 - 1 / r).

#ifndef BOUNDING_ARCS_LIBRARY_QUERY_SPEED_INTEGRAL_H
#define BOUNDING_ARCS_LIBRARY_QUERY_SPEED_INTEGRAL_H

#include <CGAL/Bounding_arcs_2/query/internal/Foot.h>
#include <CGAL/Bounding_arcs_2/tree/Segment_hierarchy.h>
#include "Lens.h"

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

namespace CGAL::Bounding_arcs::internal {

/// Integrates the speed of one Bezier piece, over the parts of it that are asked about.
class Speed_integral {
 public:
  Speed_integral(const Segment_hierarchy& curves, std::uint32_t bezier)
      : curve_(curves.evaluator(bezier)), speed_error_(derivative_error(curves, bezier)) {
    // nodes and where they are round by 4 u of the parameter
    speed_error_ += 4 * HALF_ULP * curve_.second_bound();
    bound_coefficients(curves.bezier(bezier));
  }

  /// \return nothing where the speed changes too much
  [[nodiscard]] std::optional<Bracket> over(double t0, double t1) const {
    const double h = (t1 - t0) / 2, middle = t0 + h;
    const Speed speed = speed_at(middle);
    const double share = missed_share(speed, h);
    if (!(share <= MOST_SHARE)) return std::nullopt;
    double sum = 0;
    for (const auto& [x, weight] : NODES)
      sum += weight * (euclidean_norm(curve_(middle - h * x).first) + euclidean_norm(curve_(middle + h * x).first));
    const double length = h * sum, room = share * (2 * h) * (speed.norm + speed_error_) + floor(t0, t1, length);
    return Bracket{(std::max)(0.0, length - room), length + room};
  }
  /// An upper bound of the length: the speed in the middle, and what it may change by.
  [[nodiscard]] double most(double t0, double t1) const {
    const double h = (t1 - t0) / 2;
    return 2 * h * (euclidean_norm(curve_(t0 + h).first) + speed_error_ + h * curve_.second_bound()) * ROUNDED_UP<16>;
  }
  /// What rounding leaves open of a part, to each side: 2 u of each norm, of sums and products less than 24.
  [[nodiscard]] double floor(double t0, double t1, double length) const {
    return ((t1 - t0) * speed_error_ + 32 * HALF_ULP * length) * ROUNDED_UP<16>;
  }

 private:
  struct Node {
    double x, weight;
  };
  static constexpr Node NODES[] = {
      {0.9894009349916499326, 0.02715245941175409485}, {0.9445750230732325761, 0.06225352393864789286},
      {0.8656312023878317439, 0.09515851168249278481}, {0.7554044083550030339, 0.1246289712555338721},
      {0.6178762444026437484, 0.1495959888165767321},  {0.4580167776572273863, 0.1691565193950025382},
      {0.2816035507792589132, 0.1826034150449235889},  {0.09501250983763744019, 0.1894506104550684963}};
  // An ellipse: the half axis R, and a share of the half length that is at least 16 r^-32 / (1 - 1 / r).
  struct Ellipse {
    double half_axis, share;
  };
  static constexpr Ellipse ELLIPSES[] = {{4, 4e-28}, {3, 7e-24}, {2, 1.1e-17}, {1.5, 1.1e-12}, {1.25, 7.5e-9}};
  static constexpr double MOST_SHARE = 1e-8;
  // The speed at a parameter.
  struct Speed {
    double norm, weight;
  };

  // Bounds a_k and w_k for h = 1 and no scaling of weights: differences of order k of coefficients, times binomials.
  // Seen from C(m), which is no farther from the first control point than one of them, coefficients have that distance
  // times those of W more.
  void bound_coefficients(const Bezier_curve_2<double>& curve) {
    const auto& p = curve.control_points();
    const std::size_t n = p.size() - 1;
    boost::container::small_vector<Xy<double>, 4> numerator;
    double farthest = 0, size = 0, binomial = 1;
    for (std::size_t i = 0; i <= n; ++i) {
      const double w = curve.weight(static_cast<int>(i));
      weights_.push_back(w);
      numerator.push_back(w * (p[i] - p[0]));
      farthest = (std::max)(farthest, euclidean_norm(p[i] - p[0]));
      size = (std::max)(size, w);
    }
    auto differences = weights_;
    double rounding = 4 * HALF_ULP * size;  // over `farthest` or 1; twice as much in each difference
    for (std::size_t k = 1; k <= n; ++k) {
      double of_numerator = 0, of_weight = 0;
      for (std::size_t i = 0; i + k <= n; ++i) {
        numerator[i] = numerator[i + 1] - numerator[i];
        differences[i] = differences[i + 1] - differences[i];
        of_numerator = (std::max)(of_numerator, euclidean_norm(numerator[i]));
        of_weight = (std::max)(of_weight, std::fabs(differences[i]));
      }
      binomial = binomial * static_cast<double>(n + 1 - k) / static_cast<double>(k);
      rounding *= 2;
      const bool is_rational = curve.is_rational();
      const double w = is_rational ? of_weight + rounding : 0;
      constexpr double UP = 1 + 0x1p-40;
      numerator_.push_back(binomial * (of_numerator + (w + rounding) * farthest) * UP);
      denominator_.push_back(binomial * w * UP);
    }
  }
  [[nodiscard]] Speed speed_at(double t) const {
    auto w = weights_;
    if (curve_.is_rational())
      for (std::size_t k = w.size(); k-- > 1;)
        for (std::size_t i = 0; i < k; ++i) w[i] = (1 - t) * w[i] + t * w[i + 1];
    return {euclidean_norm(curve_(t).first), w.front()};
  }

  // The share of the widest ellipse that the speed is analytic in; infinite if there is none. A' and so on are over h.
  [[nodiscard]] double missed_share(const Speed& speed, double h) const {
    constexpr double DOWN = 1 - 0x1p-40;
    const double least_weight = speed.weight * DOWN, least_speed = (speed.norm - speed_error_) * DOWN;
    for (const Ellipse& e : ELLIPSES) {
      const double x = h * e.half_axis;
      double a = 0, a_slope = 0, v = 0, v_slope = 0, power = 1;
      for (std::size_t k = 0; k < numerator_.size(); ++k, power *= x) {
        const double order = static_cast<double>(k + 1);
        a += numerator_[k] * power * x;
        a_slope += order * numerator_[k] * power;
        v += denominator_[k] * power * x;
        v_slope += order * denominator_[k] * power;
      }
      const double change = (a_slope - numerator_[0] + (a_slope * v + a * v_slope) / least_weight) / least_weight;
      if (change <= 0.75 * least_speed && v <= 0.25 * least_weight) return e.share;
    }
    return std::numeric_limits<double>::infinity();
  }

  const Bezier_evaluator& curve_;
  double speed_error_;
  boost::container::small_vector<double, 4> weights_, numerator_, denominator_;  // the latter from order 1 on
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
