// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of medial_axis/bisector.h.

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/curve/served_range.h>
#include <CGAL/Bounding_arcs_2/medial_axis/bisector.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>
#include "../query/Closest_search.h"
#include "../tree/Segment_hierarchy.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

namespace {

/// Chains of discs along a curve, each as long as there are discs.
/// \tparam Disc std::optional<Bisector_2::Sample>(double t)
template <class Disc> class Chain_maker {
 public:
  using Sample = Bisector_2::Sample;

  Chain_maker(const Disc& disc, double eps) : disc_(disc), eps_(eps) {
    constexpr int FIRST = 64;
    std::optional<Sample> last = disc(0);
    if (last) chains_.back().push_back(*last);
    for (int i = 1; i <= FIRST; ++i) {
      const double t0 = static_cast<double>(i - 1) / FIRST, t1 = static_cast<double>(i) / FIRST;
      const std::optional<Sample> next = disc(t1);
      add_between(t0, last, t1, next);
      last = next;
    }
    if (chains_.back().empty()) chains_.pop_back();
  }
  [[nodiscard]] std::vector<std::vector<Sample>> chains() && { return std::move(chains_); }

 private:
  // What comes behind t0, up to t1.
  void add_between(double t0, const std::optional<Sample>& s0, double t1, const std::optional<Sample>& s1) {
    constexpr double LEAST_STEP = 0x1p-18;
    if (!s0 && !s1) return;
    if (t1 - t0 > LEAST_STEP) {
      const double t = t0 + (t1 - t0) / 2;
      const std::optional<Sample> s = disc_(t);
      if (!s0 || !s1 || !s || deviation(*s0, *s, *s1) > eps_) {
        add_between(t0, s0, t, s);
        add_between(t, s, t1, s1);
        return;
      }
    }
    if (!s0) chains_.back().push_back(end_between(*s1, t0));
    if (!s1) chains_.back().push_back(end_between(*s0, t1));
    if (s1) chains_.back().push_back(*s1);
    else chains_.emplace_back();
  }
  // The last disc, or the first one, of a chain that ends between a disc and a place without.
  [[nodiscard]] Sample end_between(Sample end, double none) const {
    for (;;) {
      const double t = end.t + (none - end.t) / 2;
      if (t == end.t || t == none) return end;
      if (const auto s = disc_(t)) end = *s;
      else none = t;
    }
  }
  // How far s is from the line between the others, in the plane and in the radius together.
  [[nodiscard]] static double deviation(const Sample& s0, const Sample& s, const Sample& s1) {
    const Xy<double> way = s1.center - s0.center, from = s.center - s0.center;
    const double all = dot(way, way), share = all > 0 ? dot(from, way) / all : 0;
    return euclidean_norm(from - share * way) + std::fabs(s.radius - s0.radius - share * (s1.radius - s0.radius));
  }

  const Disc& disc_;
  double eps_;
  std::vector<std::vector<Sample>> chains_{1};
};

}  // namespace

Bisector_2::Bisector_2(const Bezier_curve_2<double>& a, const Bounding_arc_tree_2& b, double largest)
    : unit_((std::max)(b.unit(), internal::Unit::of_size(a.coordinate_size()))), a_(internal::scaled(a, unit_)),
      b_(b.in_unit(unit_)), largest_((std::min)(unit_.tolerance_in(largest), LARGEST_QUERIED / 2)) {
  if (!(largest > 0) || !(largest <= LARGEST_QUERIED))
    throw std::invalid_argument(expected("largest", "a radius above 0 and up to 2^500 (3e150)", largest));
  internal::check_queried(a);
}

std::optional<Bisector_2::Sample> Bisector_2::disc(double t) const {
  const auto found = disc_in_unit(t);
  return found ? std::optional(out(*found)) : std::nullopt;
}

std::vector<std::vector<Bisector_2::Sample>> Bisector_2::sample(double eps) const {
  check_above_zero("eps", eps);
  const auto disc = [this](double t) { return disc_in_unit(t); };
  auto chains = Chain_maker(disc, unit_.tolerance_in(eps)).chains();
  for (auto& chain : chains)
    for (Sample& s : chain) s = out(s);
  return chains;
}

Bisector_2::Sample Bisector_2::out(const Bisector_2::Sample& s) const {
  return {unit_.out(s.center), unit_.out(s.radius), s.t, s.touches};
}

std::optional<Bisector_2::Sample> Bisector_2::disc_in_unit(double t) const {
  const Segment_hierarchy& b = *b_;
  const std::vector<Xy<double>> jet = a_.taylor_expansion(t, 2);
  const double speed = euclidean_norm(jet[1]);
  if (!(speed > 0)) return std::nullopt;
  const Xy<double> normal = (1 / speed) * perp(jet[1]);
  const double curvature = 2 * cross(jet[1], jet[2]) / (speed * speed * speed);
  Bisector_2::Sample disc{{}, curvature * largest_ > 1 ? 1 / curvature : largest_, t, {}};
  bool is_found = false;
  constexpr double ROUNDING = 0x1p-51;
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

}  // namespace CGAL::Bounding_arcs
