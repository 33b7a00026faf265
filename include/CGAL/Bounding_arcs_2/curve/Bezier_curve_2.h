// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A polynomial or rational Bezier curve over any field number type.
// Invariant: at least two control points; no weights, or as many as control points, all positive.

#ifndef CGAL_BOUNDING_ARCS_2_CURVE_BEZIER_CURVE_2_H
#define CGAL_BOUNDING_ARCS_2_CURVE_BEZIER_CURVE_2_H

#include <CGAL/Bounding_arcs_2/number/Xy.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/number/points_of_kernel.h>

#include <boost/container/small_vector.hpp>

#include <cstddef>
#include <memory>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

/// The point of a curve and the first two derivatives there.
template <class NT> struct End_jet_2 { Xy<NT> point, first, second; };

namespace internal {
/// Taylor coefficients b_k = binomial(degree, k) Delta^k about t of a Bernstein polynomial, k = 0 .. count - 1.
template <class NT, class T>
[[nodiscard]] std::vector<T> taylor_coefficients(std::vector<T> row, const NT& t, std::size_t count) {
  const std::size_t n = row.size();
  std::vector<T> result;
  NT binomial(1);
  for (std::size_t k = 0; k < count; ++k) {
    if (k >= n) {
      result.emplace_back();
      continue;
    }
    std::vector<T> p = row;
    for (std::size_t m = p.size() - 1; m > 0; --m)
      for (std::size_t i = 0; i < m; ++i) p[i] = NT(NT(1) - t) * p[i] + t * p[i + 1];
    result.push_back(binomial * p.front());
    for (std::size_t i = 0; i + 1 < row.size(); ++i) row[i] = row[i + 1] - row[i];
    row.pop_back();
    binomial = NT(binomial * NT(static_cast<int>(n - 1 - k)) / NT(static_cast<int>(k + 1)));
  }
  return result;
}

/// Numbers over another type: exactly if Target holds them.
template <class Target, class NT> [[nodiscard]] std::vector<Target> numbers_over(const std::vector<NT>& numbers) {
  std::vector<Target> result;
  result.reserve(numbers.size());
  for (const NT& x : numbers) result.push_back(Target(x));
  return result;
}
/// Points over another type, likewise.
template <class Target, class NT> [[nodiscard]] std::vector<Xy<Target>> points_over(const std::vector<Xy<NT>>& points) {
  std::vector<Xy<Target>> result;
  result.reserve(points.size());
  for (const Xy<NT>& p : points) result.push_back({Target(p.x), Target(p.y)});
  return result;
}
}  // namespace internal

/// A polynomial or rational Bezier curve of any degree from 1: sum w_i P_i B_i(t) / sum w_i B_i(t), t in [0,1]. Control
/// points are Euclidean. Its numbers never change, and copies share them.
/// \code
/// const Bezier_curve_2<double> arch({{0, 0}, {1, 2}, {3, 2}, {4, 0}});
/// const Xy<double> top = arch.point(0.5);
/// const Bezier_curve_2<double> quarter({{1, 0}, {1, 1}, {0, 1}}, {1, std::sqrt(0.5), 1});  // of a circle
/// \endcode
template <class NT> class Bezier_curve_2 {
 public:
  using Number_type = NT;
  using Point = Xy<NT>;

  /// \param points the control points, degree + 1 of them, at least two
  /// \param weights empty for a polynomial curve, else one positive weight a control point
  /// \throws std::invalid_argument when a count or a weight is wrong
  explicit Bezier_curve_2(std::vector<Point> points, std::vector<NT> weights = {})
      : numbers_(std::make_shared<const Numbers>(Numbers{std::move(points), std::move(weights)})) {
    const std::vector<NT>& w = this->weights();
    if (control_points().size() < 2)
      throw std::invalid_argument(expected("control points", "at least 2 of a Bezier curve", control_points().size()));
    if (!w.empty() && w.size() != control_points().size())
      throw std::invalid_argument(
          expected("weights", "as many as control points, " + text_of(control_points().size()), w.size()));
    for (std::size_t i = 0; i < w.size(); ++i)
      if (!(w[i] > NT(0)))
        throw std::invalid_argument(expected("weight " + text_of(i), "a number above 0", text_of(w[i], "another one")));
  }

  /// Takes a range of points of any kernel, see points_of_kernel.
  template <class Points, class = internal::Kernel_of_range<Points>>
  explicit Bezier_curve_2(const Points& points, std::vector<NT> weights = {})
      : Bezier_curve_2(internal::points_of_kernel<NT>(points), std::move(weights)) {}

  [[nodiscard]] int degree() const { return static_cast<int>(control_points().size()) - 1; }
  [[nodiscard]] bool is_rational() const { return !weights().empty(); }
  [[nodiscard]] const std::vector<Point>& control_points() const { return numbers_->points; }
  /// One weight a control point, or empty for a polynomial curve.
  [[nodiscard]] const std::vector<NT>& weights() const { return numbers_->weights; }
  [[nodiscard]] NT weight(int i) const { return is_rational() ? weights()[static_cast<std::size_t>(i)] : NT(1); }

  /// Converts to another number type: exactly if Target holds its numbers.
  template <class Target> [[nodiscard]] Bezier_curve_2<Target> over() const {
    return Bezier_curve_2<Target>(internal::points_over<Target>(control_points()),
                                  internal::numbers_over<Target>(weights()));
  }

  /// The point at parameter t; at t = 0 and t = 1 the end control points themselves.
  /// \guarantee exact over a field; over double, in each coordinate within 3 degree u max|P| of the true
  ///   point for t in [0,1] and a polynomial curve (de Casteljau: convex combinations only; cubic_point)
  /// \complexity quadratic in the degree
  [[nodiscard]] Point point(const NT& t) const {
    const std::vector<Point>& p = control_points();
    if (t == NT(0)) return p.front();
    if (t == NT(1)) return p.back();
    return p.size() == 4 && !is_rational() ? cubic_point(p.data(), t) : any_point(t);
  }

  /// The Taylor coefficients C^(k)(t) / k!, k = 0 .. order.
  /// \guarantee exact over a field; over double each is a sum of differences of the control points
  /// \source rational curves by the quotient recurrence: Piegl and Tiller 1997, algorithm A4.2
  [[nodiscard]] std::vector<Point> taylor_expansion(const NT& t, int order) const {
    const auto count = static_cast<std::size_t>(order) + 1;
    if (!is_rational()) return internal::taylor_coefficients(control_points(), t, count);
    std::vector<Point> numerator;
    const Point origin = control_points().front();  // keeps the products small
    for (std::size_t i = 0; i < control_points().size(); ++i)
      numerator.push_back(weights()[i] * (control_points()[i] - origin));
    const auto a = internal::taylor_coefficients(std::move(numerator), t, count);
    const auto w = internal::taylor_coefficients(weights(), t, count);
    std::vector<Point> c;
    for (std::size_t k = 0; k < count; ++k) {
      Point rest = a[k];
      for (std::size_t j = 1; j <= k; ++j) rest = rest - w[j] * c[k - j];
      c.push_back({NT(rest.x / w[0]), NT(rest.y / w[0])});
    }
    c[0] = c[0] + origin;
    return c;
  }

  /// The derivative of the given order, 0 for the point itself.
  [[nodiscard]] Point derivative(const NT& t, int order) const {
    NT factorial(1);
    for (int k = 2; k <= order; ++k) factorial = NT(factorial * NT(k));
    return factorial * taylor_expansion(t, order).back();
  }

  /// Point, tangent and second derivative at t, seen from the right (`after`) or from the left.  Where C' vanishes
  /// `first` is the limit of the tangent's direction on that side, m times the first Taylor vector that does not
  /// vanish, and `second` is 0: the curvature of such an end is not that of a jet.
  /// \return nothing when the whole curve is one point
  [[nodiscard]] std::optional<End_jet_2<NT>> end_jet(const NT& t, bool after) const {
    // all derivatives of a rational curve vanish only if it is a point; of order degree at the latest one does not
    const auto c = taylor_expansion(t, degree());
    const Point zero{};
    for (std::size_t m = 1; m < c.size(); ++m) {
      if (c[m] == zero) continue;
      if (m == 1) return End_jet_2<NT>{c[0], c[1], c.size() > 2 ? NT(2) * c[2] : zero};
      const NT sign(after || m % 2 == 1 ? 1 : -1);
      return End_jet_2<NT>{c[0], NT(sign * NT(static_cast<int>(m))) * c[m], zero};
    }
    return std::nullopt;
  }

  /// The largest |coordinate| of a control point.
  [[nodiscard]] NT coordinate_size() const {
    NT size(0);
    const auto take = [&size](const NT& x) {
      if (size < x) size = x;
      else if (size < -x) size = -x;
    };
    for (const Point& p : control_points()) {
      take(p.x);
      take(p.y);
    }
    return size;
  }

  /// The two halves at parameter t, de Casteljau's algorithm.
  [[nodiscard]] std::pair<Bezier_curve_2, Bezier_curve_2> split(const NT& t) const {
    std::vector<Point> p = control_points(), left{p.front()}, right(p.size(), p.back());
    std::vector<NT> w = weights(), left_w, right_w(w.size(), weight(degree()));
    if (!w.empty()) left_w.push_back(w.front());
    const NT s = NT(1) - t;
    for (std::size_t n = p.size() - 1; n > 0; --n) {
      for (std::size_t i = 0; i < n; ++i) blend(p, w, i, s, t);
      left.push_back(p.front());
      right[n - 1] = p[n - 1];
      if (w.empty()) continue;
      left_w.push_back(w.front());
      right_w[n - 1] = w[n - 1];
    }
    return {Bezier_curve_2(std::move(left), std::move(left_w)), Bezier_curve_2(std::move(right), std::move(right_w))};
  }

  /// The piece over [t0, t1] as a curve of its own, 0 <= t0 < t1 <= 1.
  [[nodiscard]] Bezier_curve_2 subcurve(const NT& t0, const NT& t1) const {
    const Bezier_curve_2 head = t1 == NT(1) ? *this : split(t1).first;
    return t0 == NT(0) ? head : head.split(NT(t0 / t1)).second;
  }

  /// Returns the curve that runs through the same points from t = 1 to t = 0.
  [[nodiscard]] Bezier_curve_2 reversed() const {
    return Bezier_curve_2(std::vector<Point>(control_points().rbegin(), control_points().rend()),
                          std::vector<NT>(weights().rbegin(), weights().rend()));
  }

  /// Writes a line for each control point: x and y, and the weight of a rational curve.
  friend std::ostream& operator<<(std::ostream& out, const Bezier_curve_2& curve) {
    for (std::size_t i = 0; i < curve.control_points().size(); ++i) {
      out << curve.control_points()[i];
      if (curve.is_rational()) out << ' ' << curve.weights()[i];
      out << '\n';
    }
    return out;
  }

 private:
  // p[i] becomes the point at ratio s : t between p[i] and p[i+1]; for rational curves with the ratio of the
  // blended weights, so that control points stay Euclidean and every step is a convex combination.
  template <class Points, class Numbers>
  static void blend(Points& p, Numbers& w, std::size_t i, const NT& s, const NT& t) {
    if (w.empty()) {
      p[i] = s * p[i] + t * p[i + 1];
      return;
    }
    const NT w0 = s * w[i], w1 = t * w[i + 1], sum = w0 + w1;
    p[i] = NT(w0 / sum) * p[i] + NT(w1 / sum) * p[i + 1];
    w[i] = sum;
  }

  [[nodiscard]] Point any_point(const NT& t) const {
    boost::container::small_vector<Point, 8> p(control_points().begin(), control_points().end());
    boost::container::small_vector<NT, 8> w(weights().begin(), weights().end());
    const NT s = NT(1) - t;
    for (std::size_t n = p.size() - 1; n > 0; --n)
      for (std::size_t i = 0; i < n; ++i) blend(p, w, i, s, t);
    return p.front();
  }
  // In Bernstein's form, a third of the time: weights err by up to 5 u of themselves, a product and three sums make it
  // 9 u.
  [[nodiscard]] static Point cubic_point(const Point* p, const NT& t) {
    const NT s = NT(1) - t, ss = s * s, tt = t * t;
    const NT b0 = ss * s, b1 = NT(3) * (ss * t), b2 = NT(3) * (tt * s), b3 = tt * t;
    return {NT(b0 * p[0].x + b1 * p[1].x + b2 * p[2].x + b3 * p[3].x),
            NT(b0 * p[0].y + b1 * p[1].y + b2 * p[2].y + b3 * p[3].y)};
  }

  struct Numbers {
    std::vector<Point> points;
    std::vector<NT> weights;
  };
  std::shared_ptr<const Numbers> numbers_;
};

}  // namespace CGAL::Bounding_arcs

#endif
