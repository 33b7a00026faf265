// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Areas of what Boolean operations make, which add up.

#ifndef BOUNDING_ARCS_TEST_OUTLINE_AREAS_H
#define BOUNDING_ARCS_TEST_OUTLINE_AREAS_H

#include "overlay_checks.h"

#include <algorithm>
#include <string>

namespace bounding_arcs_test {

inline ba::Bracket sum(const ba::Bracket& p, const ba::Bracket& q) { return {p.lower + q.lower, p.upper + q.upper}; }
inline void require_same(const ba::Bracket& left, const ba::Bracket& right, const std::string& name) {
  if (!left.touches(right))
    throw Fault("area", name + ": " + std::to_string(left.middle()) + " instead of " + std::to_string(right.middle()));
}
/// How far bounds of areas may be apart.
inline double area_eps(const Drawing& a, const Drawing& b) {
  const double extent = (std::max)(extent_of(a), extent_of(b));
  return 1e-9 * extent * extent;
}

/// Areas of what operations make add up. Their bounds take in what rounding moves, so that they are the same but for
/// these.
/// \throws Fault
template <class Tree> void require_areas(const Drawing& a, const Drawing& b, Fill_rule rule_a, Fill_rule rule_b) {
  const double eps = area_eps(a, b);
  const auto area = [&](const Drawing& first, const Drawing& second, const Operation& how) {
    return Checked_outline(first, second, how, combined<Tree>(first, second, how)).area(eps);
  };
  const ba::Bracket both = area(a, b, {Boolean_operation::INTERSECTION, rule_a, rule_b}),
                    any = area(a, b, {Boolean_operation::UNION, rule_a, rule_b}),
                    only_a = area(a, b, {Boolean_operation::DIFFERENCE, rule_a, rule_b}),
                    one = area(a, b, {Boolean_operation::SYMMETRIC_DIFFERENCE, rule_a, rule_b}),
                    all_a = area(a, a, {Boolean_operation::UNION, rule_a, rule_a}),
                    all_b = area(b, b, {Boolean_operation::UNION, rule_b, rule_b});
  require_same(sum(any, both), sum(all_a, all_b), "union and intersection");
  require_same(sum(only_a, both), all_a, "difference and intersection");
  require_same(sum(one, sum(both, both)), sum(all_a, all_b), "symmetric difference and twice the intersection");
}

}  // namespace bounding_arcs_test

#endif
