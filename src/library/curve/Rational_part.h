// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is between a part of a rational curve and its chord, by integrals along it (Green) in intervals.
//
// With C = N / W, seen from a point O, C x C' = N x N' / W^2, and for the last two points A and B of de Casteljau's
// algorithm in homogeneous coordinates, n their degree, N x N' = n A x B.  Run round O, twice the area and three times
// the first moments are
//   integrals of g = n A x B / W^2 and of C g.
// Over a part, t = (1 + s) / 2, a polynomial with coefficients b_i of Bernstein has for |s| <= R
//   |p(s)| <= P = max |b_i| + sum over k >= 1 of binomial(n, k) max |D^k b| (R / 2)^k,
// where D^k are differences of order k, and |p'(s)| <= P'. Where the sum for W without its first term is at most half
// of the least weight w, it is W >= w / 2 there, and with bounds X and Y of the coordinates of N
//   |g| <= M = (X Y' + Y X') / (w / 2)^2,  |C_x g| <= M X / (w / 2).
// Gauss_rule.h tells what its nodes miss then. Else, and where that is more than rounding, the part is halved.
//
// Differences of order k of a half are means of those of the whole, over 2^k.  In high degrees intervals tell less of
// them: their widths double with each order.

#ifndef BOUNDING_ARCS_LIBRARY_CURVE_RATIONAL_PART_H
#define BOUNDING_ARCS_LIBRARY_CURVE_RATIONAL_PART_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/number/Exact_number.h>
#include <CGAL/Bounding_arcs_2/number/Xy.h>
#include "../polynomial/Gauss_rule.h"
#include "green.h"

#include <CGAL/Interval_nt.h>
#include <CGAL/number_utils.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace CGAL::Bounding_arcs::internal {

/// An area with its first moments, between bounds.
using Bounded_moments = Enclosed_moments<CGAL::Interval_nt<false>>;

/// A part of a rational curve from one parameter to another, which may be the smaller one.
class Rational_part {
 public:
  /// \pre a rational curve
  Rational_part(const Bezier_curve_2<Exact_rational>& curve, double from, double to) {
    const CGAL::Protect_FPU_rounding<true> protection;
    // seen from a control point, which takes no digits from others
    const Xy<double> origin{CGAL::to_double(curve.control_points()[0].x), CGAL::to_double(curve.control_points()[0].y)};
    for (std::size_t i = 0; i < curve.control_points().size(); ++i) {
      const auto& p = curve.control_points()[i];
      const Number w(CGAL::to_interval(curve.weights()[i]));
      const Vector q{Number(CGAL::to_interval(p.x)) - origin.x, Number(CGAL::to_interval(p.y)) - origin.y};
      points_.push_back({w * q, w});
    }
    const double low = (std::min)(from, to), high = (std::max)(from, to);
    if (low > 0) points_ = halves(points_, Number(low)).second;
    if (high < 1) points_ = halves(points_, (Number(high) - low) / (Number(1) - low)).first;
    if (to < from) std::reverse(points_.begin(), points_.end());
    const auto rounded_point = [&](const Homogeneous& p) {
      const Vector q = euclidean(p);
      return Xy<double>{origin.x + CGAL::to_double(q.x), origin.y + CGAL::to_double(q.y)};
    };
    from_ = rounded_point(points_.front());
    to_ = rounded_point(points_.back());
    for (Homogeneous& p : points_) p.n = p.n + p.w * way(from_, origin);
    rounding_ = (std::max)(length(euclidean(points_.front())), length(euclidean(points_.back()) - way(from_, to_)));
  }

  /// Doubles next to where it starts and ends.
  [[nodiscard]] const Xy<double>& from() const { return from_; }
  [[nodiscard]] const Xy<double>& to() const { return to_; }
  /// How far these are from there, at most.
  [[nodiscard]] double rounding() const { return rounding_; }

  /// What is to the left of from(), the part and to() more than to the left of the segment between these two. Moments
  /// are about a point.
  [[nodiscard]] Bounded_moments beside_chord(const Xy<double>& about) const {
    const CGAL::Protect_FPU_rounding<true> protection;
    Bounded_moments m;
    add(points_, nullptr, 0, m);
    const Vector end = euclidean(points_.back()), to = way(from_, to_);
    const Number g = cross(end, to);
    m += {g, (end.x + to.x) / 2 * g, (end.y + to.y) / 2 * g};
    m.area /= 2;
    m.x = m.x / 3 + way(about, from_).x * m.area;
    m.y = m.y / 3 + way(about, from_).y * m.area;
    return m;
  }

 private:
  using Number = CGAL::Interval_nt<false>;
  using Vector = Xy<Number>;
  struct Homogeneous {
    Vector n;
    Number w;
  };
  using Points = boost::container::small_vector<Homogeneous, 4>;

  [[nodiscard]] static Homogeneous between(const Homogeneous& a, const Homogeneous& b, const Number& t) {
    const Number s = Number(1) - t;
    return {s * a.n + t * b.n, s * a.w + t * b.w};
  }
  [[nodiscard]] static Vector way(const Xy<double>& from, const Xy<double>& to) {
    return {Number(to.x) - from.x, Number(to.y) - from.y};
  }
  [[nodiscard]] static double length(const Vector& v) {
    return CGAL::sqrt(CGAL::square(v.x) + CGAL::square(v.y)).sup();
  }
  [[nodiscard]] static Vector euclidean(const Homogeneous& p) { return {p.n.x / p.w, p.n.y / p.w}; }
  [[nodiscard]] static std::pair<Points, Points> halves(Points right, const Number& t) {
    Points left = right;
    for (std::size_t k = 1; k < right.size(); ++k) {
      for (std::size_t i = 0; i + k < right.size(); ++i) right[i] = between(right[i], right[i + 1], t);
      left[k] = right[0];
    }
    return {left, right};
  }

  // The most that differences are in size, by their order.
  using Differences = boost::container::small_vector<double, 4>;
  // \param of_whole those of the part that this one is half of, if there is one
  template <class Coefficient>
  [[nodiscard]] static Differences differences(const Points& points, const Differences* of_whole,
                                               const Coefficient& coefficient) {
    boost::container::small_vector<Number, 4> row;
    for (const Homogeneous& p : points) row.push_back(coefficient(p));
    Differences result;
    for (std::size_t k = 0; k < points.size(); ++k) {
      double most = 0;
      for (const Number& d : row) most = (std::max)(most, CGAL::abs(d).sup());
      if (of_whole != nullptr) most = (std::min)(most, std::ldexp((*of_whole)[k], -static_cast<int>(k)));
      result.push_back(most);
      for (std::size_t i = 0; i + 1 < row.size(); ++i) row[i] = row[i + 1] - row[i];
      row.pop_back();
    }
    return result;
  }
  struct All_differences {
    Differences x, y, w;
  };

  // Bounds of numbers with coefficients of such differences and of their derivatives by s, where |s| <= R.
  struct Bounds {
    Number value, derivative;
  };
  [[nodiscard]] static Bounds bounds(const Differences& most, double half_axis) {
    const std::size_t n = most.size() - 1;
    Bounds result{most[0], 0};
    Number factor(1);  // binomial(n, k) (R / 2)^k
    for (std::size_t k = 1; k <= n; ++k) {
      const auto left = static_cast<double>(n + 1 - k), order = static_cast<double>(k);
      result.derivative += factor * (left / 2 * most[k]);
      factor = factor * left / order * (half_axis / 2);
      result.value += factor * most[k];
    }
    return result;
  }

  // Adds the integrals of g and C g over the part.
  static void add(const Points& points, const All_differences* of_whole, int halvings, Bounded_moments& sum) {
    constexpr Gauss_rule::Ellipse ELLIPSE = Gauss_rule::ELLIPSES[2];
    // those of a parameter, and some, where weights change much; where points are known hardly better than they are far
    // apart, differences of these stay as large, which is nothing then
    constexpr int MOST_HALVINGS = 60, ENOUGH_HALVINGS = 6;
    constexpr double ROUNDING = 0x1p-52;
    double least = points.front().w.inf(), wide = 0, high = 0;
    for (const Homogeneous& p : points) {
      const Vector q = euclidean(p);
      least = (std::min)(least, p.w.inf());
      wide = (std::max)(wide, CGAL::abs(q.x).sup());
      high = (std::max)(high, CGAL::abs(q.y).sup());
    }
    const All_differences own{
        differences(points, of_whole != nullptr ? &of_whole->x : nullptr, [](const Homogeneous& p) { return p.n.x; }),
        differences(points, of_whole != nullptr ? &of_whole->y : nullptr, [](const Homogeneous& p) { return p.n.y; }),
        differences(points, of_whole != nullptr ? &of_whole->w : nullptr, [](const Homogeneous& p) { return p.w; })};
    const Bounds x = bounds(own.x, ELLIPSE.half_axis), y = bounds(own.y, ELLIPSE.half_axis);
    const Number w(least / 2),
        change = bounds(own.w, ELLIPSE.half_axis).value - own.w[0],
        most = (x.value * y.derivative + y.value * x.derivative) / CGAL::square(w) * ELLIPSE.missed;
    const bool is_analytic = change.sup() <= w.inf(),
               is_known = is_analytic && (halvings >= ENOUGH_HALVINGS || most.sup() <= ROUNDING * wide * high);
    if (!is_known && halvings < MOST_HALVINGS) {
      const auto [first, second] = halves(points, Number(0.5));
      add(first, &own, halvings + 1, sum);
      add(second, &own, halvings + 1, sum);
      return;
    }
    if (!is_known) return add_box(points, sum);
    Bounded_moments found;
    for (const Gauss_rule::Node& node : Gauss_rule::NODES) {
      add_node(points, (Number(1) + rounded(node.x)) / 2, rounded(node.weight), found);
      add_node(points, (Number(1) - rounded(node.x)) / 2, rounded(node.weight), found);
    }
    // g is by t here, and half of it by s
    const auto missed = [](const Number& v) { return Number(-v.sup(), v.sup()); };
    sum += {found.area / 2 + missed(most), found.x / 2 + missed(most * (x.value / w)),
            found.y / 2 + missed(most * (y.value / w))};
  }
  // What is written is some digits of the exact number.
  [[nodiscard]] static Number rounded(double x) { return {x * (1 - 0x1p-52), x * (1 + 0x1p-52)}; }
  static void add_node(const Points& points, const Number& t, const Number& weight, Bounded_moments& sum) {
    Points p = points;
    for (std::size_t n = p.size() - 1; n > 1; --n)
      for (std::size_t i = 0; i < n; ++i) p[i] = between(p[i], p[i + 1], t);
    add_values(p[0], p[1], between(p[0], p[1], t), static_cast<double>(points.size() - 1), weight, sum);
  }
  static void add_values(const Homogeneous& a, const Homogeneous& b, const Homogeneous& at, double degree,
                         const Number& weight, Bounded_moments& sum) {
    const Number g = degree * weight * cross(a.n, b.n) / CGAL::square(at.w);
    const Vector c = euclidean(at);
    sum += {g, c.x * g, c.y * g};
  }
  // All that g may be, for a part that is as short as parameters tell.
  static void add_box(const Points& points, Bounded_moments& sum) {
    const auto join = [](const Number& x, const Number& y) {
      return Number((std::min)(x.inf(), y.inf()), (std::max)(x.sup(), y.sup()));
    };
    Homogeneous hull = points.front();
    for (const Homogeneous& p : points) hull = {{join(hull.n.x, p.n.x), join(hull.n.y, p.n.y)}, join(hull.w, p.w)};
    add_values(hull, hull, hull, static_cast<double>(points.size() - 1), Number(1), sum);
  }

  Xy<double> from_, to_;
  double rounding_ = 0;
  Points points_;  // seen from from_
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
