// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A piece of a Bezier curve as polynomials in the Bernstein basis: what the regions that are measured on control
// points, and not made from end data alone, are measured with.

#ifndef CGAL_BOUNDING_ARCS_2_STUDY_INTERNAL_CONTROL_POLYNOMIALS_H
#define CGAL_BOUNDING_ARCS_2_STUDY_INTERNAL_CONTROL_POLYNOMIALS_H

#include <CGAL/Bounding_arcs_2/frame/Chord_frame_2.h>
#include <CGAL/Bounding_arcs_2/number/number_types.h>
#include <CGAL/Bounding_arcs_2/polynomial/Bernstein_polynomial.h>
#include <CGAL/assertions.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::study {

/// The piece minus its start, in units of its shape: (x, y) / weight, all three of one degree, as halves over a ring
/// without division come multiplied by 2 to the degree.
template <class NT> struct Control_polynomials {
  using Polynomial = Bernstein_polynomial<NT>;
  Polynomial x, y, weight;

  /// v . (x, y)
  [[nodiscard]] Polynomial along(const Xy<NT>& v) const { return v.x * x + v.y * y; }
  /// Returns the curve minus `point`.
  [[nodiscard]] Control_polynomials about(const Xy<NT>& point) const {
    return {x - point.x * weight, y - point.y * weight, weight};
  }
  /// Returns the parts over [0, 1/2] and [1/2, 1].
  [[nodiscard]] std::pair<Control_polynomials, Control_polynomials> halves() const {
    auto hx = x.halves(), hy = y.halves(), hw = weight.halves();
    return {{std::move(hx.first), std::move(hy.first), std::move(hw.first)},
            {std::move(hx.second), std::move(hy.second), std::move(hw.second)}};
  }
  /// The point at parameter 1.
  [[nodiscard]] Xy<NT> end() const {
    const NT& w = weight.scaled_coefficients().back();
    return {NT(x.scaled_coefficients().back() / w), NT(y.scaled_coefficients().back() / w)};
  }
  /// curvature |q|^2 - 2 normal . q times weight^2: positive to the right of the circle through the start with that
  /// left normal there, and over |normal| 2 d + curvature / |normal| d^2 where it is d away.
  [[nodiscard]] Polynomial beyond(const Xy<NT>& normal, const NT& curvature) const {
    return curvature * (x * x + y * y) - NT(2) * (weight * along(normal));
  }
};

/// \pre the shape has control points: NEEDS_CONTROL_POINTS
template <class NT> [[nodiscard]] Control_polynomials<NT> control_polynomials(const Chord_shape_2<NT>& f) {
  CGAL_precondition(!f.control_points.empty());
  std::vector<NT> x, y, w;
  for (std::size_t i = 0; i < f.control_points.size(); ++i) {
    const NT weight = f.weights.empty() ? NT(1) : f.weights[i];
    x.push_back(NT(weight * f.control_points[i].x));
    y.push_back(NT(weight * f.control_points[i].y));
    w.push_back(weight);
  }
  using Polynomial = Bernstein_polynomial<NT>;
  return {Polynomial(std::move(x)), Polynomial(std::move(y)), Polynomial(std::move(w))};
}

template <class NT> [[nodiscard]] NT smaller(const NT& a, const NT& b) { return NT(-larger(NT(-a), NT(-b))); }

/// Numbers around 0: low <= 0 <= high.
template <class NT> struct Around_zero {
  NT low{0}, high{0};

  void add(const NT& x) {
    low = smaller(low, x);
    high = larger(high, x);
  }
  /// The larger of -low and high.
  [[nodiscard]] NT reach() const { return larger(NT(-low), high); }
};

/// 0 and all values of a polynomial on [0, 1]: its Bernstein coefficients.
template <class NT> [[nodiscard]] Around_zero<NT> range_of(const std::vector<NT>& scaled_coefficients) {
  Around_zero<NT> range;
  if (scaled_coefficients.empty()) return range;
  const std::vector<NT> factors = internal::binomials<NT>(static_cast<int>(scaled_coefficients.size()) - 1);
  for (std::size_t i = 0; i < factors.size(); ++i) range.add(NT(scaled_coefficients[i] / factors[i]));
  return range;
}

/// A lower bound of every weight on [0, 1]. \pre positive weights
template <class NT> [[nodiscard]] NT least_weight(const Bernstein_polynomial<NT>& weight) {
  const std::vector<NT>& c = weight.scaled_coefficients();
  const std::vector<NT> factors = internal::binomials<NT>(weight.degree());
  NT least = c.front();
  for (std::size_t i = 1; i < c.size(); ++i) least = smaller(least, NT(c[i] / factors[i]));
  return least;
}

/// How far from a circle the point is where `beyond` has the value f: positive to the right, for |normal| = length.
/// \pre length^2 + curvature f >= 0: it is not past the center
template <class NT> [[nodiscard]] NT distance_beyond(const NT& f, const NT& length, const NT& curvature) {
  return NT(f / (length + square_root(NT(length * length + curvature * f))));
}

}  // namespace CGAL::Bounding_arcs::study

#endif
