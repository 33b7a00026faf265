// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pairs of curves of which doubles tell little: weights that differ by up to 10^10 or one by itself, tiny and large
// pieces, control points that are repeated, coordinates with few digits that meet exactly.  And what many digits tell
// of them: points where t / (1 - t) is spread evenly over all magnitudes, as such curves run most of their way in a
// tiny part of their parameters.

#ifndef BOUNDING_ARCS_TEST_EXTREME_PAIRS_H
#define BOUNDING_ARCS_TEST_EXTREME_PAIRS_H

#include "query_drawings.h"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace bounding_arcs_test {

struct Curve_pair {
  Bezier a, b;
};

class Extreme_pairs {
 public:
  explicit Extreme_pairs(unsigned seed) : random_(seed) {}

  [[nodiscard]] Curve_pair operator()() {
    const std::size_t kind = random_() % 8;
    Bezier a = curve(kind);
    if (kind == 6) return {a, reversed(a)};
    if (kind == 7) return {a, moved_by(a, std::exp2(uniform(-40, 0)))};
    Bezier b = curve(random_() % 6);
    return {std::move(a), std::move(b)};
  }

 private:
  [[nodiscard]] double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  [[nodiscard]] double power_of_10(double exponent) { return std::pow(10, uniform(-exponent, exponent)); }
  [[nodiscard]] double number(bool is_short) {
    return is_short ? static_cast<double>(random_() % 7) / 2 - 1.5 : uniform(-1.5, 1.5);
  }

  [[nodiscard]] Bezier curve(std::size_t kind) {
    const bool is_short = random_() % 3 != 0, repeats = kind == 3 || random_() % 4 == 0;
    const std::size_t n = 2 + random_() % 5;
    const double scale = kind == 4 ? power_of_10(9) : 1;
    std::vector<Point> points;
    for (std::size_t i = 0; i < n; ++i) {
      const double x = number(is_short), y = number(is_short);
      points.push_back(repeats && i > 0 && random_() % 2 == 0 ? points[random_() % i] : scale * Point{x, y});
    }
    std::vector<double> weights(n, 1.0);
    if (kind == 1) weights[random_() % n] = std::pow(10, uniform(-6, 9));
    else if (kind != 5)
      for (double& w : weights) w = power_of_10(5);
    return Bezier(std::move(points), std::move(weights));
  }
  [[nodiscard]] static Bezier reversed(const Bezier& curve) {
    auto points = curve.control_points();
    auto weights = curve.weights();
    std::reverse(points.begin(), points.end());
    std::reverse(weights.begin(), weights.end());
    return Bezier(std::move(points), std::move(weights));
  }
  [[nodiscard]] Bezier moved_by(const Bezier& curve, double by) {
    auto points = curve.control_points();
    for (Point& p : points) p = p + Point{by, by * number(true)};
    return Bezier(std::move(points), curve.weights());
  }

  std::mt19937 random_;
};

/// As the tool reads it.
inline std::string json_of(const Bezier& curve) {
  std::ostringstream out;
  out.precision(17);
  out << R"({"type":"bezier","degree":)" << curve.degree() << R"(,"control_points":[)";
  for (int i = 0; i <= curve.degree(); ++i) {
    const Point& p = curve.control_points()[static_cast<std::size_t>(i)];
    out << (i > 0 ? "," : "") << '[' << p.x << ',' << p.y << ']';
  }
  out << "],\"weights\":[";
  for (int i = 0; i <= curve.degree(); ++i) out << (i > 0 ? "," : "") << curve.weight(i);
  out << "]}";
  return out.str();
}

/// A curve in many digits, and points of it.
class Precise_curve {
 public:
  using Number = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;
  struct Place {
    Number t, point_x, point_y;
    [[nodiscard]] double distance(const Place& q) const {
      const Number dx = point_x - q.point_x, dy = point_y - q.point_y;
      return static_cast<double>(sqrt(Number(dx * dx + dy * dy)));
    }
  };

  explicit Precise_curve(const Bezier& curve) : curve_(curve) {
    constexpr int MOST = 44;  // t / (1 - t) from 2^-44 to 2^44
    places_.push_back(at(0, 1));
    for (int i = -MOST * PER_OCTAVE; i <= MOST * PER_OCTAVE; ++i) places_.push_back(at_ratio(ratio(i)));
    places_.push_back(at(1, 0));
  }

  [[nodiscard]] const std::vector<Place>& places() const { return places_; }
  [[nodiscard]] Place at(const Number& t) const { return at(t, 1 - t); }
  /// First and second derivatives by the parameter.
  [[nodiscard]] std::pair<Point, Point> derivatives(const Number& t) const {
    // differences of the homogeneous coordinates, order by order
    std::vector<Homogeneous> c = coefficients();
    Homogeneous value[3];
    for (int order = 0; order < 3; ++order) {
      value[order] = c.empty() ? Homogeneous{0, 0, 0} : last_of(c, t, 1 - t);
      std::vector<Homogeneous> next;
      const Number degree = static_cast<int>(c.size()) - 1;
      for (std::size_t i = 0; i + 1 < c.size(); ++i)
        next.push_back(
            {degree * (c[i + 1].x - c[i].x), degree * (c[i + 1].y - c[i].y), degree * (c[i + 1].w - c[i].w)});
      c = std::move(next);
    }
    const auto of = [&](Number Homogeneous::*axis) {
      const Number point = value[0].*axis / value[0].w, first = (value[1].*axis - value[1].w * point) / value[0].w,
                   second = (value[2].*axis - 2 * value[1].w * first - value[2].w * point) / value[0].w;
      return std::pair(static_cast<double>(first), static_cast<double>(second));
    };
    const auto x = of(&Homogeneous::x), y = of(&Homogeneous::y);
    return {Point{x.first, y.first}, Point{x.second, y.second}};
  }

  /// The least distance from a place: of samples, and of more about the nearest ones.
  [[nodiscard]] double distance(const Place& q) const {
    std::vector<double> d;
    for (const Place& p : places_) d.push_back(p.distance(q));
    double least = *std::min_element(d.begin(), d.end());
    for (std::size_t i = 0; i < d.size(); ++i) {
      const std::size_t before = i == 0 ? 0 : i - 1, next = (std::min)(i + 1, d.size() - 1);
      if (d[before] < d[i] || d[next] < d[i]) continue;
      const double beside = places_[before].distance(places_[i]) + places_[i].distance(places_[next]);
      if (d[i] - beside < least) least = (std::min)(least, refined(q, places_[before].t, places_[next].t));
    }
    return least;
  }

 private:
  static constexpr int PER_OCTAVE = 3;
  [[nodiscard]] static Number ratio(int i) { return pow(Number(2), Number(i) / PER_OCTAVE); }
  [[nodiscard]] Place at_ratio(const Number& x) const { return at(x / (1 + x), 1 / (1 + x)); }
  struct Homogeneous {
    Number x, y, w;
  };
  [[nodiscard]] std::vector<Homogeneous> coefficients() const {
    std::vector<Homogeneous> c;
    for (int i = 0; i <= curve_.degree(); ++i) {
      const Point& p = curve_.control_points()[static_cast<std::size_t>(i)];
      const Number w = curve_.weight(i);
      c.push_back({w * Number(p.x), w * Number(p.y), w});
    }
    return c;
  }
  [[nodiscard]] static Homogeneous last_of(std::vector<Homogeneous> c, const Number& t, const Number& s) {
    for (std::size_t k = c.size(); k-- > 1;)
      for (std::size_t i = 0; i < k; ++i)
        for (Number Homogeneous::*axis : {&Homogeneous::x, &Homogeneous::y, &Homogeneous::w})
          c[i].*axis = s * c[i].*axis + t * c[i + 1].*axis;
    return c.front();
  }
  [[nodiscard]] Place at(const Number& t, const Number& s) const {
    const Homogeneous c = last_of(coefficients(), t, s);
    return {t, c.x / c.w, c.y / c.w};
  }
  // Thirds, as if there were one least value between two parameters.
  [[nodiscard]] double refined(const Place& q, Number low, Number high) const {
    double least = HUGE_VAL;
    constexpr int STEPS = 60;
    for (int i = 0; i < STEPS; ++i) {
      const Number third = (high - low) / 3, left = low + third, right = high - third;
      const double d = at(left).distance(q), e = at(right).distance(q);
      least = (std::min)({least, d, e});
      (d < e ? high : low) = d < e ? right : left;
    }
    return least;
  }

  Bezier curve_;
  std::vector<Place> places_;
};

}  // namespace bounding_arcs_test

#endif
