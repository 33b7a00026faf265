// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The roots of a polynomial cubic's four numerators in doubles: a filter in front of Root_isolator with the same
// results, which can be taken out. A quadratic is served as the cubic that it is: the differences of that one's control
// points are d0, (d0 + d1) / 2 and d1, times 2/3, which double-doubles hold exactly. Up to positive factors, with P =
// C' / 3 = a + 2 b t + c t^2 and R = P' / 2 = b + c t,
//   x', y'       P.x, P.y
//   curvature    P x R                              = i0 s^2 + i1 s t + i2 t^2,  s = 1 - t, i of differences crossed
//   its change   (P.P) (P x c) - 6 (P.R) (P x R)    of degree 5
//
// Counting roots.  The first three have none, one or two, told by signs of coefficients and of a discriminant; the last
// is halved until Descartes' rule leaves none or one in each part. A sign counts where it is beyond its error bound.
// Rounding them.  At a double t near a root the numerator v, in double-doubles, and its slope f, in doubles, prove that
// one root lies within w = 4 |v / f| of t if the slope is off by no more than half of itself there; it is t - v / f to
// within the errors of v and f. Where all of that range rounds to one double, this is what Root_isolator finds.
//
// Errors known ahead.  All figures are forms in the differences d of control points. The code that makes them runs
// once, as the compiler reads this, over pairs (size, error) (Magnitude), with differences up to 1 and rounded, and
// parameters up to 1; bounds for differences up to L are those times L to the form's degree.

#ifndef BOUNDING_ARCS_LIBRARY_SPIRAL_CUBIC_ROOTS_H
#define BOUNDING_ARCS_LIBRARY_SPIRAL_CUBIC_ROOTS_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/number/Double_double.h>
#include <CGAL/Bounding_arcs_2/polynomial/Exact_isolation.h>
#include <CGAL/Bounding_arcs_2/spiral/internal/Layered_curve.h>
#include "../number/Pair.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace CGAL::Bounding_arcs::internal {

// P, R and c at a parameter.
template <class NT> struct Cubic_jet { Xy<NT> p, r, c; };

template <class NT> constexpr Cubic_jet<NT> jet_at(const Xy<NT> (&d)[3], const NT& t) {
  const Xy<NT> b = d[1] - d[0], c = (d[2] - d[1]) - b, r = b + t * c;
  return {d[0] + t * (b + r), r, c};
}

// P in one coordinate alone, in the same steps.
template <class NT> constexpr NT speed_at(const NT& d0, const NT& d1, const NT& d2, const NT& t) {
  const NT b = d1 - d0, c = (d2 - d1) - b, r = b + t * c;
  return d0 + t * (b + r);
}

template <Numerator WHICH, class NT> constexpr NT numerator(const Cubic_jet<NT>& j) {
  if constexpr (WHICH == SPEED_X) return j.p.x;
  else if constexpr (WHICH == SPEED_Y) return j.p.y;
  else if constexpr (WHICH == INFLECTION) return cross(j.p, j.r);
  else return NT(dot(j.p, j.p) * cross(j.p, j.c) - NT(6) * (dot(j.p, j.r) * cross(j.p, j.r)));
}

// The derivative of the numerator: P' = 2 R, R' = c.
template <Numerator WHICH, class NT> constexpr NT slope(const Cubic_jet<NT>& j) {
  if constexpr (WHICH == SPEED_X) return NT(2) * j.r.x;
  else if constexpr (WHICH == SPEED_Y) return NT(2) * j.r.y;
  else if constexpr (WHICH == INFLECTION) return cross(j.p, j.c);
  else
    return NT(NT(2) * (dot(j.p, j.p) * cross(j.r, j.c) - dot(j.p, j.r) * cross(j.p, j.c)) -
              NT(6) * ((NT(2) * dot(j.r, j.r) + dot(j.p, j.c)) * cross(j.p, j.r)));
}

// The size of its second derivative, for |P| <= 1, |R| <= 2, |c| <= 4 in each coordinate:
//   2 c,   2 R x c,   4 (P.R)(R x c) - (16 R.R + 8 P.c)(P x c) - 36 (R.c)(P x R).
template <Numerator WHICH> inline constexpr double MOST_BEND = 2 * 4;
template <> inline constexpr double MOST_BEND<INFLECTION> = 2 * 16;
template <> inline constexpr double MOST_BEND<CURVATURE_CHANGE> = 4 * 4 * 16 + (16 * 8 + 8 * 8) * 8 + 36 * 16 * 4;

template <class NT> struct Inflection_form { NT i[3]; };
template <class NT> constexpr Inflection_form<NT> inflection_form(const Xy<NT> (&d)[3]) {
  return {{cross(d[0], d[1]), cross(d[0], d[2]), cross(d[1], d[2])}};
}

// Bernstein coefficients of the change of curvature, times 20: with I = P x R and Q = P.P in the scaled basis, I', Q'
// their derivatives there, those of 2 Q I' - 3 Q' I over binomials, times 10.
template <class NT> struct Change_form { NT b[6]; };
template <class NT> constexpr Change_form<NT> change_form(const Xy<NT> (&d)[3], const Inflection_form<NT>& form) {
  const NT(&i)[3] = form.i;
  const NT q[5] = {dot(d[0], d[0]), NT(4) * dot(d[0], d[1]), NT(2) * dot(d[0], d[2]) + NT(4) * dot(d[1], d[1]),
                   NT(4) * dot(d[1], d[2]), dot(d[2], d[2])};
  const NT slope[2] = {NT(2) * (i[1] - NT(2) * i[0]), NT(2) * (NT(2) * i[2] - i[1])};
  const NT q_slope[4] = {NT(3) * (q[1] - NT(4) * q[0]), NT(3) * (NT(2) * q[2] - NT(3) * q[1]),
                         NT(3) * (NT(3) * q[3] - NT(2) * q[2]), NT(3) * (NT(4) * q[4] - q[3])};
  return {{NT(10) * (q[0] * slope[0] - q_slope[0] * i[0]),
           NT(2) * (q[0] * slope[1] + q[1] * slope[0] - (q_slope[0] * i[1] + q_slope[1] * i[0])),
           q[1] * slope[1] + q[2] * slope[0] - (q_slope[0] * i[2] + q_slope[1] * i[1] + q_slope[2] * i[0]),
           q[2] * slope[1] + q[3] * slope[0] - (q_slope[1] * i[2] + q_slope[2] * i[1] + q_slope[3] * i[0]),
           NT(2) * (q[3] * slope[1] + q[4] * slope[0] - (q_slope[2] * i[2] + q_slope[3] * i[1])),
           NT(10) * (q[4] * slope[1] - q_slope[3] * i[2])}};
}

namespace cubic_errors {

constexpr Magnitude DIFFERENCE{Magnitude::SLACK, 1};
constexpr Xy<Magnitude> D[3] = {{DIFFERENCE, DIFFERENCE}, {DIFFERENCE, DIFFERENCE}, {DIFFERENCE, DIFFERENCE}};

constexpr double INFLECTION_COEFFICIENT = inflection_form(D).i[1].bound();

// A part is halved so often at most, by five means in a row of numbers that do not grow.
constexpr int MOST_HALVINGS = 10, MEANS = 5;
constexpr double change_coefficient() {
  double size = 0, error = 0;
  for (const Magnitude& b : change_form(D, inflection_form(D)).b) {
    size = b.size > size ? b.size : size;
    error = b.bound() > error ? b.bound() : error;
  }
  return (error + MOST_HALVINGS * MEANS * HALF_ULP * size) * Magnitude::SLACK;
}
constexpr double CHANGE_COEFFICIENT = change_coefficient();

// The bound of the rounding of a slope at parameters in doubles.
template <Numerator WHICH> constexpr double SLOPE = slope<WHICH>(jet_at(D, Magnitude(1))).bound();

}  // namespace cubic_errors

class Cubic_roots {
 public:
  explicit Cubic_roots(const Bezier_curve_2<double>& curve) {
    const auto& p = curve.control_points();
    is_served_ = p.size() >= 2 && p.size() <= 4 && !curve.is_rational();
    if (!is_served_) return;
    is_line_ = p.size() == 2;
    const auto difference = [&p](std::size_t from, std::size_t to) {
      return Xy<Double_double>{Double_double::two_sum(p[to].x, -p[from].x),
                               Double_double::two_sum(p[to].y, -p[from].y)};
    };
    const auto half = [](const Double_double& x) { return Double_double::two_sum(x.hi / 2, x.lo / 2); };
    for (std::size_t i = 0; i < 3; ++i) {
      if (p.size() == 4) fine_[i] = difference(i, i + 1);
      else if (i == 1 && !is_line_) fine_[i] = {half(difference(0, 2).x), half(difference(0, 2).y)};
      else fine_[i] = difference(i == 2 && !is_line_ ? 1 : 0, i == 2 && !is_line_ ? 2 : 1);
      d_[i] = {fine_[i].x.hi, fine_[i].y.hi};
      width_ = std::max(width_, std::abs(d_[i].x));
      height_ = std::max(height_, std::abs(d_[i].y));
    }
  }

  // The roots of one numerator; nothing where errors do not decide.
  [[nodiscard]] std::optional<Unit_roots> operator()(Numerator which) const {
    if (!is_served_) return std::nullopt;
    if (is_line_) return Unit_roots{which > SPEED_Y || (which == SPEED_X ? width_ : height_) == 0, {}};
    const double length = std::max(width_, height_), square = length * length;
    if (which == SPEED_X) return speed<SPEED_X>(d_[0].x, d_[1].x, d_[2].x, width_);
    if (which == SPEED_Y) return speed<SPEED_Y>(d_[0].y, d_[1].y, d_[2].y, height_);
    if (!is_moderate(length)) return std::nullopt;
    if (which == CURVATURE_CHANGE) return change(square * square);
    const double error = cubic_errors::INFLECTION_COEFFICIENT * square;
    const auto [c] = inflection_form(d_);
    // level or upright differences make exact zeros
    const auto error_of = [&](std::size_t i, std::size_t j) {
      const bool is_zero = (d_[i].x == 0 || d_[j].y == 0) && (d_[i].y == 0 || d_[j].x == 0);
      return is_zero ? 0 : error;
    };
    return of_quadratic<INFLECTION>(c[0], c[1], c[2], error, {error_of(0, 1), error_of(0, 2), error_of(1, 2)}, square);
  }

 private:
  static constexpr double LEAST_LENGTH = 0x1p-100;  // products of four, and their errors, are normal numbers
  static constexpr int MOST_NEWTON_STEPS = 12, MOST_PROOFS = 2;
  // A step this much smaller than t leaves an error of some half ulps.
  static constexpr double LAST_STEP = 0x1p-26;
  // More than the roundings of a bound, which count a few half ulps of it.
  static constexpr double SLACK = 1 + 0x1p-40;

  static bool is_moderate(double length) { return length >= LEAST_LENGTH && length <= 1 / LEAST_LENGTH; }

  template <Numerator WHICH>
  [[nodiscard]] std::optional<Unit_roots> speed(double d0, double d1, double d2, double size) const {
    if (size == 0) return Unit_roots{true, {}};
    if (!is_moderate(size)) return std::nullopt;
    return of_quadratic<WHICH>(d0, 2 * d1, d2, 2 * HALF_ULP * size, {0, 0, 0},
                               size);  // rounded differences keep their signs
  }

  // The roots of c0 s^2 + c1 s t + c2 t^2. Each coefficient is off by `error`, but signs of those beyond their sign
  // error are known, and of 0 where that is 0.
  template <Numerator WHICH>
  [[nodiscard]] std::optional<Unit_roots> of_quadratic(double c0, double c1, double c2, double error,
                                                       const std::array<double, 3>& sign_errors, double size) const {
    Sign_variations signs;
    const double c[3] = {c0, c1, c2};
    int zeros = 0, known = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const bool is_zero = sign_errors[i] == 0 && c[i] == 0;
      const int sign = c[i] > sign_errors[i] ? 1 : c[i] < -sign_errors[i] ? -1 : 0;
      zeros += int(is_zero);
      known += std::abs(sign);
      if (!is_zero) signs.append(sign);
    }
    if (zeros == 3) return Unit_roots{true, {}};
    if (known == 0) return std::nullopt;  // it may be zero throughout
    if (signs.most() == 0) return Unit_roots{};
    if (signs.fewest != signs.most()) return std::nullopt;
    const double product = 4 * c0 * c2, discriminant = c1 * c1 - product;
    // two roundings in each term and one in the difference, and coefficients off by 4 error at most
    const double rounding = 3 * HALF_ULP * (c1 * c1 + std::abs(product));
    const double bound = (rounding + 4 * error * (std::abs(c0) + std::abs(c1) + std::abs(c2) + 2 * error)) * SLACK;
    if (signs.fewest == 2 && discriminant < -bound) return Unit_roots{};
    if (signs.fewest == 2 && !(discriminant > bound)) return std::nullopt;
    // t / s = q / (2 c2) and 2 c0 / q
    const double q = -(c1 + std::copysign(std::sqrt(std::max(discriminant, 0.0)), c1));
    const double t = q / (q + 2 * c2), u = 2 * c0 / (q + 2 * c0);
    Unit_roots result;
    for (const double guess : {std::min(t, u), std::max(t, u)}) {
      if (!(guess > 0 && guess < 1)) continue;
      const std::optional<double> root = nearest<WHICH>(guess, 0, 1, size);
      if (!root) return std::nullopt;
      result.roots.push_back(*root);
    }
    const bool is_complete = static_cast<int>(result.roots.size()) == signs.fewest;
    const bool are_distinct = result.roots.empty() || result.roots.size() == 1 || result.roots[0] < result.roots[1];
    return is_complete && are_distinct ? std::optional(result) : std::nullopt;
  }

  // The change of curvature in [lo, hi]: its Bernstein coefficients there.
  struct Part {
    double b[6], lo, hi;
    int halvings;

    [[nodiscard]] Part half(bool is_right) const {
      Part h = *this;
      const double middle = (lo + hi) / 2;
      (is_right ? h.lo : h.hi) = middle;
      ++h.halvings;
      if (is_right) {
        for (int k = 1; k < 6; ++k)
          for (int i = 0; i + k < 6; ++i) h.b[i] = (h.b[i] + h.b[i + 1]) / 2;
      } else {
        for (int k = 1; k < 6; ++k)
          for (int i = 5; i >= k; --i) h.b[i] = (h.b[i - 1] + h.b[i]) / 2;
      }
      return h;
    }
  };

  [[nodiscard]] std::optional<Unit_roots> change(double size) const {
    Part whole{{}, 0, 1, 0};
    const auto [b] = change_form(d_, inflection_form(d_));
    std::copy(b, b + 6, whole.b);
    Unit_roots result;
    return add_roots(whole, cubic_errors::CHANGE_COEFFICIENT * size, size, result) ? std::optional(result)
                                                                                   : std::nullopt;
  }

  bool add_roots(const Part& part, double error, double size, Unit_roots& result) const {
    unsigned plus = 0, minus = 0;  // a bit a coefficient
    for (int i = 0; i < 6; ++i) {
      plus |= unsigned(part.b[i] > error) << i;
      minus |= unsigned(part.b[i] < -error) << i;
    }
    const unsigned all = 63, changes = (plus ^ plus >> 1) & (all >> 1);
    if ((plus | minus) == all && changes == 0) return true;
    if ((plus | minus) == all && (changes & (changes - 1)) == 0) {
      const std::optional<double> root = simple_root(part, size);
      if (root) result.roots.push_back(*root);
      return root.has_value();
    }
    const bool may_halve = part.halvings < cubic_errors::MOST_HALVINGS && ((plus | minus) & 33) == 33;
    return may_halve && add_roots(part.half(false), error, size, result) &&
           add_roots(part.half(true), error, size, result);
  }

  // Newton's method from where the polygon of the coefficients changes sign, kept in a shrinking bracket.
  [[nodiscard]] std::optional<double> simple_root(const Part& part, double size) const {
    double lo = part.lo, hi = part.hi;
    const bool is_plus = part.b[0] > 0;
    int i = 0;
    while ((part.b[i + 1] > 0) == is_plus) ++i;
    double t = lo + (hi - lo) * (i + part.b[i] / (part.b[i] - part.b[i + 1])) / 5;
    for (int step = 0; step < MOST_NEWTON_STEPS; ++step) {
      const Cubic_jet<double> j = jet_at(d_, t);
      const double value = numerator<CURVATURE_CHANGE>(j), move = value / slope<CURVATURE_CHANGE>(j), next = t - move;
      ((value > 0) == is_plus ? lo : hi) = t;
      const bool is_inside = lo <= next && next <= hi;
      t = is_inside ? next : (lo + hi) / 2;
      if (is_inside && std::abs(move) <= LAST_STEP * t) break;
    }
    return nearest<CURVATURE_CHANGE>(t, part.lo, part.hi, size);
  }

  // The double nearest to the root near t, where that is proven and the root is in (lo, hi).
  template <Numerator WHICH>
  [[nodiscard]] std::optional<double> nearest(double t, double lo, double hi, double size) const {
    for (int proof = 0; proof < MOST_PROOFS; ++proof) {
      const double f = slope<WHICH>(jet_at(d_, t)), least = std::abs(f) / 2;
      const Double_double v = fine_numerator<WHICH>(t);
      const double reach = 2 * v.size() / least;
      const double slope_error = (cubic_errors::SLOPE<WHICH> + MOST_BEND<WHICH> * reach) * size * SLACK;
      if (!(slope_error <= least && lo < t - reach && t + reach < hi)) return std::nullopt;
      const double move = v.hi / f;
      const double error =
          ((std::abs(v.lo) + v.err) / least + std::abs(move) * (slope_error / least + 8 * HALF_ULP)) * SLACK;
      const double low = t - (move + error), high = t - (move - error);
      const bool is_inside = low > END_WIDTH && high < 1 - END_WIDTH;
      if (low == high && is_inside) return low;
      t = low + (high - low) / 2;
    }
    return std::nullopt;
  }

  template <Numerator WHICH> [[nodiscard]] Double_double fine_numerator(double t) const {
    const Xy<Double_double>(&d)[3] = fine_;
    if constexpr (WHICH == SPEED_X) return speed_at(d[0].x, d[1].x, d[2].x, Double_double(t));
    else if constexpr (WHICH == SPEED_Y) return speed_at(d[0].y, d[1].y, d[2].y, Double_double(t));
    else return numerator<WHICH>(jet_at(d, Double_double(t)));
  }

  bool is_served_, is_line_ = false;
  Xy<Double_double> fine_[3];
  Xy<double> d_[3];
  double width_ = 0, height_ = 0;  // of the largest differences
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
