// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The roots of a curve's four numerators, and the cuts that are made of them (see spiral/spiral_parameters.h).

#ifndef CGAL_BOUNDING_ARCS_2_SPIRAL_INTERNAL_NUMERATOR_ROOTS_H
#define CGAL_BOUNDING_ARCS_2_SPIRAL_INTERNAL_NUMERATOR_ROOTS_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/polynomial/Root_isolator.h>
#include <CGAL/Bounding_arcs_2/spiral/Segment_place.h>
#include <CGAL/Bounding_arcs_2/spiral/internal/Cubic_roots.h>
#include <CGAL/Bounding_arcs_2/spiral/internal/Layered_curve.h>
#include <CGAL/Bounding_arcs_2/spiral/internal/curve_numerators.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <type_traits>
#include <utility>

namespace CGAL::Bounding_arcs::internal {

using Numerator_roots = std::array<Unit_roots, NUMERATOR_COUNT>;

[[nodiscard]] inline bool vanishes_at(const Unit_roots& u, double t) {
  return u.is_zero || std::binary_search(u.roots.begin(), u.roots.end(), t);
}

// Roots thinned out so that no two are within CUT_WIDTH of each other or of an end: common roots of x' and y' stay in
// preference to roots of either, these in preference to the others, else the first of them. A root left out is within
// CUT_WIDTH of one that stays or of an end.
[[nodiscard]] inline Short_list<double> separated_cuts(const Numerator_roots& roots) {
  Short_list<double> cuts;
  const auto add = [&cuts](double t) {
    const auto next = std::lower_bound(cuts.begin(), cuts.end(), t);
    const double below = next == cuts.begin() ? 0 : *std::prev(next), above = next == cuts.end() ? 1 : *next;
    if (t - below > CUT_WIDTH && above - t > CUT_WIDTH) cuts.insert(next, t);
  };
  const auto add_roots = [&](Numerator a, Numerator b) {
    const Short_list<double>&p = roots[a].roots, &q = roots[b].roots;
    Short_list<double> both;
    std::merge(p.begin(), p.end(), q.begin(), q.end(), std::back_inserter(both));
    for (const double t : both) add(t);
  };
  for (const double t : roots[SPEED_X].roots)
    if (vanishes_at(roots[SPEED_Y], t)) add(t);
  add_roots(SPEED_X, SPEED_Y);
  add_roots(INFLECTION, CURVATURE_CHANGE);
  return cuts;
}

// Knows no roots.
struct No_root_filter {
  template <class Curve> explicit No_root_filter(const Curve&) {}
  std::optional<Unit_roots> operator()(Numerator) const { return std::nullopt; }
};
template <class NT> using Root_filter = std::conditional_t<std::is_same_v<NT, double>, Cubic_roots, No_root_filter>;

// The roots of all four numerators; in rounding to nearest.
template <class NT, class Filter = Root_filter<NT>> Numerator_roots numerator_roots(const Bezier_curve_2<NT>& curve) {
  const Filter filter(curve);
  std::optional<Layered_curve<NT>> layered;
  Numerator_roots roots;
  for (const Numerator which : {SPEED_X, SPEED_Y, INFLECTION, CURVATURE_CHANGE}) {
    if (std::optional<Unit_roots> known = filter(which)) {
      roots[which] = std::move(*known);
      continue;
    }
    if (!layered) layered.emplace(curve);
    Layered_numerator<NT> polynomial(*layered, which);
    roots[which] = isolate_layered_roots(polynomial);
  }
  return roots;
}

/// Whether a curve turns back where no break is kept.
template <class NT>
[[nodiscard]] bool has_hidden_tip(const Bezier_curve_2<NT>& curve, const Numerator_roots& roots,
                                  const Short_list<double>& breaks) {
  const Unit_roots &x = roots[SPEED_X], &y = roots[SPEED_Y];
  const auto is_near_root = [](const Unit_roots& u, double t) {
    return u.is_zero ||
           std::any_of(u.roots.begin(), u.roots.end(), [t](double s) { return std::fabs(s - t) <= 2 * CUT_WIDTH; });
  };
  const auto& p = curve.control_points();
  const std::size_t n = p.size() - 1;
  const auto is_hidden = [&](double t) {
    const bool is_at_equal = (t <= CUT_WIDTH && p[0] == p[1]) || (t >= 1 - CUT_WIDTH && p[n] == p[n - 1]);
    const bool is_cusp = vanishes_at(y, t) && std::find(breaks.begin(), breaks.end(), t) != breaks.end();
    return !is_at_equal && !is_cusp && is_near_root(y, t);
  };
  if (x.is_zero && y.is_zero) return false;
  const Unit_roots& of = x.is_zero ? y : x;
  return std::any_of(of.roots.begin(), of.roots.end(), is_hidden);
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
