// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A polynomial or rational (NURBS) B-spline curve of any degree from 1 over any field number type.
// Invariant: with d the degree, the knots t_0 <= t_1 <= ... are stored unwrapped, so that the span [t_k, t_(k+1)],
// k = d, ..., is ruled by the control points k-d, ..., k (modulo their number when periodic):
//
//   t_0 ... t_(d-1) | t_d  t_(d+1)  ...  t_m | t_(m+1) ... t_(m+d)     m control points, m = n + d when periodic
//                   |<------- domain ------->|

#ifndef CGAL_BOUNDING_ARCS_2_CURVE_B_SPLINE_CURVE_2_H
#define CGAL_BOUNDING_ARCS_2_CURVE_B_SPLINE_CURVE_2_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/number/strict_math.h>

#include <CGAL/assertions.h>

#include <boost/container/small_vector.hpp>

#include <cstddef>
#include <limits>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// The conditions under which control points, knots and weights make a B-spline curve, and the unwrapping of periodic
// knots. Every function throws std::invalid_argument with the index at which a condition fails.

namespace CGAL::Bounding_arcs::internal {

[[noreturn]] inline void throw_invalid(const std::string& what) { throw std::invalid_argument(what); }

inline void check_b_spline_counts(int degree, std::size_t points, bool periodic) {
  if (degree < 1) throw_invalid(expected("degree", "at least 1", degree));
  const std::size_t least = periodic ? 2 : static_cast<std::size_t>(degree) + 1;
  if (points < least)
    throw_invalid(expected("control points",
                           "at least " + text_of(least) + " of a " +
                               (periodic ? "periodic B-spline" : "B-spline of degree " + text_of(degree)),
                           points));
}

template <class NT> void check_b_spline_weights(std::size_t points, const std::vector<NT>& weights) {
  if (!weights.empty() && weights.size() != points)
    throw_invalid(expected("weights", text_of(points) + ", one a control point", weights.size()));
  for (std::size_t i = 0; i < weights.size(); ++i)
    if (!(weights[i] > NT(0)))
      throw_invalid(expected("weight " + text_of(i), "a number above 0", text_of(weights[i], "another one")));
}

template <class NT> void check_knot_order(const std::vector<NT>& knots) {
  for (std::size_t i = 1; i < knots.size(); ++i)
    if (!(knots[i - 1] <= knots[i]))
      throw_invalid(expected("knot " + text_of(i), "no less than knot " + text_of(i - 1), text_of(knots[i], "less")));
  const NT span = knots.empty() ? NT(0) : NT(knots.back() - knots.front());
  if (!(span - span == NT(0)))
    throw_invalid(expected("knots", "a finite number from the first to the last one", text_of(span, "another one")));
}

// Runs of equal knots: those with low < knot < high may be as long as `inside`, others as long as `elsewhere`. Knot i
// was given as number given(i).
template <class NT, class Given>
void check_multiplicities(const std::vector<NT>& knots, const NT& low, const NT& high, std::size_t inside,
                          std::size_t elsewhere, const Given& given) {
  for (std::size_t i = 0, run = 0; i < knots.size(); ++i) {
    run = i > 0 && knots[i] == knots[i - 1] ? run + 1 : 1;
    const bool is_inside = low < knots[i] && knots[i] < high;
    const std::size_t most = is_inside ? inside : elsewhere;
    if (run > most)
      throw_invalid(expected(
          "knot " + text_of(given(i)),
          "at most " + text_of(most) + " equal ones" + (most == inside ? ", as the curve falls apart with more" : ""),
          run));
  }
}

template <class NT> void check_b_spline_knots(int degree, std::size_t points, const std::vector<NT>& knots) {
  const std::size_t d = static_cast<std::size_t>(degree);
  if (knots.size() != points + d + 1)
    throw_invalid(expected("knots", text_of(points + d + 1) + " (control points + degree + 1)", knots.size()));
  check_knot_order(knots);
  if (!(knots[d] < knots[points]))
    throw_invalid(expected("knots", "knot " + text_of(d) + " below knot " + text_of(points), "an empty domain"));
  check_multiplicities(knots, knots[d], knots[points], d, d + 1, [](std::size_t i) { return i; });
}

// Unwrapped knots that repeat as reals are rounded to double one by one: each of four numbers is off by at most
// u max|t|, and three subtractions of numbers below 2 max|t| add at most 2u max|t| each.
// Tenfold, knots that were meant to differ by that little pass as periodic; a tenth, decimal files are refused.
constexpr double UNWRAPPED_KNOT_SLACK = 10 * HALF_ULP;

// Throws unless knots[i + n] - knots[i] is the period for every i, within the slack.
template <class NT> void check_repetition(std::size_t n, std::size_t d, const std::vector<NT>& knots) {
  const NT period = knots[d + n] - knots[d];
  const NT low = -knots.front();
  const NT& high = knots.back();
  const NT slack = NT(UNWRAPPED_KNOT_SLACK) * (low < high ? high : low);
  for (std::size_t i = 0; i + n < knots.size(); ++i) {
    const NT difference = (knots[i + n] - knots[i]) - period;
    if (!(-slack <= difference && difference <= slack))
      throw_invalid(expected("knots", "knots " + text_of(i) + " and " + text_of(i + n) + " one period apart",
                             text_of(knots[i + n] - knots[i], "another distance")));
  }
}

// The n + 2 degree + 1 unwrapped knots from one period (n + 1) or from the unwrapped form. The outer ones are
// differences to the ends of the period, so that knots equal to an end stay equal to it in rounded arithmetic too.
template <class NT> std::vector<NT> unwrapped_knots(int degree, std::size_t n, std::vector<NT> knots) {
  const std::size_t d = static_cast<std::size_t>(degree);
  if (knots.size() != n + 1 && knots.size() != n + 2 * d + 1)
    throw_invalid(expected("knots",
                           text_of(n + 1) + " (control points + 1, one period) or " + text_of(n + 2 * d + 1) +
                               " (control points + 2 degree + 1)",
                           knots.size()));
  check_knot_order(knots);
  const bool is_unwrapped = knots.size() != n + 1;
  const std::size_t start = is_unwrapped ? d : 0;
  if (!(knots[start] < knots[start + n])) throw_invalid(expected("knots", "a period above 0", "an empty domain"));
  if (is_unwrapped) check_repetition(n, d, knots);
  std::vector<NT> all(n + 2 * d + 1, NT(0));
  for (std::size_t i = 0; i <= n; ++i) all[d + i] = knots[start + i];
  for (std::size_t j = 1; j <= d; ++j) {
    all[d - j] = NT(all[d] - (all[d + n] - all[d + n - j]));
    all[d + n + j] = NT(all[d + n] + (all[d + j] - all[d]));
  }
  check_multiplicities(all, all.front(), all.back(), d, d,
                       [&](std::size_t i) { return is_unwrapped ? i : (i + (n - d % n)) % n; });
  return all;
}

}  // namespace CGAL::Bounding_arcs::internal

namespace CGAL::Bounding_arcs {

/// A polynomial or rational (NURBS) B-spline curve of any degree from 1: sum w_i P_i N_i(u) / sum w_i N_i(u) over the
/// domain. Control points are Euclidean.
/// \code
/// const auto ring = B_spline_curve_2<double>::periodic(3, {{1, 0}, {0, 1}, {-1, 0}, {0, -1}});
/// const B_spline_curve_2<double> open(2, {{0, 0}, {1, 2}, {2, 0}, {3, 1}}, {0, 0, 0, 1, 2, 2, 2});
/// const std::vector<Bezier_curve_2<double>> pieces = ring.bezier_pieces();
/// \endcode
template <class NT> class B_spline_curve_2 {
 public:
  using Number_type = NT;
  using Point = Xy<NT>;
  using Bezier = Bezier_curve_2<NT>;

  /// A closed parameter interval.
  struct Domain {
    NT lower, upper;
  };

  /// A non-periodic curve with the domain [knots[degree], knots[points.size()]], clamped or not.
  /// \param degree at least 1
  /// \param points the control points, at least degree + 1
  /// \param knots points.size() + degree + 1 numbers in non-decreasing order
  /// \param weights empty for a polynomial curve, else one positive weight a control point
  /// \pre all numbers are finite
  /// \throws std::invalid_argument when a count, a weight or the order of the knots is wrong, or the domain is empty.
  ///   So it is when a knot repeats more than degree times inside the domain (the curve would fall apart), or degree +
  ///   1 times elsewhere
  B_spline_curve_2(int degree, std::vector<Point> points, std::vector<NT> knots, std::vector<NT> weights = {})
      : degree_(degree), points_(std::move(points)), weights_(std::move(weights)) {
    internal::check_b_spline_counts(degree, points_.size(), false);
    internal::check_b_spline_weights(points_.size(), weights_);
    internal::check_b_spline_knots(degree, points_.size(), knots);
    knots_ = std::move(knots);
  }
  /// Takes a range of points of any kernel, see points_of_kernel.
  template <class Points, class = internal::Kernel_of_range<Points>>
  B_spline_curve_2(int degree, const Points& points, std::vector<NT> knots, std::vector<NT> weights = {})
      : B_spline_curve_2(degree, internal::points_of_kernel<NT>(points), std::move(knots), std::move(weights)) {}

  /// The non-periodic curve with the knots 0, 1, 2, ...: unclamped, points.size() - degree pieces, so that it does not
  /// start or end at a control point when the degree exceeds 1.
  [[nodiscard]] static B_spline_curve_2 uniform(int degree, std::vector<Point> points, std::vector<NT> weights = {}) {
    internal::check_b_spline_counts(degree, points.size(), false);
    std::vector<NT> knots;
    for (std::size_t i = 0; i < points.size() + static_cast<std::size_t>(degree) + 1; ++i)
      knots.push_back(NT(static_cast<int>(i)));
    return B_spline_curve_2(degree, std::move(points), std::move(knots), std::move(weights));
  }
  /// Takes a range of points of any kernel, see points_of_kernel.
  template <class Points, class = internal::Kernel_of_range<Points>>
  [[nodiscard]] static B_spline_curve_2 uniform(int degree, const Points& points, std::vector<NT> weights = {}) {
    return uniform(degree, internal::points_of_kernel<NT>(points), std::move(weights));
  }

  /// A closed curve of n = points.size() spans; span i is ruled by the points i, ..., i + degree (modulo n).
  /// \param degree at least 1
  /// \param points at least two control points, none repeated at the end
  /// \param knots empty for the uniform knots 0, 1, ..., n; or one period: n + 1 numbers, span i being [knots[i],
  ///   knots[i+1]]; or n + 2 degree + 1 numbers, the same with the degree neighbours on each side. Neighbours must
  ///   repeat with the period knots[degree+n] - knots[degree] but for the rounding of the numbers to double
  /// \param weights empty for a polynomial curve, else one positive weight a control point
  /// \throws std::invalid_argument as the constructor, and when unwrapped knots do not repeat; no multiplicity may
  ///   exceed the degree
  [[nodiscard]] static B_spline_curve_2 periodic(int degree, std::vector<Point> points, std::vector<NT> knots = {},
                                                 std::vector<NT> weights = {}) {
    const std::size_t n = points.size();
    internal::check_b_spline_counts(degree, n, true);
    internal::check_b_spline_weights(n, weights);
    if (knots.empty())
      for (std::size_t i = 0; i <= n; ++i) knots.push_back(NT(static_cast<int>(i)));
    B_spline_curve_2 curve;
    curve.degree_ = degree;
    curve.points_ = std::move(points);
    curve.weights_ = std::move(weights);
    curve.periodic_ = true;
    curve.knots_ = internal::unwrapped_knots(degree, n, std::move(knots));
    return curve;
  }
  /// Takes a range of points of any kernel, see points_of_kernel.
  template <class Points, class = internal::Kernel_of_range<Points>>
  [[nodiscard]] static B_spline_curve_2 periodic(int degree, const Points& points, std::vector<NT> knots = {},
                                                 std::vector<NT> weights = {}) {
    return periodic(degree, internal::points_of_kernel<NT>(points), std::move(knots), std::move(weights));
  }

  [[nodiscard]] int degree() const { return degree_; }
  [[nodiscard]] bool is_rational() const { return !weights_.empty(); }
  [[nodiscard]] bool is_periodic() const { return periodic_; }
  [[nodiscard]] const std::vector<Point>& control_points() const { return points_; }
  [[nodiscard]] const std::vector<NT>& weights() const { return weights_; }
  /// The knots, unwrapped when periodic: n + 2 degree + 1 of them.
  [[nodiscard]] const std::vector<NT>& knots() const { return knots_; }
  /// The parameters for which the curve is defined; when periodic, one period.
  [[nodiscard]] Domain domain() const { return {knots_[order() - 1], knots_[knots_.size() - order()]}; }

  /// Converts to another number type: exactly if Target holds its numbers, knots outside of a period included.
  template <class Target> [[nodiscard]] B_spline_curve_2<Target> over() const {
    const auto numbers = [](auto first, auto last) {
      std::vector<Target> result;
      for (; first != last; ++first) result.push_back(Target(*first));
      return result;
    };
    std::vector<Xy<Target>> points;
    for (const Point& p : points_) points.push_back({Target(p.x), Target(p.y)});
    std::vector<Target> weights = numbers(weights_.begin(), weights_.end());
    if (!periodic_) return {degree_, std::move(points), numbers(knots_.begin(), knots_.end()), std::move(weights)};
    const auto first = knots_.begin() + degree_, last = knots_.end() - degree_;
    return B_spline_curve_2<Target>::periodic(degree_, std::move(points), numbers(first, last), std::move(weights));
  }

  /// The point at parameter u (de Boor's algorithm).
  /// \pre u lies in the domain
  /// \guarantee exact over a field; over double convex combinations only, apart from rounding
  [[nodiscard]] Point point(const NT& u) const {
    CGAL_precondition_msg(domain().lower <= u && u <= domain().upper,
                          expected("u", "a parameter in the domain", text_of(u, "another one")).c_str());
    std::size_t k = order() - 1;
    for (std::size_t i = k; i + order() < knots_.size(); ++i)
      if (knots_[i] <= u && knots_[i] < knots_[i + 1]) k = i;
    return blossom(k, u, u, 0).point;
  }

  /// The Bezier pieces in curve order, one a knot span of positive length, at least one.
  /// \guarantee neighbours share their common end bit for bit over every number type, and so do the last and the first
  ///   when the curve is periodic. Exact over a field. Over double each coordinate of a polynomial curve is within
  ///   6 degree u max|P| of the exact one, u = 2^-53: each of degree rounds blends with ratios (3u), products (u) and a
  ///   sum (u), and products of errors stay below u; a coordinate common to all control points of a span is kept
  /// \complexity cubic in the degree for each piece
  /// \source L. Ramshaw, Blossoms are polar forms, 1989: control point j is the blossom at degree - j times the lower
  ///   and j times the upper end of the span
  [[nodiscard]] std::vector<Bezier> bezier_pieces() const {
    std::vector<Bezier> pieces;
    std::size_t last = knots_.size() - order() - 1;
    while (!(knots_[last] < knots_[last + 1])) --last;
    pieces.reserve(last + 2 - order());
    Control first, end;
    for (std::size_t k = order() - 1; k <= last; ++k) {
      if (!(knots_[k] < knots_[k + 1])) continue;
      if (pieces.empty()) first = end = blossom(k, knots_[k], knots_[k + 1], 0);
      Controls controls{end};
      for (int j = 1; j < degree_; ++j) controls.push_back(blossom(k, knots_[k], knots_[k + 1], j));
      end = periodic_ && k == last ? first : blossom(k, knots_[k], knots_[k + 1], degree_);
      controls.push_back(end);
      pieces.push_back(bezier(controls));
    }
    return pieces;
  }

  /// Writes a line for the degree and the knots, and one for each control point: x and y, and the weight of a rational
  /// curve.
  friend std::ostream& operator<<(std::ostream& out, const B_spline_curve_2& curve) {
    out << curve.degree();
    for (const NT& knot : curve.knots()) out << ' ' << knot;
    out << '\n';
    for (std::size_t i = 0; i < curve.control_points().size(); ++i) {
      out << curve.control_points()[i];
      if (curve.is_rational()) out << ' ' << curve.weights()[i];
      out << '\n';
    }
    return out;
  }

 private:
  struct Control {
    Point point;
    NT weight{1};
  };
  using Controls = boost::container::small_vector<Control, 8>;  // of degrees up to 7 without an allocation

  B_spline_curve_2() = default;

  [[nodiscard]] std::size_t order() const { return static_cast<std::size_t>(degree_) + 1; }

  // The blossom of span k at a (degree - j times) and b (j times). The blossom is symmetric; the argument that comes
  // more often goes first, which makes most ratios 0 or 1 and so saves roundings.
  [[nodiscard]] Control blossom(std::size_t k, const NT& a, const NT& b, int j) const {
    const std::size_t d = order() - 1;
    Controls c;
    for (std::size_t i = k - d; i <= k; ++i) {
      const std::size_t at = i % points_.size();
      c.push_back({points_[at], weights_.empty() ? NT(1) : weights_[at]});
    }
    const bool b_first = 2 * j > degree_;
    const std::size_t first = static_cast<std::size_t>(b_first ? j : degree_ - j);
    for (std::size_t round = 1; round <= d; ++round) {
      const NT& u = (round <= first) == b_first ? b : a;
      for (std::size_t i = d; i >= round; --i) {
        const NT &low = knots_[k - d + i], &high = knots_[k + 1 + i - round];
        const NT length = high - low;
        blend(NT((high - u) / length), c[i - 1], NT((u - low) / length), c[i]);
      }
    }
    return c[d];
  }

  // q becomes s p + t q; for rational curves with the ratio of the blended weights, so that points stay Euclidean.
  void blend(const NT& s, const Control& p, const NT& t, Control& q) const {
    const NT w0 = s * p.weight, w1 = t * q.weight, sum = w0 + w1;
    const NT r0 = is_rational() ? NT(w0 / sum) : s, r1 = is_rational() ? NT(w1 / sum) : t;
    q.point = {mixed(r0, p.point.x, r1, q.point.x), mixed(r0, p.point.y, r1, q.point.y)};
    if (is_rational()) q.weight = sum;
  }

  // s x + t y for s + t = 1; equal numbers are kept as they are, so a vertical line stays vertical in double.
  [[nodiscard]] static NT mixed(const NT& s, const NT& x, const NT& t, const NT& y) {
    return x == y ? x : NT(s * x + t * y);
  }

  [[nodiscard]] Bezier bezier(const Controls& controls) const {
    std::vector<Point> points;
    std::vector<NT> weights;
    points.reserve(controls.size());
    for (const Control& c : controls) {
      points.push_back(c.point);
      if (is_rational()) weights.push_back(c.weight);
    }
    return Bezier(std::move(points), std::move(weights));
  }

  int degree_ = 1;
  bool periodic_ = false;
  std::vector<Point> points_;
  std::vector<NT> knots_;
  std::vector<NT> weights_;
};

}  // namespace CGAL::Bounding_arcs

#endif
