// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Random curves of the kinds that formulas, cuts and proofs have met their ends on, and their relatives: scaled by
// powers of two, moved, turned, mirrored, reversed, of raised degree, and with a part of the parameters in place of
// all.

#ifndef BOUNDING_ARCS_TEST_DEGENERATE_CURVES_H
#define BOUNDING_ARCS_TEST_DEGENERATE_CURVES_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "random_spirals.h"

namespace bounding_arcs_test {

enum class Kind { BACK_AND_FORTH, PALINDROME, NEAR_CUSP, THIN, EXTREME_WEIGHTS, EXTREME_ASPECT, STEEP_ENDS };
inline constexpr Kind ALL_KINDS[] = {Kind::BACK_AND_FORTH,  Kind::PALINDROME,     Kind::NEAR_CUSP, Kind::THIN,
                                     Kind::EXTREME_WEIGHTS, Kind::EXTREME_ASPECT, Kind::STEEP_ENDS};
inline std::string name(Kind kind) {
  constexpr const char* NAMES[] = {"BackAndForth",   "Palindrome",    "NearCusp", "Thin",
                                   "ExtremeWeights", "ExtremeAspect", "SteepEnds"};
  return NAMES[static_cast<int>(kind)];
}

class Degenerate_curves {
 public:
  explicit Degenerate_curves(unsigned seed) : random_(seed) {}

  /// A curve of the kind or a relative of one.
  [[nodiscard]] Bezier operator()(Kind kind) { return relative(plain(kind), kind); }

  /// A tolerance for it, from a hundredth of its size to all of it, now and then a thousandth.
  [[nodiscard]] double eps(const Bezier& curve) {
    Point low = curve.control_points().front(), high = low;
    for (const Point& p : curve.control_points()) {
      low = {(std::min)(low.x, p.x), (std::min)(low.y, p.y)};
      high = {(std::max)(high.x, p.x), (std::max)(high.y, p.y)};
    }
    const double size = (std::max)(high.x / 2 - low.x / 2, high.y / 2 - low.y / 2);
    return (std::max)(size, 0x1p-1000) * std::pow(10, one_in(8) ? uniform(-3, -2) : uniform(-2, 0));
  }

  [[nodiscard]] std::size_t below(std::size_t n) { return random_() % n; }

 private:
  using Points = std::vector<Point>;

  [[nodiscard]] double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  [[nodiscard]] double power(double low, double high) { return std::exp2(uniform(low, high)); }
  [[nodiscard]] bool one_in(std::size_t n) { return below(n) == 0; }
  // Numbers with few digits meet exactly where others only come near.
  [[nodiscard]] double number(bool is_short) {
    return is_short ? static_cast<double>(below(17)) / 4 - 2 : uniform(-2, 2);
  }
  [[nodiscard]] Point point(bool is_short) {
    const double x = number(is_short);
    return {x, number(is_short)};
  }
  [[nodiscard]] Points points(std::size_t count, bool is_short) {
    Points p;
    for (std::size_t i = 0; i < count; ++i) p.push_back(point(is_short));
    return p;
  }
  [[nodiscard]] std::vector<double> weights(std::size_t count, double exponent) {
    std::vector<double> w;
    for (std::size_t i = 0; i < count; ++i) w.push_back(power(-exponent, exponent));
    return w;
  }

  [[nodiscard]] Bezier plain(Kind kind) {
    switch (kind) {
      case Kind::BACK_AND_FORTH:
        return back_and_forth();
      case Kind::PALINDROME:
        return palindrome();
      case Kind::NEAR_CUSP:
        return near_cusp();
      case Kind::THIN:
        return thin();
      case Kind::EXTREME_WEIGHTS: {
        const std::size_t n = 3 + below(4);
        Points p = points(n, one_in(2));
        return Bezier(std::move(p), weights(n, one_in(2) ? uniform(1, 12) : uniform(1, 24)));
      }
      case Kind::STEEP_ENDS:
        return steep_ends();
      case Kind::EXTREME_ASPECT:
        break;
    }
    Points p = points(3 + below(4), one_in(3));
    const double size = power(-820, 996), aspect = power(-920, 0);  // some of what is refused, too
    const double x = one_in(2) ? size : size * aspect, y = x == size ? size * aspect : size;
    for (Point& q : p) q = {q.x * x, q.y * y};
    const std::size_t n = p.size();
    return one_in(3) ? Bezier(std::move(p), weights(n, 2)) : Bezier(std::move(p));
  }

  [[nodiscard]] Bezier back_and_forth() {
    const bool is_short = !one_in(3);
    const Point start = one_in(2) ? Point{} : point(is_short), direction = point(is_short);
    Points p;
    const std::size_t n = 2 + below(6);
    for (std::size_t i = 0; i < n; ++i) {
      const double s = one_in(3) ? static_cast<double>(below(3)) : number(is_short);
      p.push_back({start.x + s * direction.x, start.y + s * direction.y});
    }
    return one_in(4) ? Bezier(std::move(p), weights(n, 2)) : Bezier(std::move(p));
  }

  [[nodiscard]] Bezier palindrome() {
    Points half = points(2 + below(3), one_in(3));
    std::vector<double> w = weights(half.size(), 1.5);
    const bool is_rational = one_in(4), repeats_middle = one_in(2);
    Points p = half;
    std::vector<double> all = w;
    for (std::size_t i = half.size() - (repeats_middle ? 0 : 1); i-- > 0;) {
      p.push_back(half[i]);
      all.push_back(w[i]);
    }
    return is_rational ? Bezier(std::move(p), std::move(all)) : Bezier(std::move(p));
  }

  // Handles that cross at a cusp where d = 0, and a loop or a bend beside it.
  [[nodiscard]] Bezier near_cusp() {
    const double d = one_in(4) ? 0 : (one_in(2) ? 1 : -1) * power(-55, -2);
    Points p{{0, 0}, {1, 1}, {d, 1}, {1, 0}};
    const double xx = number(false), xy = number(false), yx = number(false), yy = number(false);
    if (one_in(2))
      for (Point& q : p) q = {xx * q.x + xy * q.y, yx * q.x + yy * q.y};
    return one_in(5) ? Bezier(std::move(p), weights(4, one_in(2) ? 0.01 : 1)) : Bezier(std::move(p));
  }

  [[nodiscard]] Bezier thin() {
    Points p = points(3 + below(4), one_in(3));
    const double height = power(-60, -3), angle = uniform(0, 7);
    const bool turns = one_in(2);
    for (Point& q : p) {
      q.y *= height;
      if (turns) q = {q.x * std::cos(angle) - q.y * std::sin(angle), q.x * std::sin(angle) + q.y * std::cos(angle)};
    }
    const std::size_t n = p.size();
    return one_in(4) ? Bezier(std::move(p), weights(n, 2)) : Bezier(std::move(p));
  }

  // Short handles aside of the way: the curve leaves its ends at another angle, with a radius far below its length.
  [[nodiscard]] Bezier steep_ends() {
    Points p{{0, 0}, {0, 0}, {1, 0}, {1, 0}};
    if (one_in(4)) p.insert(p.begin() + 2, point(one_in(2)));
    const std::size_t last = p.size() - 1;
    for (const bool at_end : {false, true}) {
      const double size = power(one_in(4) ? -400 : -50, -5);
      const Point way = one_in(3) ? Point{0, 1} : (one_in(2) ? Point{1, 0} : point(true));
      Point& handle = p[at_end ? last - 1 : 1];
      handle = handle + (at_end ? -size : size) * way;
      if (one_in(2)) handle.y += power(-50, -5);
    }
    return one_in(5) ? Bezier(std::move(p), weights(last + 1, one_in(2) ? 1 : 8)) : Bezier(std::move(p));
  }

  [[nodiscard]] Bezier relative(Bezier curve, Kind kind) {
    if (one_in(5)) curve = elevated(curve);
    if (one_in(6)) curve = part(curve);
    Points p = curve.control_points();
    std::vector<double> w = curve.weights();
    if (one_in(3)) {
      std::reverse(p.begin(), p.end());
      std::reverse(w.begin(), w.end());
    }
    const double mirror = one_in(3) ? -1 : 1;
    const bool swaps = one_in(3);
    const double scale =
        kind != Kind::EXTREME_ASPECT && one_in(4) ? std::ldexp(1.0, static_cast<int>(below(1201)) - 600) : 1;
    const double far = one_in(5) ? power(0, 30) : 0;
    const Point move{far * scale, -far * scale / 2};
    for (Point& q : p) {
      q = {scale * q.x, scale * mirror * q.y};
      if (swaps) q = {q.y, q.x};
      if (far != 0 && kind != Kind::EXTREME_ASPECT) q = q + move;
    }
    return Bezier(std::move(p), std::move(w));
  }
  [[nodiscard]] static Bezier elevated(const Bezier& curve) {
    const std::size_t n = curve.control_points().size();
    Points p{curve.control_points().front()};
    std::vector<double> w;
    if (curve.is_rational()) w.push_back(curve.weights().front());
    for (std::size_t i = 1; i < n; ++i) {
      const double s = static_cast<double>(i) / static_cast<double>(n);
      const Point &before = curve.control_points()[i - 1], &here = curve.control_points()[i];
      const double v0 = s * curve.weight(static_cast<int>(i) - 1), v1 = (1 - s) * curve.weight(static_cast<int>(i));
      p.push_back((1 / (v0 + v1)) * (v0 * before + v1 * here));
      if (curve.is_rational()) w.push_back(v0 + v1);
    }
    p.push_back(curve.control_points().back());
    if (curve.is_rational()) w.push_back(curve.weights().back());
    return Bezier(std::move(p), std::move(w));
  }
  [[nodiscard]] Bezier part(const Bezier& curve) {
    const double t = one_in(2) ? 0.5 : uniform(0.1, 0.9);
    const auto halves = curve.split(t);
    return one_in(2) ? halves.first : halves.second;
  }

  std::mt19937 random_;
};

}  // namespace bounding_arcs_test

#endif
