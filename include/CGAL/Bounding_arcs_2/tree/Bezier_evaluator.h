// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Point and two derivatives of a Bezier piece in doubles, with bounds of their errors that are known ahead.
//
// De Casteljau's scheme stopped two steps early has them all: of its last three points b0, b1, b2,
//   C = ((1-t)^2, 2 t (1-t), t^2).b,  C' = n ((1-t) (b1 - b0) + t (b2 - b1)),  C'' = n (n-1) (b2 - 2 b1 + b0);
// a rational piece does so in homogeneous coordinates N = (sum w P B), W = (sum w B), and C = N / W,
// C' = (N' - W' C) / W, C'' = (N'' - 2 W' C' - W'' C) / W.
//
// Errors.  With u = 2^-53, |coordinates| <= M and weights in [w, v], a step of the scheme is a convex combination and
// rounds by 3 u of the largest number, so its points err by 3 n u M at most, C' by 2 n (3 n + 2) u M, C'' by
// 4 n (n-1) (3 n + 3) u M in each coordinate.  A rational piece has N, W with errors of (3 n + 1) u W M, (3 n + 1) u W
// next to the true ones, which are combinations with positive weights, and derivatives with the errors above times v.
// With Q = v / w >= v / W and |W'| / W <= 2 n Q, |W''| / W <= 4 n^2 Q, |C'| <= 4 n Q M:
//   C by (6 n + 4) u M,  C' by (2 n (3 n + 3) 2 Q + 2 n Q (6 n + 6) + 4 n Q 4) u M <= (24 n^2 + 40 n) Q u M,
//   C'' by at most 16 times that times n Q: each of its terms is one of C' times a factor of at most 2 n Q or has a
//   number of that size in its place.
// Vectors are longer than coordinates by sqrt 2 at most, for which 1.5 stands, and for terms of u^2 with it.  To u M
// comes a length whose square is far from the end of the range of double: where products of others underflow, they miss
// less than that, and what is as short beside the unit of a drawing is not told apart.
//
// Where weights differ much, Q says little of most parameters.  With the scheme's last two weights v0, v1 and last
// three w0, w1, w2,
//   D1 = n (v0 + v1) / W >= |W'| / W,  D2 = n (n-1) (w0 + 2 w1 + w2) / W >= |W''| / W,
// N' / W and N'' / W err by 3 n u M D1 and 3 n u M D2, W' / W and W'' / W by 3 n u times these.  Let e be the error of
// C.
//   C': 3 n u M D1 of N', as much of W', D1 e of C and 3 u M D1 of the product and the difference; the quotient by
//       (3 n + 3) u of at most 2 M D1.  Together  e' = (18 n + 13) u M D1  with e = (6 n + 4) u M.
//   C'': (6 n + 2) u M D2 + D2 e of N'' and W'' C;  2 ((3 n + 2) u D1 |C'| + D1 e') of 2 W' C';  differences and the
//       quotient by (3 n + 6) u of at most 2 M D2 + 2 D1 |C'|.  Together
//       (18 n + 18) u M D2 + (12 n + 16) u D1 |C'| + 2 D1 e'.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_BEZIER_EVALUATOR_H
#define CGAL_BOUNDING_ARCS_2_TREE_BEZIER_EVALUATOR_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/number/Xy.h>
#include <CGAL/Bounding_arcs_2/number/stable_norm.h>
#include <CGAL/Bounding_arcs_2/number/strict_math.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace CGAL::Bounding_arcs {

namespace internal {
/// A point of a curve with its derivatives by the parameter.
template <class NT> struct Jet_2 { Xy<NT> point, first, second; };
/// A point and derivatives in doubles.
using Curve_jet = Jet_2<double>;

/// Bounds of the distance of a jet's derivatives from the true ones.
struct Jet_errors {
  double first, second;
};
}  // namespace internal

/// Evaluates a Bezier piece and two derivatives in doubles, with bounds of their errors that are known ahead.
class Bezier_evaluator {
 public:
  /// s p + t q.
  template <class NT> [[nodiscard]] static Xy<NT> blend(const NT& s, const Xy<NT>& p, const NT& t, const Xy<NT>& q) {
    return {NT(s * p.x + t * q.x), NT(s * p.y + t * q.y)};
  }
  /// The jet at t of the cubic with control points p[0] to p[3].
  template <class NT> [[nodiscard]] static internal::Jet_2<NT> cubic_jet(const Xy<NT>* p, const NT& t) {
    const NT s = NT(1) - t;
    const Xy<NT> b[3] = {blend(s, p[0], t, p[1]), blend(s, p[1], t, p[2]), blend(s, p[2], t, p[3])};
    return last_steps(b, s, t, 3);
  }

  explicit Bezier_evaluator(const Bezier_curve_2<double>& curve)
      : curve_(curve), points_(curve.control_points().data()), degree_(static_cast<std::uint32_t>(curve.degree())),
        is_rational_(curve.is_rational()) {
    double size = 0, least = 1, largest = 1;
    for (std::size_t i = 0; i <= degree_; ++i) {
      const Xy<double>& p = points_[i];
      size = (std::max)({size, std::fabs(p.x), std::fabs(p.y)});
      const double w = curve.weight(static_cast<int>(i));
      least = i == 0 ? w : (std::min)(least, w);
      largest = i == 0 ? w : (std::max)(largest, w);
    }
    // squares of lengths below 2^-480 are not the numbers that bounds count on
    const double n = static_cast<double>(degree_), unit = 1.5 * HALF_ULP * size + 0x1p-480, q = largest / least;
    point_error_ = (is_rational_ ? 6 * n + 4 : 3 * n + 1) * unit;
    first_error_ = (is_rational_ ? (24 * n * n + 40 * n) * q : 2 * n * (3 * n + 2)) * unit;
    second_error_ = is_rational_ ? 16 * n * q * first_error_ : 4 * n * n * (3 * n + 3) * unit;
    size_ = size;
    constexpr double EXTREME = 0x1p10;  // below, bounds for all parameters are good enough
    has_extreme_weights_ = q > EXTREME;
    second_bound_ = second_bound(curve, least);
  }

  [[nodiscard]] const Bezier_curve_2<double>& curve() const { return curve_; }
  [[nodiscard]] std::size_t degree() const { return degree_; }
  [[nodiscard]] bool is_rational() const { return is_rational_; }
  /// The largest |coordinate| of a control point.
  [[nodiscard]] double coordinate_size() const { return size_; }
  /// Bounds of the distance of computed vectors from the true ones, for t in [0, 1].
  [[nodiscard]] double point_error() const { return point_error_; }
  [[nodiscard]] double first_error() const { return first_error_; }
  [[nodiscard]] double second_error() const { return second_error_; }
  /// Returns the bounds at one parameter, which are less by far where weights differ much.
  /// \param jet what the curve is there
  [[nodiscard]] internal::Jet_errors errors_at(double t, const internal::Curve_jet& jet) const {
    return has_extreme_weights_ ? weighted_errors(t, jet) : internal::Jet_errors{first_error_, second_error_};
  }
  /// How far derivatives are from those of a curve whose points are within `rounding`, as its numbers round to these.
  /// Control points that are moved by r move derivatives by twice the degree times r; coordinates and weights of a
  /// rational piece with relative errors of u do less to N and W and their derivatives than evaluation does above.
  [[nodiscard]] double first_change(double rounding) const { return first_change(rounding, first_error_); }
  [[nodiscard]] double second_change(double rounding) const { return second_change(rounding, second_error_); }
  /// \param error that of the derivative, for all parameters or for one
  [[nodiscard]] double first_change(double rounding, double error) const {
    if (rounding == 0) return 0;
    return 2 * static_cast<double>(degree_) * rounding + (is_rational_ ? error : 0);
  }
  [[nodiscard]] double second_change(double rounding, double error) const {
    if (rounding == 0) return 0;
    const double n = 2 * static_cast<double>(degree_);
    return n * n * rounding + (is_rational_ ? error : 0);
  }
  /// An upper bound of |C''| for t in [0, 1].
  [[nodiscard]] double second_bound() const { return second_bound_; }

  /// The point is that of the control polygon at t = 0 and t = 1. \pre 0 <= t <= 1
  [[nodiscard]] internal::Curve_jet operator()(double t) const {
    internal::Curve_jet jet =
        is_rational_ ? rational_jet(t) : (degree_ == 3 ? cubic_jet(points_, t) : polynomial_jet(t));
    if (t == 0) jet.point = points_[0];
    if (t == 1) jet.point = points_[degree_];
    return jet;
  }

 private:
  // The jet at t = 1 - s of a curve of degree n by the last three points of de Casteljau's scheme but two steps.
  template <class NT>
  [[nodiscard]] static internal::Jet_2<NT> last_steps(const Xy<NT>* b, const NT& s, const NT& t, double n) {
    const Xy<NT> p = blend(s, b[0], t, b[1]), q = blend(s, b[1], t, b[2]);
    return {blend(s, p, t, q), NT(n) * (q - p), NT(n * (n - 1)) * ((b[2] - b[1]) - (b[1] - b[0]))};
  }
  // By differences of N about the first control point, where |C| <= D, with weights at least w:
  //   |C'| <= (|N'| + |W'| D) / w,  |C''| <= (|N''| + 2 |W'| |C'| + |W''| D) / w;  roundings are 2^-40 of the sums.
  [[nodiscard]] static double second_bound(const Bezier_curve_2<double>& curve, double least) {
    const auto& p = curve.control_points();
    const auto weight = [&](std::size_t i) { return curve.weight(static_cast<int>(i)); };
    const auto numerator = [&](std::size_t i) { return weight(i) * (p[i] - p[0]); };
    const double n = static_cast<double>(p.size() - 1);
    double first = 0, second = 0, weight_first = 0, weight_second = 0, farthest = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      farthest = (std::max)(farthest, stable_norm(p[i] - p[0]));
      if (i < 1) continue;
      first = (std::max)(first, n * stable_norm(numerator(i) - numerator(i - 1)));
      weight_first = (std::max)(weight_first, n * std::fabs(weight(i) - weight(i - 1)));
      if (i < 2) continue;
      const Xy<double> change = (numerator(i) - numerator(i - 1)) - (numerator(i - 1) - numerator(i - 2));
      const double change_of_weight = (weight(i) - weight(i - 1)) - (weight(i - 1) - weight(i - 2));
      second = (std::max)(second, n * (n - 1) * stable_norm(change));
      weight_second = (std::max)(weight_second, n * (n - 1) * std::fabs(change_of_weight));
    }
    const double speed = (first + weight_first * farthest) / least;
    const double bound = (second + 2 * weight_first * speed + weight_second * farthest) / least;
    double size = 0;  // differences round by some u of the coordinates
    for (const auto& q : p) size = (std::max)(size, stable_norm(q));
    return bound * (1 + 0x1p-40) + 16 * n * n * HALF_ULP * size * (1 + weight_first / least);
  }

  // The numerator of a rational piece.
  [[nodiscard]] internal::Curve_jet polynomial_jet(double t) const {
    const double s = 1 - t, n = static_cast<double>(degree_);
    boost::container::small_vector<Xy<double>, 12> b(points_, points_ + degree_ + 1);
    if (is_rational_)
      for (std::size_t i = 0; i <= degree_; ++i) b[i] = curve_.weights()[i] * b[i];
    if (degree_ == 1) return {blend(s, b[0], t, b[1]), b[1] - b[0], {}};
    for (std::size_t k = degree_; k > 2; --k)
      for (std::size_t i = 0; i < k; ++i) b[i] = blend(s, b[i], t, b[i + 1]);
    return last_steps(b.data(), s, t, n);
  }
  // The weights of the scheme's last points: three, or two of a line.
  [[nodiscard]] boost::container::small_vector<double, 12> last_weights(double t) const {
    const double s = 1 - t;
    boost::container::small_vector<double, 12> w(curve_.weights().begin(), curve_.weights().end());
    for (std::size_t k = degree_; k > 2; --k)
      for (std::size_t i = 0; i < k; ++i) w[i] = s * w[i] + t * w[i + 1];
    return w;
  }
  [[nodiscard]] internal::Jet_errors weighted_errors(double t, const internal::Curve_jet& jet) const {
    const double s = 1 - t, n = static_cast<double>(degree_), unit = 1.5 * HALF_ULP * size_;
    const auto w = last_weights(t);
    const bool is_line = degree_ == 1;
    const double v0 = is_line ? w[0] : s * w[0] + t * w[1], v1 = is_line ? w[1] : s * w[1] + t * w[2];
    constexpr double UP = 1 + 0x1p-40;  // for the roundings of these sums
    const double weight = s * v0 + t * v1, d1 = n * (v0 + v1) / weight * UP,
                 d2 = is_line ? 0 : n * (n - 1) * (w[0] + 2 * w[1] + w[2]) / weight * UP;
    const double first = (18 * n + 13) * unit * d1, speed = std::fabs(jet.first.x) + std::fabs(jet.first.y) + first,
                 second = (18 * n + 18) * unit * d2 + d1 * ((12 * n + 16) * (1.5 * HALF_ULP) * speed + 2 * first);
    return {(std::min)(first, first_error_), (std::min)(second * UP, second_error_)};
  }
  [[nodiscard]] internal::Curve_jet rational_jet(double t) const {
    const double s = 1 - t, n = static_cast<double>(degree_);
    const internal::Curve_jet numerator = polynomial_jet(t);
    const auto w = last_weights(t);
    double weight, first, second = 0;
    if (degree_ == 1) {
      weight = s * w[0] + t * w[1];
      first = w[1] - w[0];
    } else {
      const double a = s * w[0] + t * w[1], b = s * w[1] + t * w[2];
      weight = s * a + t * b;
      first = n * (b - a);
      second = n * (n - 1) * ((w[2] - w[1]) - (w[1] - w[0]));
    }
    const double inverse = 1 / weight;
    internal::Curve_jet jet;
    jet.point = {numerator.point.x / weight, numerator.point.y / weight};
    jet.first = inverse * (numerator.first - first * jet.point);
    jet.second = inverse * ((numerator.second - (2 * first) * jet.first) - second * jet.point);
    return jet;
  }

  Bezier_curve_2<double> curve_;
  const Xy<double>* points_;  // its control points
  std::uint32_t degree_;
  bool is_rational_, has_extreme_weights_;
  double point_error_, first_error_, second_error_, second_bound_, size_;
};

}  // namespace CGAL::Bounding_arcs

#endif
