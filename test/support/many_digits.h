// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points and curves of arrangements in 100 digits, with Newton's method and halving: shares nothing with the decisions
// under test.

#ifndef BOUNDING_ARCS_TEST_MANY_DIGITS_H
#define BOUNDING_ARCS_TEST_MANY_DIGITS_H

#include <CGAL/Bounding_arcs_2/arrangement/Arr_curve_2.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace bounding_arcs_test {

using Many_digits = boost::multiprecision::cpp_bin_float_100;

struct Digits_point {
  Many_digits x, y;
};

/// A point of a curve and the derivative by the parameter, by de Casteljau's scheme on x w, y w and w.
struct Digits_jet {
  Digits_point point, first;
};
inline Digits_jet digits_jet(const CGAL::Bounding_arcs::Bezier_curve_2<double>& c, const Many_digits& t) {
  struct Row {
    Many_digits x, y, w;
  };
  std::vector<Row> rows;
  for (int i = 0; i <= c.degree(); ++i) {
    const auto& p = c.control_points()[static_cast<std::size_t>(i)];
    const Many_digits w = c.weight(i);
    rows.push_back({w * p.x, w * p.y, w});
  }
  const Many_digits s = 1 - t;
  while (rows.size() > 2) {
    for (std::size_t i = 0; i + 1 < rows.size(); ++i)
      rows[i] = {s * rows[i].x + t * rows[i + 1].x, s * rows[i].y + t * rows[i + 1].y,
                 s * rows[i].w + t * rows[i + 1].w};
    rows.pop_back();
  }
  const Row &a = rows[0], &b = rows[1];
  const Many_digits w = s * a.w + t * b.w, x = (s * a.x + t * b.x) / w, y = (s * a.y + t * b.y) / w;
  const int n = c.degree();
  return {{x, y}, {n * ((b.x - a.x) - (b.w - a.w) * x) / w, n * ((b.y - a.y) - (b.w - a.w) * y) / w}};
}

/// Where x turns, or y where x does not, in a range of parameters.
struct Digits_turn {
  Digits_point point;
  bool is_turn;
};
inline Digits_turn digits_turn(const CGAL::Bounding_arcs::Bezier_curve_2<double>& c,
                               const CGAL::Bounding_arcs::Bracket& range) {
  for (const bool is_x : {true, false}) {
    const auto slope = [&](const Many_digits& t) {
      const Digits_point first = digits_jet(c, t).first;
      return is_x ? first.x : first.y;
    };
    Many_digits low = range.lower, high = range.upper;
    const Many_digits first = slope(low), last = slope(high);
    if (first * last > 0 || (first == 0 && last == 0)) continue;
    const bool rises = first < 0;
    constexpr int HALVINGS = 330;
    for (int i = 0; i < HALVINGS; ++i) {
      const Many_digits half = (low + high) / 2;
      ((slope(half) < 0) == rises ? low : high) = half;
    }
    return {digits_jet(c, low).point, true};
  }
  return {digits_jet(c, range.lower).point, false};
}

/// Where a curve crosses another one that is next to it, by halving for a change of sides; Newton's method may leave
/// such a place for another one.
inline Digits_point digits_crossing(const CGAL::Bounding_arcs::Bezier_curve_2<double>& a,
                                    const CGAL::Bounding_arcs::Bezier_curve_2<double>& b,
                                    const CGAL::Bounding_arcs::Bracket& range, Many_digits s) {
  const auto side = [&](const Many_digits& t) {
    const Digits_point p = digits_jet(a, t).point;
    const auto away = [&](const Digits_jet& j) { return Digits_point{p.x - j.point.x, p.y - j.point.y}; };
    constexpr int STEPS = 60;
    for (int i = 0; i < STEPS; ++i) {  // to the foot, nearly
      const Digits_jet j = digits_jet(b, s);
      const Digits_point w = away(j);
      s += (w.x * j.first.x + w.y * j.first.y) / (j.first.x * j.first.x + j.first.y * j.first.y);
    }
    const Digits_jet j = digits_jet(b, s);
    const Digits_point w = away(j);
    return j.first.x * w.y - j.first.y * w.x;
  };
  Many_digits low = range.lower, high = range.upper;
  const bool is_left = side(low) > 0;
  constexpr int HALVINGS = 330;
  for (int i = 0; i < HALVINGS; ++i) {
    const Many_digits half = (low + high) / 2;
    ((side(half) > 0) == is_left ? low : high) = half;
  }
  return digits_jet(a, low).point;
}

/// The point in many digits: a pair of doubles, a turn, or a common point of two curves, from where doubles say it is.
inline Digits_point digits_point(const CGAL::Bounding_arcs::Arr_point_2& p) {
  const auto& data = *p.data();
  if (data.is_double()) return {data.x.lower, data.y.lower};
  const auto middle = [](const CGAL::Bounding_arcs::Bracket& b) { return b.lower + b.width() / 2; };
  if (data.turning) return digits_turn(data.turning->bezier(), data.places.front().t).point;
  const auto &first = data.pair->a->bezier(), &second = data.pair->b->bezier();
  for (const auto& [curve, at] : {std::pair(&first, &data.t), std::pair(&second, &data.s)})
    if (const Digits_turn turn = digits_turn(*curve, *at); turn.is_turn) return turn.point;
  Many_digits t = middle(data.t), s = middle(data.s);
  constexpr int STEPS = 250;  // a tangency halves the error in each
  for (int i = 0; i < STEPS; ++i) {
    const Digits_jet a = digits_jet(first, t), b = digits_jet(second, s);
    const Many_digits x = b.point.x - a.point.x, y = b.point.y - a.point.y,
                      det = b.first.x * a.first.y - a.first.x * b.first.y;
    if (det == 0 || (x == 0 && y == 0)) break;
    t += (b.first.x * y - b.first.y * x) / det;
    s += (a.first.x * y - a.first.y * x) / det;
  }
  if (t < data.t.lower - data.t.width() || t > data.t.upper + data.t.width())
    return digits_crossing(first, second, data.t, middle(data.s));
  return digits_jet(first, t).point;
}

/// The y of a part at an x in its range, by Newton's method and, where that leaves what is known, by halving.
inline Many_digits digits_y(const CGAL::Bounding_arcs::Arr_curve_2::Part& c, const Many_digits& x) {
  const auto& bezier = c.data()->bezier();
  Many_digits low = c.left_parameter().lower, high = c.right_parameter().upper;  // left and right of x
  if (!c.is_rising()) low = c.left_parameter().upper, high = c.right_parameter().lower;
  Many_digits t = (low + high) / 2;
  Digits_jet jet = digits_jet(bezier, t);
  constexpr int STEPS = 330;
  for (int i = 0; i < STEPS && abs(jet.point.x - x) > Many_digits("1e-97"); ++i) {
    (jet.point.x < x ? low : high) = t;
    t -= (jet.point.x - x) / jet.first.x;
    if (!((low < t && t < high) || (high < t && t < low))) t = (low + high) / 2;
    jet = digits_jet(bezier, t);
  }
  return jet.point.y;
}

}  // namespace bounding_arcs_test

#endif
