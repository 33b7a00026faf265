// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Common points of two Bezier pieces (query/intersections.h). The plain algorithm is exact_intersections. Before it
// stands a search in doubles over control polygons; where it leaves anything open, it is forgotten.

#include "Newton_box.h"
#include "exact_intersections.h"

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/curve/Unit.h>
#include <CGAL/Bounding_arcs_2/curve/served_range.h>
#include <CGAL/Bounding_arcs_2/query/intersections.h>
#include "../curve/exact_bezier.h"

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>

// Common points of two single Bezier pieces in doubles, each proven, or that it is left open.  Cutting a piece into
// spiral segments costs more than this question does, so that it is asked of control polygons, which are halved.
//
// A and B are within the hulls of their control points, and their tangents are combinations with coefficients that are
// not negative of the differences a_i and b_j of control points: of neighbours, of any two where there are weights.  If
// all cross(a_i, b_j) have one sign, tangents are nowhere parallel, and there is one common point at most: a chord
// between two would be such a combination of the a_i and, up to its sign, of the b_j, and cross(v, v) is 0.
// What is done with that is as in Segment_pair_search.h.

namespace CGAL::Bounding_arcs::internal {

/// The control polygon of [t0, t1] of a piece.
/// \tparam MOST the largest degree
template <std::size_t MOST> struct Control_piece {
  Xy<double> points[MOST + 1];
  double weights[MOST + 1];  // all 1 of a polynomial piece, and not looked at
  double t0 = 0, t1 = 1;
  double error = 0;      // how far the points may be from the exact ones
  Xy<double> low, high;  // of the points
};

struct Polygon_results {
  boost::container::small_vector<Newton_box, 9> roots;
  boost::container::small_vector<Bracket, 4> ends;                // (t, s) of common ends
  boost::container::small_vector<std::array<double, 4>, 2> open;  // t0, t1, s0, s1
};

template <std::size_t MOST> class Polygon_search {
  using Piece = Control_piece<MOST>;

 public:
  Polygon_search(const Bezier_curve_2<double>& a, const Bezier_curve_2<double>& b)
      : degree_{a.control_points().size() - 1, b.control_points().size() - 1}, is_rational_{a.is_rational(),
                                                                                            b.is_rational()},
        evaluator_a_(a), evaluator_b_(b) {
    refine(piece_of(a, A), piece_of(b, B));
  }
  [[nodiscard]] const Polygon_results& results() const { return results_; }

 private:
  static constexpr int A = 0, B = 1;
  static constexpr int MOST_PAIRS = 200;
  // What a tangency takes down to where polygons are as long as the roundings of points.
  int budget_ = MOST_PAIRS;

  [[nodiscard]] Piece piece_of(const Bezier_curve_2<double>& curve, int which) const {
    Piece piece;
    for (std::size_t i = 0; i < curve.control_points().size(); ++i) {
      piece.points[i] = curve.control_points()[i];
      piece.weights[i] = curve.weight(static_cast<int>(i));
    }
    set_box(piece, which);
    return piece;
  }

  void refine(const Piece& a, const Piece& b) {
    if (are_boxes_apart(a, b) || is_beside_chord(a, A, b, B) || is_beside_chord(b, B, a, A)) return;
    const bool are_transversal = have_transversal_tangents(a, b);
    if (is_settled_at_end(a, b, are_transversal)) return;
    if (are_transversal && is_settled_by_newton(a, b)) return;
    const double size_a = size(a), size_b = size(b);
    constexpr double LEAST = 64;  // times the errors
    const double least = LEAST * (a.error + b.error + evaluator_a_.point_error() + evaluator_b_.point_error());
    const bool of_a = size_a >= size_b;
    const Piece& longer = of_a ? a : b;
    const double middle = longer.t0 + (longer.t1 - longer.t0) / 2;
    if (--budget_ < 0 || (std::max)(size_a, size_b) < least || !(longer.t0 < middle && middle < longer.t1)) {
      results_.open.push_back({a.t0, a.t1, b.t0, b.t1});
      return;
    }
    Piece first, second;
    halve(longer, of_a ? A : B, middle, first, second);
    for (const Piece* half : {&first, &second}) {
      if (of_a) refine(*half, b);
      else refine(a, *half);
    }
  }

  // A step is a mean of two points, which rounds by u of coordinates twice; a weighted one by 4 u and by 3 u of
  // weights.
  void halve(const Piece& whole, int which, double middle, Piece& first, Piece& second) const {
    const std::size_t n = degree_[which];
    const Bezier_evaluator& curve = which == A ? evaluator_a_ : evaluator_b_;
    second = whole;
    first.points[0] = whole.points[0];
    first.weights[0] = whole.weights[0];
    for (std::size_t k = 1; k <= n; ++k) {
      for (std::size_t i = 0; i + k <= n; ++i) {
        Xy<double>&p = second.points[i], &q = second.points[i + 1];
        if (is_rational_[which]) {
          const double w = second.weights[i], v = second.weights[i + 1], share = w / (w + v);
          p = {share * p.x + (1 - share) * q.x, share * p.y + (1 - share) * q.y};
          second.weights[i] = 0.5 * (w + v);
        } else {
          p = {0.5 * (p.x + q.x), 0.5 * (p.y + q.y)};
        }
      }
      first.points[k] = second.points[0];
      first.weights[k] = second.weights[0];
    }
    constexpr double OF_MEAN = 2 * 1.5, OF_WEIGHTED_MEAN = 12 * 1.5;  // 1.5 for sqrt 2 of both coordinates
    const double rounding = static_cast<double>(n) * (is_rational_[which] ? OF_WEIGHTED_MEAN : OF_MEAN) * HALF_ULP *
                            curve.coordinate_size();
    first.error = second.error = whole.error + rounding;
    first.t0 = whole.t0;
    first.t1 = second.t0 = middle;
    second.t1 = whole.t1;
    set_box(first, which);
    set_box(second, which);
  }

  void set_box(Piece& p, int which) const {
    p.low = p.high = p.points[0];
    for (std::size_t i = 1; i <= degree_[which]; ++i) {
      p.low = {(std::min)(p.low.x, p.points[i].x), (std::min)(p.low.y, p.points[i].y)};
      p.high = {(std::max)(p.high.x, p.points[i].x), (std::max)(p.high.y, p.points[i].y)};
    }
  }
  [[nodiscard]] static double size(const Piece& p) { return (std::max)(p.high.x - p.low.x, p.high.y - p.low.y); }
  [[nodiscard]] bool are_boxes_apart(const Piece& a, const Piece& b) const {
    const double room = (a.error + b.error) * ROUNDED_UP<4> + 2 * HALF_ULP * evaluator_a_.coordinate_size();
    return b.low.x - a.high.x > room || a.low.x - b.high.x > room || b.low.y - a.high.y > room ||
           a.low.y - b.high.y > room;
  }
  // Whether b is on one side of the strip along the chord that holds a. Products of differences round by 4 u each.
  [[nodiscard]] bool is_beside_chord(const Piece& a, int which_a, const Piece& b, int which_b) const {
    const Xy<double> origin = a.points[0], chord = a.points[degree_[which_a]] - origin;
    double low_a = 0, high_a = 0, farthest = std::fabs(chord.x) + std::fabs(chord.y);
    for (std::size_t i = 1; i < degree_[which_a]; ++i) {
      const Xy<double> v = a.points[i] - origin;
      const double y = cross(chord, v);
      low_a = (std::min)(low_a, y);
      high_a = (std::max)(high_a, y);
      farthest = (std::max)(farthest, std::fabs(v.x) + std::fabs(v.y));
    }
    double low_b = std::numeric_limits<double>::infinity(), high_b = -low_b;
    for (std::size_t i = 0; i <= degree_[which_b]; ++i) {
      const Xy<double> v = b.points[i] - origin;
      const double y = cross(chord, v);
      low_b = (std::min)(low_b, y);
      high_b = (std::max)(high_b, y);
      farthest = (std::max)(farthest, std::fabs(v.x) + std::fabs(v.y));
    }
    const double slack = euclidean_norm(chord) * ((a.error + b.error) * ROUNDED_UP<8> + 16 * HALF_ULP * farthest);
    return low_b - high_a > slack || low_a - high_b > slack;
  }

  // Calls visit(difference) for those that tangents are made of, until it returns false.
  template <class Visit> [[nodiscard]] bool for_each_difference(const Piece& p, int which, const Visit& visit) const {
    const std::size_t n = degree_[which];
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i + 1; j <= (is_rational_[which] ? n : i + 1); ++j)
        if (!visit(p.points[j] - p.points[i])) return false;
    return true;
  }
  // A difference errs by 2 e and u of coordinates; the sign counts where it outweighs that.
  [[nodiscard]] bool have_transversal_tangents(const Piece& a, const Piece& b) const {
    const double error_a = 2 * a.error + 2 * HALF_ULP * evaluator_a_.coordinate_size(),
                 error_b = 2 * b.error + 2 * HALF_ULP * evaluator_b_.coordinate_size();
    const double turn = cross(a.points[degree_[A]] - a.points[0], b.points[degree_[B]] - b.points[0]) < 0 ? -1 : 1;
    return for_each_difference(a, A, [&](const Xy<double>& u) {
      const double length = std::fabs(u.x) + std::fabs(u.y);
      return for_each_difference(b, B, [&](const Xy<double>& v) {
        const double other = std::fabs(v.x) + std::fabs(v.y);
        return turn * cross(u, v) >
               length * error_b + other * error_a + error_a * error_b + 4 * HALF_ULP * length * other;
      });
    });
  }

  [[nodiscard]] bool is_settled_at_end(const Piece& a, const Piece& b, bool are_transversal) {
    for (const double t : {0.0, 1.0})
      for (const double s : {0.0, 1.0}) {
        if ((t == 0 ? a.t0 : a.t1) != t || (s == 0 ? b.t0 : b.t1) != s) continue;
        // ends of halves are ends of the whole, bit for bit
        if (!(a.points[t == 0 ? 0 : degree_[A]] == b.points[s == 0 ? 0 : degree_[B]])) continue;
        if (!are_transversal && !run_apart(a, t, b, s)) return false;
        results_.ends.push_back({t, s});
        return true;
      }
    return false;
  }
  // Whether A backwards from its end and B from its one run ahead in one direction.
  [[nodiscard]] bool run_apart(const Piece& a, double t, const Piece& b, double s) const {
    const double sign_a = t == 0 ? -1 : 1, sign_b = s == 0 ? 1 : -1;
    const Xy<double> chord_a = sign_a * (a.points[degree_[A]] - a.points[0]),
                     chord_b = sign_b * (b.points[degree_[B]] - b.points[0]);
    const double length_a = euclidean_norm(chord_a), length_b = euclidean_norm(chord_b);
    if (!(length_a > 0) || !(length_b > 0)) return false;
    const Xy<double> ahead = (1 / length_a) * chord_a + (1 / length_b) * chord_b;
    const auto runs_ahead = [&](const Piece& p, int which, double sign, double coordinates) {
      const double error = 4 * (p.error + 2 * HALF_ULP * coordinates);
      return for_each_difference(p, which, [&](const Xy<double>& u) {
        return sign * dot(ahead, u) > error + 8 * HALF_ULP * (std::fabs(u.x) + std::fabs(u.y));
      });
    };
    return runs_ahead(a, A, sign_a, evaluator_a_.coordinate_size()) &&
           runs_ahead(b, B, sign_b, evaluator_b_.coordinate_size());
  }

  // \pre tangents are nowhere parallel
  [[nodiscard]] bool is_settled_by_newton(const Piece& a, const Piece& b) {
    const auto root = newton_box({evaluator_a_, 0, 0, a.t0, a.t1, a.points[0], a.points[degree_[A]]},
                                 {evaluator_b_, 0, 0, b.t0, b.t1, b.points[0], b.points[degree_[B]]});
    if (!root) return false;
    if (root->is_on(a.t0, a.t1, b.t0, b.t1)) {
      const auto is_this = [&](const Newton_box& r) { return r.is_same(*root) || root->is_same(r); };
      if (std::none_of(results_.roots.begin(), results_.roots.end(), is_this)) results_.roots.push_back(*root);
      return true;
    }
    return root->is_unique_on(a.t0, a.t1, b.t0, b.t1);
  }

  std::size_t degree_[2];
  bool is_rational_[2];
  Bezier_evaluator evaluator_a_, evaluator_b_;
  Polygon_results results_;
};

}  // namespace CGAL::Bounding_arcs::internal

namespace CGAL::Bounding_arcs {

namespace internal {

// Tangents at common ends in doubles, where these tell that they are not parallel.
[[nodiscard]] static bool are_transversal(const Bezier_curve_2<double>& a, double t, const Bezier_curve_2<double>& b,
                                          double s) {
  const Xy<double> u = end_direction(a, t), v = end_direction(b, s);  // each within u of itself
  return std::fabs(cross(u, v)) > 8 * HALF_ULP * (std::fabs(u.x) + std::fabs(u.y)) * (std::fabs(v.x) + std::fabs(v.y));
}

/// Common points of curves of degree at most MOST, where doubles tell them.
template <std::size_t MOST>
[[nodiscard]] std::optional<Piece_intersections> common_points(const Bezier_curve_2<double>& a,
                                                               const Bezier_curve_2<double>& b) {
  const Polygon_search<MOST> search(a, b);
  const Polygon_results& found = search.results();
  Piece_intersections result;
  bool is_open = !found.open.empty();
  for (const Newton_box& root : found.roots) {
    is_open = is_open || !root.is_inside();
    result.points.push_back({root.a, root.b, Intersection_kind::TRANSVERSAL});
  }
  for (const Bracket& end : found.ends) {
    is_open = is_open || !are_transversal(a, end.lower, b, end.upper);
    result.points.push_back({{end.lower, end.lower}, {end.upper, end.upper}, Intersection_kind::TRANSVERSAL});
  }
  if (is_open) return std::nullopt;
  if (result.points.size() > 1)
    std::sort(result.points.begin(), result.points.end(),
              [](const Piece_intersections::Intersection& p, const Piece_intersections::Intersection& q) {
                return std::tie(p.a.lower, p.b.lower) < std::tie(q.a.lower, q.b.lower);
              });
  return result;
}

}  // namespace internal

std::optional<Piece_intersections> internal::intersections_by_doubles(const Bezier_curve_2<double>& a,
                                                                      const Bezier_curve_2<double>& b) {
  internal::check_served(a);
  internal::check_served(b);
  const internal::Unit unit = internal::Unit::of_size((std::max)(a.coordinate_size(), b.coordinate_size()));
  if (!internal::is_ordinary(unit, a) || !internal::is_ordinary(unit, b)) {
    if (!internal::keeps(unit, a) || !internal::keeps(unit, b)) return std::nullopt;
    return internal::intersections_by_doubles(internal::scaled(a, unit), internal::scaled(b, unit));
  }
  constexpr std::size_t CUBIC = 3, HIGH = 9;
  const int degree = (std::max)(a.degree(), b.degree());
  if (degree <= static_cast<int>(CUBIC)) return internal::common_points<CUBIC>(a, b);
  if (degree <= static_cast<int>(HIGH)) return internal::common_points<HIGH>(a, b);
  return std::nullopt;
}

Piece_intersections intersections(const Bezier_curve_2<double>& a, const Bezier_curve_2<double>& b) {
  if (std::optional<Piece_intersections> found = internal::intersections_by_doubles(a, b)) return *std::move(found);
  return exact_intersections(exact_bezier(a), exact_bezier(b));
}

}  // namespace CGAL::Bounding_arcs
