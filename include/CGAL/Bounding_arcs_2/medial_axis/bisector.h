// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The bisector of two curves: the centers of discs that touch both.

#ifndef CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_BISECTOR_H
#define CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_BISECTOR_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/curve/derivatives.h>
#include <CGAL/Bounding_arcs_2/curve/queried_range.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/query/Closest_search.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <vector>

namespace CGAL::Bounding_arcs {

/// A disc that touches a curve, on its left, and another one.
struct Bisector_sample {
  Xy<double> center;
  double radius = 0;
  double t = 0;           ///< where it touches the first curve
  Curve_place touches{};  ///< where it touches the other one
};

/// Discs between two curves: each touches the first one from the left, and the other one.
/// \code
/// const Bezier_curve_2<double> line({{-1, -3}, {1, -3}});
/// const Bisector_2 bisector(line, tree, 10);  // discs up to the radius 10
/// if (const auto disc = bisector.disc(0.5)) std::cout << disc->center.y << ' ' << disc->radius << '\n';
/// \endcode
class Bisector_2 {
 public:
  /// \param a reverse it for its other side
  /// \param b must outlive this; it may be of many curves, whose nearest one counts
  /// \param largest the largest radius to look for
  /// \throws std::invalid_argument for a radius that is not positive or above LARGEST_QUERIED, and for a curve out of
  ///   the range of check_queried
  Bisector_2(const Bezier_curve_2<double>& a, const Bounding_arc_tree_2& b, double largest)
      : unit_((std::max)(b.unit(), Unit::of_size(coordinate_size(a)))), a_(scaled(a, unit_)), b_(b.in_unit(unit_)),
        largest_((std::min)(unit_.tolerance_in(largest), LARGEST_QUERIED / 2)) {
    if (!(largest > 0) || !(largest <= LARGEST_QUERIED))
      throw std::invalid_argument(expected("largest", "a radius above 0 and up to 2^500 (3e150)", largest));
    check_queried(a);
  }

  /// The disc that touches `a` in t from the left and touches `b`, of which no point is in it.
  /// \return nothing where that would be larger than `largest` or than the radius of curvature of `a`, and so have `a`
  ///   in it, and where C' = 0
  /// \guarantee no bound is told; the radius is within some roundings of coordinates over 1 - cos of the angle between
  ///   both places, seen from the center
  /// \source the ball that shrinks to the nearest point until there is none in it: Ma, Bae, Choi 2012; here for curves
  ///   instead of points, where each step squares the error
  [[nodiscard]] std::optional<Bisector_sample> disc(double t) const {
    const auto found = disc_in_unit(t);
    return found ? std::optional(out(*found)) : std::nullopt;
  }

  /// The bisector as chains of discs, in the order of `a`; each ends where discs do.
  /// \param eps how far the bisector may be from the lines between samples, and radii from what is between theirs
  /// \throws std::invalid_argument for an eps that is not positive
  /// \guarantee that lines are within eps is an estimate, from discs half-way. Samples are no nearer to each other than
  ///   2^-18 of the parameters of `a`, and chains over less than 1/64 of these may be missing
  /// \complexity about eps^(-1/2) discs, each of some closest points
  [[nodiscard]] std::vector<std::vector<Bisector_sample>> sample(double eps) const {
    check_above_zero("eps", eps);
    Chains chains = chains_in_unit(unit_.tolerance_in(eps));
    for (auto& chain : chains)
      for (Bisector_sample& s : chain) s = out(s);
    return chains;
  }

 private:
  using Chains = std::vector<std::vector<Bisector_sample>>;
  static constexpr int FIRST = 64;
  static constexpr double ROUNDING = 0x1p-51, LEAST_STEP = 0x1p-18;

  [[nodiscard]] Bisector_sample out(const Bisector_sample& s) const {
    return {unit_.out(s.center), unit_.out(s.radius), s.t, s.touches};
  }
  [[nodiscard]] std::optional<Bisector_sample> disc_in_unit(double t) const {
    const Segment_hierarchy& b = *b_;
    const std::vector<Xy<double>> jet = taylor_expansion(a_, t, 2);
    const double speed = euclidean_norm(jet[1]);
    if (!(speed > 0)) return std::nullopt;
    const Xy<double> normal = (1 / speed) * perp(jet[1]);
    const double curvature = 2 * cross(jet[1], jet[2]) / (speed * speed * speed);
    Bisector_sample disc{{}, curvature * largest_ > 1 ? 1 / curvature : largest_, t, {}};
    bool is_found = false;
    for (;;) {
      disc.center = jet[0] + disc.radius * normal;
      const auto nearest = is_found ? closest_point(b, disc.center, disc.touches) : closest_point(b, disc.center);
      if (!nearest || !(nearest->distance.upper < disc.radius)) break;
      const Xy<double> q = nearest->point - jet[0];
      const double height = dot(normal, q), radius = dot(q, q) / (2 * height);
      if (!(height > 0)) return std::nullopt;  // `b` runs through C(t)
      if (!(radius < disc.radius)) break;
      const bool is_near = disc.radius - radius <= ROUNDING * radius;
      disc.radius = radius;
      disc.touches = nearest->place;
      disc.center = jet[0] + radius * normal;
      is_found = true;
      if (is_near) break;
    }
    return is_found ? std::optional(disc) : std::nullopt;
  }

  [[nodiscard]] Chains chains_in_unit(double eps) const {
    Chains chains(1);
    std::optional<Bisector_sample> last = disc_in_unit(0);
    if (last) chains.back().push_back(*last);
    for (int i = 1; i <= FIRST; ++i) {
      const double t0 = static_cast<double>(i - 1) / FIRST, t1 = static_cast<double>(i) / FIRST;
      const std::optional<Bisector_sample> next = disc_in_unit(t1);
      add_between(t0, last, t1, next, eps, chains);
      last = next;
    }
    if (chains.back().empty()) chains.pop_back();
    return chains;
  }

  // What comes behind t0, up to t1.
  void add_between(double t0, const std::optional<Bisector_sample>& s0, double t1,
                   const std::optional<Bisector_sample>& s1, double eps, Chains& chains) const {
    if (!s0 && !s1) return;
    if (t1 - t0 > LEAST_STEP) {
      const double t = t0 + (t1 - t0) / 2;
      const std::optional<Bisector_sample> s = disc_in_unit(t);
      if (!s0 || !s1 || !s || deviation(*s0, *s, *s1) > eps) {
        add_between(t0, s0, t, s, eps, chains);
        add_between(t, s, t1, s1, eps, chains);
        return;
      }
    }
    if (s0.has_value() != s1.has_value()) chains.back().push_back(end_between(t0, s0, t1, s1));
    if (s1) chains.back().push_back(*s1);
    else chains.emplace_back();
  }
  // The last disc, or the first one, of a chain that ends between two places.
  [[nodiscard]] Bisector_sample end_between(double t0, const std::optional<Bisector_sample>& s0, double t1,
                                            const std::optional<Bisector_sample>& s1) const {
    Bisector_sample end = s0 ? *s0 : *s1;
    double none = s0 ? t1 : t0;
    for (;;) {
      const double t = end.t + (none - end.t) / 2;
      if (t == end.t || t == none) return end;
      if (const auto s = disc_in_unit(t)) end = *s;
      else none = t;
    }
  }
  // How far s is from the line between the others, in the plane and in the radius together.
  [[nodiscard]] static double deviation(const Bisector_sample& s0, const Bisector_sample& s,
                                        const Bisector_sample& s1) {
    const Xy<double> way = s1.center - s0.center, from = s.center - s0.center;
    const double all = dot(way, way), share = all > 0 ? dot(from, way) / all : 0;
    return euclidean_norm(from - share * way) + std::fabs(s.radius - s0.radius - share * (s1.radius - s0.radius));
  }

  Unit unit_;  // of all that follows
  Bezier_curve_2<double> a_;
  std::shared_ptr<const Segment_hierarchy> b_;
  double largest_;
};

}  // namespace CGAL::Bounding_arcs

#endif
