// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Taylor coefficients of any piece of a Bezier curve.

#ifndef CGAL_BOUNDING_ARCS_2_FRAME_TAYLOR_TABLE_H
#define CGAL_BOUNDING_ARCS_2_FRAME_TAYLOR_TABLE_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/number/convert.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <type_traits>
#include <vector>

namespace CGAL::Bounding_arcs {

namespace internal {
/// Room for the coefficients of degree 7 without an allocation.
template <class T> using Coefficients = boost::container::small_vector<T, 8>;

/// Taylor coefficients of one piece [t, t+h]: numerator[k] = N^(k)(t) h^k / k!, weight[k] the same of the weight.
/// For a polynomial curve `weight` is empty and numerator[0] is 0 (the piece relative to its start).
template <class NT> struct Taylor_coefficients {
  Coefficients<Xy<NT>> numerator;
  Coefficients<NT> weight;
};
}  // namespace internal

/// Forward differences of a Bezier curve's control points, kept so that the Taylor coefficients of any piece are sums
/// of differences and never differences of far-away points.
/// Invariant: lengths are in units of `unit()`, a power of two near the largest control point difference.
template <class NT> class Taylor_table {
 public:
  /// \param curve a curve over a floating type, converted to NT before differences are taken, or over an exact type,
  ///   whose differences are taken exactly and converted afterwards
  /// \param unit a positive power of two, see `length_unit`: it keeps doubles made from exact shapes in range, too
  template <class Source>
  Taylor_table(const Bezier_curve_2<Source>& curve, double unit) : degree_(curve.degree()), unit_(unit) {
    using Work = std::conditional_t<std::is_floating_point_v<Source>, NT, Source>;
    const std::size_t n = curve.control_points().size();
    const auto point = [&](std::size_t i) { return convert<Work>(curve.control_points()[i]); };
    const Work inverse = Work(1) / Work(unit);
    std::vector<Xy<Work>> row;
    if (!curve.is_rational()) {
      for (std::size_t i = 0; i + 1 < n; ++i) row.push_back(inverse * (point(i + 1) - point(i)));
      fill(row, 1, points_);
      return;
    }
    std::vector<Work> weights;
    const double scale = weight_scale(curve);
    for (std::size_t i = 0; i < n; ++i) {
      weights.push_back(convert<Work>(curve.weights()[i]));
      if (scale != 1) weights.back() = Work(scale) * weights.back();
      row.push_back(weights.back() * (inverse * (point(i) - point(0))));
    }
    fill(row, 0, points_);
    fill(weights, 0, weights_);
  }

  /// Converts a table, one number after the other: of exact differences, none is taken again.
  template <class Source, class Convert>
  Taylor_table(const Taylor_table<Source>& other, const Convert& number) : degree_(other.degree_), unit_(other.unit_) {
    for (const Xy<Source>& p : other.points_) points_.push_back({number(p.x), number(p.y)});
    for (const Source& w : other.weights_) weights_.push_back(number(w));
  }

  [[nodiscard]] int degree() const { return degree_; }
  [[nodiscard]] bool is_rational() const { return !weights_.empty(); }
  [[nodiscard]] double unit() const { return unit_; }

  /// The Taylor coefficients of the piece [t0, t1].
  /// \guarantee exact over a field; over double each is a sum of same-order differences with positive weights, so its
  ///   error is at most (degree + 4) u times the largest difference of that order times h^k binomial(degree, k)
  [[nodiscard]] internal::Taylor_coefficients<NT> expand(const NT& t0, const NT& t1) const {
    internal::Coefficients<NT> t(1, NT(1)), s(1, NT(1));
    const NT rest = NT(1) - t0, h = t1 - t0;
    for (int k = 0; k < degree_; ++k) {
      t.push_back(NT(t.back() * t0));
      s.push_back(NT(s.back() * rest));
    }
    internal::Taylor_coefficients<NT> taylor;
    const int first = is_rational() ? 0 : 1;
    if (first == 1) taylor.numerator.push_back(Xy<NT>{});
    NT power = first == 0 ? NT(1) : h;
    std::size_t at = 0;
    for (int k = first; k <= degree_; ++k) {
      taylor.numerator.push_back(power * sum(points_, at, degree_ - k, t, s));
      if (is_rational()) taylor.weight.push_back(NT(power * sum(weights_, at, degree_ - k, t, s)));
      at += static_cast<std::size_t>(degree_ - k + 1);
      power = NT(power * h);
    }
    return taylor;
  }

  /// As `expand`, for a polynomial curve, with loops of known length.
  /// \pre degree() == N
  template <std::size_t N> [[nodiscard]] std::array<Xy<NT>, N + 1> expand_polynomial(const NT& t0, const NT& t1) const {
    std::array<NT, N> t, s;  // powers
    t[0] = s[0] = NT(1);
    const NT rest = NT(1) - t0, h = t1 - t0;
    for (std::size_t k = 1; k < N; ++k) {
      t[k] = NT(t[k - 1] * t0);
      s[k] = NT(s[k - 1] * rest);
    }
    std::array<Xy<NT>, N + 1> numerator;
    NT power = h;
    const Xy<NT>* row = points_.data();
    for (std::size_t k = 1; k <= N; ++k) {
      Xy<NT> sum = s[N - k] * row[0];
      for (std::size_t i = 1; i <= N - k; ++i) sum = sum + NT(t[i] * s[N - k - i]) * row[i];
      numerator[k] = power * sum;
      row += N - k + 1;
      power = NT(power * h);
    }
    return numerator;
  }

 private:
  // A power of two that keeps products of weights in range, 1 where they are of ordinary size: only their ratios
  // matter.
  template <class Source> static double weight_scale(const Bezier_curve_2<Source>& curve) {
    constexpr int ORDINARY = 64, LARGEST = 1000;
    double largest = 0;
    for (const Source& w : curve.weights()) largest = (std::max)(largest, CGAL::to_double(w));
    const int exponent = largest > 0 ? std::clamp(std::ilogb(largest), -LARGEST, LARGEST) : 0;
    return std::abs(exponent) <= ORDINARY ? 1 : std::ldexp(1.0, -exponent);
  }

  template <class T> static T times(const T& s, const T& c) { return T(s * c); }
  template <class T> static Xy<T> times(const T& s, const Xy<T>& c) { return s * c; }

  template <class T> static const T& number(const T& x) { return x; }
  template <class T> static const T& number(const Xy<T>& p) { return p.x; }

  // Appends, for k = first .. degree, binomial(degree, k) binomial(degree - k, i) times the k-th forward differences.
  template <class Row, class Table> void fill(Row row, int first, Table& table) const {
    using Work = std::decay_t<decltype(number(row.front()))>;
    double binomial = first == 0 ? 1 : degree_;
    for (int k = first; k <= degree_; ++k) {
      double inner = binomial;
      for (int i = 0; i <= degree_ - k; ++i) {
        table.push_back(convert<NT>(times(Work(inner), row[static_cast<std::size_t>(i)])));
        inner = inner * (degree_ - k - i) / (i + 1);
      }
      for (std::size_t i = 0; i + 1 < row.size(); ++i) row[i] = row[i + 1] - row[i];
      row.pop_back();
      binomial = binomial * (degree_ - k) / (k + 1);
    }
  }

  template <class T>
  [[nodiscard]] static T sum(const std::vector<T>& table, std::size_t at, int n, const internal::Coefficients<NT>& t,
                             const internal::Coefficients<NT>& s) {
    T value = times(s[static_cast<std::size_t>(n)], table[at]);
    for (int i = 1; i <= n; ++i)
      value = value + times(NT(t[static_cast<std::size_t>(i)] * s[static_cast<std::size_t>(n - i)]),
                            table[at + static_cast<std::size_t>(i)]);
    return value;
  }

  template <class> friend class Taylor_table;

  int degree_;
  double unit_;
  std::vector<Xy<NT>> points_;
  std::vector<NT> weights_;
};

/// A power of two near the largest control point difference, so that products of up to six of the scaled lengths
/// neither overflow nor underflow.  The exponent is kept within +-1000 so that the inverse is a double too.
template <class NT> [[nodiscard]] double length_unit(const Bezier_curve_2<NT>& curve) {
  double largest = 0;
  const auto& p = curve.control_points();
  for (std::size_t i = 0; i + 1 < p.size(); ++i)
    largest = (std::max)({largest, std::fabs(CGAL::to_double(NT(p[i + 1].x - p[i].x))),
                          std::fabs(CGAL::to_double(NT(p[i + 1].y - p[i].y)))});
  return largest > 0 ? std::ldexp(1.0, std::clamp(std::ilogb(largest), -1000, 1000)) : 1.0;
}

}  // namespace CGAL::Bounding_arcs

#endif
