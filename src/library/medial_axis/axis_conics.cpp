// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of medial_axis/axis_conics.h.

#include <CGAL/Bounding_arcs_2/medial_axis/axis_conics.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>
#include "../tree/Segment_hierarchy.h"
#include "Axis_editor.h"
#include "Line_parts.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

namespace {

using internal::Arc_sight;
using internal::sight;

class Conic_maker {
 public:
  Conic_maker(const Bounding_parts& bounds, double size, double axis_eps, double eps)
      : runs_(bounds, ROOM * size), parts_(bounds.segments, size), size_(size), axis_eps_(axis_eps), eps_(eps) {}

  [[nodiscard]] std::vector<Medial_axis_2::Conic> conics(const Medial_axis_2::Edge& e) const {
    std::vector<Medial_axis_2::Conic> result;
    if (e.samples.size() < 2) return result;
    const std::size_t last = e.samples.size() - 1;
    for (std::size_t i = 0; i < last; i = result.back().last) result.push_back(longest(e, i, last));
    return result;
  }

 private:
  static constexpr double ROOM = 0x1p-42;  // of the size: lengths below are nothing

  // Steps are doubled as long as the conic is near enough, then the first that is not is bisected for.
  [[nodiscard]] Medial_axis_2::Conic longest(const Medial_axis_2::Edge& e, std::size_t first, std::size_t last) const {
    std::size_t far = first + 1, step = 1, too_far = last + 1;
    Medial_axis_2::Conic best = line(e, first);
    if (const auto found = conic(e, first, far); found && found->error <= axis_eps_) best = *found;
    while (far < last && too_far > last) {
      const std::size_t next = (std::min)(far + step, last);
      const auto found = conic(e, first, next);
      if (found && found->error <= eps_) best = *found, far = next, step *= 2;
      else too_far = next;
    }
    while (too_far - far > 1 && too_far <= last) {
      const std::size_t middle = far + (too_far - far) / 2;
      const auto found = conic(e, first, middle);
      if (found && found->error <= eps_) best = *found, far = middle;
      else too_far = middle;
    }
    return best;
  }

  [[nodiscard]] Medial_axis_2::Conic line(const Medial_axis_2::Edge& e, std::size_t i) const {
    const Medial_axis_2::Sample &s = e.samples[i], &t = e.samples[i + 1];
    const auto arcs = arcs_of(e, i, i + 1);
    return {i,
            i + 1,
            {s.center, s.center + 0.5 * (t.center - s.center), t.center},
            1,
            arcs ? arcs->first.arc : chord(t.left, s.left),
            arcs ? arcs->second.arc : chord(s.right, t.right),
            axis_eps_};
  }

  [[nodiscard]] Arc_2 chord(const Curve_place& p, const Curve_place& q) const {
    return {runs_.point(p), runs_.point(q), 0};
  }

  [[nodiscard]] std::optional<std::pair<Fat_arc_2, Fat_arc_2>> arcs_of(const Medial_axis_2::Edge& e, std::size_t first,
                                                                       std::size_t last) const {
    const Medial_axis_2::Sample &s = e.samples[first], &t = e.samples[last];
    const auto left = runs_.between(s.left, t.left), right = runs_.between(s.right, t.right);
    if (!left || !right) return std::nullopt;
    return std::pair{parts_.part(*left, true).fat, parts_.part(*right, false).fat};
  }

  // The conic through both ends with the tangents that bisect the directions to both feet, and through the point of the
  // bisector on its median: the weight w is s / (1 - s) where that is s of the median from the chord (Lee 1987).
  //
  // With angles a and b from the chord to the tangents the apex is |way| sin b / sin(a + b) from the first end, and
  // |way| sin a / sin(a + b) from the last one. That is at most |way| where a + b is at most a right angle, unbounded
  // where it comes near two, and of rounding where both are hardly above 0.
  [[nodiscard]] std::optional<Medial_axis_2::Conic> conic(const Medial_axis_2::Edge& e, std::size_t first,
                                                          std::size_t last) const {
    const auto arcs = arcs_of(e, first, last);
    if (!arcs) return std::nullopt;
    const Arc_2 &a = arcs->first.arc, &b = arcs->second.arc;
    const double wide = arcs->first.radius + arcs->second.radius;
    const Xy<double> from = e.samples[first].center, to = e.samples[last].center, way = to - from;
    Medial_axis_2::Conic result{first, last, {from, from + 0.5 * way, to}, 1, a, b};
    const Xy<double> t0 = along(from, a, b), t1 = along(to, a, b);
    const double rise_first = cross(t0, way), rise_last = cross(way, t1), room = ROOM * size_;
    if (std::fabs(rise_first) > room || std::fabs(rise_last) > room) {
      const double turn = cross(t0, t1), to_first = rise_last / turn, to_last = rise_first / turn,
                   most = euclidean_norm(way);
      const auto is_within = [&](double length) { return length > 0 && length <= most; };
      if (!(dot(t0, way) >= 0 && dot(t1, way) >= 0 && is_within(to_first) && is_within(to_last))) return std::nullopt;
      const Xy<double> middle = result.points[1], apex = from + to_first * t0, median = apex - middle;
      const std::optional<double> share = share_of(median, middle, a, b);
      if (!share) return std::nullopt;
      result.points[1] = apex, result.weight = *share / (1 - *share);
    }
    const auto see = [&](double e) {  // what is no number stays infinite
      if (!(e <= result.error)) result.error = std::isfinite(e) ? e : HUGE_VAL;
    };
    for (const double t : {0.25, 0.5, 0.75}) see(off(at(result, t), a, b, wide));
    for (std::size_t i = first; i <= last; ++i) {
      const Medial_axis_2::Sample& s = e.samples[i];
      const double radius = 0.5 * (sight(s.center, a).distance + sight(s.center, b).distance);
      see(off(s.center, a, b, wide) + std::fabs(radius - s.radius));
    }
    return std::isfinite(result.error) ? std::optional(result) : std::nullopt;
  }
  // The unit tangent of the bisector, with the first arc on its left. A sign by the chord would be one of rounding
  // where two samples nearly are one.
  [[nodiscard]] static Xy<double> along(const Xy<double>& q, const Arc_2& a, const Arc_2& b) {
    const Xy<double> t = perp(sight(q, a).gradient - sight(q, b).gradient);
    return (1 / euclidean_norm(t)) * t;
  }
  // A point of the conic as it is written.
  [[nodiscard]] static Xy<double> at(const Medial_axis_2::Conic& c, double t) {
    const double first = (1 - t) * (1 - t), second = 2 * c.weight * t * (1 - t), third = t * t;
    return (1 / (first + second + third)) * (first * c.points[0] + second * c.points[1] + third * c.points[2]);
  }
  // Newton's method for equal distances.
  [[nodiscard]] static std::optional<double> share_of(const Xy<double>& median, const Xy<double>& middle,
                                                      const Arc_2& a, const Arc_2& b) {
    constexpr int STEPS = 20;
    double share = 0.5;
    for (int i = 0; i < STEPS; ++i) {
      const Xy<double> q = middle + share * median;
      const Arc_sight of_a = sight(q, a), of_b = sight(q, b);
      const double next = share - (of_a.distance - of_b.distance) / dot(of_a.gradient - of_b.gradient, median);
      if (!(next > 0 && next < 1)) return std::nullopt;
      const double moved = std::fabs(next - share);
      share = next;
      if (moved <= 0x1p-40) break;
    }
    return share;
  }
  // How far the bisector of the curves may be from a place, with radii: distances from both arcs differ by `wide` more.
  [[nodiscard]] static double off(const Xy<double>& q, const Arc_2& a, const Arc_2& b, double wide) {
    const Arc_sight of_a = sight(q, a), of_b = sight(q, b);
    return (std::fabs(of_a.distance - of_b.distance) + wide) / euclidean_norm(of_a.gradient - of_b.gradient) + wide;
  }

  internal::Foot_runs runs_;
  internal::Line_parts parts_;
  double size_, axis_eps_, eps_;
};

}  // namespace

std::vector<std::vector<Medial_axis_2::Conic>> axis_conics(const Bounding_arc_tree_2& curves, const Medial_axis_2& axis,
                                                           double eps) {
  check_above_zero("eps", eps);
  const internal::Unit& unit = curves.unit();
  const Medial_axis_2 scaled = internal::in(unit, axis);
  const auto bounds = internal::bounds_of(axis, curves.in_unit());
  const Conic_maker maker(*bounds, curves.in_unit().drawing().coordinate_size(), scaled.eps, unit.tolerance_in(eps));
  std::vector<std::vector<Medial_axis_2::Conic>> result;
  const auto place = [&](const Xy<double>& p) { return unit.out(p); };
  for (const Medial_axis_2::Edge& e : scaled.edges) {
    result.push_back(maker.conics(e));
    for (Medial_axis_2::Conic& c : result.back()) {
      for (Xy<double>& p : c.points) p = place(p);
      for (Arc_2* arc : {&c.left, &c.right}) arc->from = place(arc->from), arc->to = place(arc->to);
      c.error = unit.bounds_out(Bracket{0, c.error}).upper;
    }
  }
  return result;
}

}  // namespace CGAL::Bounding_arcs
