// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of Boundary_sum.h, and the areas of overlay/overlay.h.

#include "Boundary_sum.h"

#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/overlay/overlay.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>
#include "../curve/Rational_part.h"
#include "../curve/green.h"
#include "../query/query_units.h"

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

namespace {

/// |x| + |y|, no less than the length.
[[nodiscard]] Exact_rational size_of(const Xy<Exact_rational>& v) {
  return Exact_rational(CGAL::abs(v.x) + CGAL::abs(v.y));
}

/// A bound of |C'|. With N the numerator about the first control point, W the weight and D the largest distance from
/// that point, C' = (N' - W' C) / W is at most (|N'| + |W'| D) / the least weight.
[[nodiscard]] Exact_rational speed_bound(const Bezier_curve_2<Exact_rational>& curve) {
  const auto& p = curve.control_points();
  const auto weight = [&](std::size_t i) { return curve.is_rational() ? curve.weights()[i] : Exact_rational(1); };
  Exact_rational numerator(0), change_of_weight(0), farthest(0), least = weight(0);
  Xy<Exact_rational> before{Exact_rational(0), Exact_rational(0)};
  for (std::size_t i = 1; i < p.size(); ++i) {
    const Xy<Exact_rational> way = p[i] - p[0], at = weight(i) * way;
    numerator = (std::max)(numerator, size_of(at - before));
    change_of_weight = (std::max)(change_of_weight, Exact_rational(CGAL::abs(weight(i) - weight(i - 1))));
    farthest = (std::max)(farthest, size_of(way));
    least = (std::min)(least, weight(i));
    before = at;
  }
  return Exact_rational(Exact_rational(curve.degree()) * (numerator + change_of_weight * farthest) / least);
}

}  // namespace

void Boundary_sum::add(const Bezier_curve_2<Exact_rational>& bezier, const Bracket& from, const Bracket& to) {
  const double start = from.middle(), end = to.middle();
  const bool is_certain = from.is_single() && to.is_single();
  const Exact_rational speed = is_certain ? Exact_rational(0) : speed_bound(bezier);
  const auto open = [&](const Bracket& t) {
    return Exact_rational((Exact_rational(t.upper) - Exact_rational(t.lower)) * speed);
  };
  End first{{}, open(from)}, last{{}, open(to)};
  if (bezier.is_rational()) {
    const Rational_part part(bezier, start, end);
    first.point = {Exact_rational(part.from().x), Exact_rational(part.from().y)};
    last.point = {Exact_rational(part.to().x), Exact_rational(part.to().y)};
    const auto beside = part.beside_chord({0, 0}).area;
    by_chords_ += CGAL::Interval_nt<true>(beside.inf(), beside.sup());
    first.open += Exact_rational(part.rounding());
    last.open += Exact_rational(part.rounding());
    add_segment(first.point, last.point);
  } else {
    first.point = bezier.point(Exact_rational(start));
    last.point = bezier.point(Exact_rational(end));
    const auto [low, high] = std::minmax(start, end);
    if (low < high) {
      const auto part = bezier.subcurve(Exact_rational(low), Exact_rational(high));
      const Exact_rational area = moments_along(part, {Exact_rational(0), Exact_rational(0)}, false).area;
      exact_ += start < end ? area : Exact_rational(-area);
    }
  }
  if (last_) join(*last_, first);
  else first_ = first;
  last_ = last;
}

void Boundary_sum::close() {
  if (last_) join(*last_, *first_);
  first_ = last_ = std::nullopt;
}

void Boundary_sum::join(const End& end, const End& start) {
  add_segment(end.point, start.point);
  const Exact_rational sum = end.open + start.open;
  open_ += Exact_rational(sum * sum / Exact_rational(3));
}

void Boundary_sum::add_segment(const Point& from, const Point& to) {
  if (!(from == to)) exact_ += Exact_rational(cross(from, to) / Exact_rational(2));
}

// A face is an open set that is not empty, and bounded: its area is above 0, whatever rounding leaves open of it.
Measure_bounds Boundary_sum::bounds(double eps) const {
  const Exact_rational lower = exact_ + Exact_rational(by_chords_.inf()) - open_,
                       upper = exact_ + Exact_rational(by_chords_.sup()) + open_;
  return measured((std::max)(CGAL::to_interval(lower).first, 0.0), CGAL::to_interval(upper).second, eps, false);
}

}  // namespace CGAL::Bounding_arcs::internal

namespace CGAL::Bounding_arcs {

Measure_bounds face_area(const std::vector<const Bounding_arc_tree_2*>& trees, const Overlay_2& overlay,
                         std::uint32_t face, double eps) {
  check_tolerance(eps);
  const Overlay_2::Face& of = overlay.faces.at(face);
  if (!of.is_bounded) throw std::invalid_argument(expected("face", "a bounded face", "the unbounded one"));
  internal::Boundary_sum sum;
  for (const std::vector<Overlay_2::Side>& boundary : of.boundaries) {
    for (const Overlay_2::Side& side : boundary) {
      const Overlay_2::Source& along = overlay.edges[side.edge].sources.front();
      const auto add = [&](const Overlay_2::Part& part) {
        const auto bezier = trees.at(along.operand)->exact_bezier(along.curve, part.bezier);
        sum.add(bezier, side.is_reversed ? part.to : part.from, side.is_reversed ? part.from : part.to);
      };
      if (side.is_reversed) std::for_each(along.parts.rbegin(), along.parts.rend(), add);
      else std::for_each(along.parts.begin(), along.parts.end(), add);
    }
    sum.close();
  }
  return sum.bounds(eps);
}

}  // namespace CGAL::Bounding_arcs
