// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The roots of a curve's four numerators, and the cuts that are made of them.

#ifndef BOUNDING_ARCS_LIBRARY_SPIRAL_SPIRAL_CUTS_H
#define BOUNDING_ARCS_LIBRARY_SPIRAL_SPIRAL_CUTS_H

#include <CGAL/Bounding_arcs_2/number/Double_double.h>
#include <CGAL/Bounding_arcs_2/polynomial/Exact_isolation.h>
#include <CGAL/Bounding_arcs_2/spiral/Segment_place.h>
#include <CGAL/Bounding_arcs_2/spiral/internal/Layered_curve.h>
#include <CGAL/Bounding_arcs_2/spiral/spiral_parameters.h>
#include "../polynomial/Root_isolator.h"
#include "Cubic_roots.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// The number of curves that this thread has cut into spiral segments so far.
[[nodiscard]] inline std::size_t& cut_count() {
  thread_local std::size_t count = 0;
  return count;
}

// A Bezier curve's numerators in three number types, each made when first asked for: intervals decide nearly always,
// double-double numbers round the roots, exact numbers are left for the rest.

/// Returns one of a curve's four polynomials as roots are isolated of it.
[[nodiscard]] inline Layered_polynomial layered_numerator(const Cut_numbers& curve, Numerator which) {
  const auto enclosure = [&curve, which] {
    const auto widened = [](const std::vector<Double_double>& a) {
      std::vector<Unprotected_interval> r;
      r.reserve(a.size());
      for (const Double_double& x : a) r.push_back(internal::enclosure(x));
      return r;
    };
    const Curve_numbers<Double_double>& c = curve.fine();
    const Curve_numbers<Unprotected_interval> numbers{widened(c.x), widened(c.y), widened(c.w)};
    return Numerator_builder<Unprotected_interval>(numbers)(which);
  };
  return {enclosure, [&curve, which] { return Numerator_builder<Double_double>(curve.fine())(which); },
          [&curve, which] { return curve.exact(which); }};
}

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

/// \param filter tells the roots of numerators where it knows them
[[nodiscard]] inline Numerator_roots numerator_roots(const Cut_numbers& curve, const Cubic_roots* filter = nullptr) {
  Numerator_roots roots;
  for (const Numerator which : {SPEED_X, SPEED_Y, INFLECTION, CURVATURE_CHANGE}) {
    std::optional<Unit_roots> known = filter != nullptr ? (*filter)(which) : std::nullopt;
    roots[which] = known ? std::move(*known) : isolate_roots(layered_numerator(curve, which));
  }
  return roots;
}

/// Whether a curve turns back where no break is kept.
[[nodiscard]] inline bool has_hidden_tip(const Cut_numbers& curve, const Numerator_roots& roots,
                                         const Short_list<double>& breaks) {
  const Unit_roots &x = roots[SPEED_X], &y = roots[SPEED_Y];
  const auto is_near_root = [](const Unit_roots& u, double t) {
    return u.is_zero ||
           std::any_of(u.roots.begin(), u.roots.end(), [t](double s) { return std::fabs(s - t) <= 2 * CUT_WIDTH; });
  };
  const auto is_hidden = [&](double t) {
    const bool is_at_equal =
        (t <= CUT_WIDTH && curve.has_double_end(true)) || (t >= 1 - CUT_WIDTH && curve.has_double_end(false));
    const bool is_cusp = vanishes_at(y, t) && std::find(breaks.begin(), breaks.end(), t) != breaks.end();
    return !is_at_equal && !is_cusp && is_near_root(y, t);
  };
  if (x.is_zero && y.is_zero) return false;
  const Unit_roots& of = x.is_zero ? y : x;
  return std::any_of(of.roots.begin(), of.roots.end(), is_hidden);
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
