// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a curve meets another one, or stops running together with it, and whether it meets two at one place.

#ifndef CGAL_BOUNDING_ARCS_2_BOOLEAN_INTERNAL_MEETING_PLACE_H
#define CGAL_BOUNDING_ARCS_2_BOOLEAN_INTERNAL_MEETING_PLACE_H

#include <CGAL/Bounding_arcs_2/query/Curve_joints.h>
#include <CGAL/Bounding_arcs_2/query/exact_intersections.h>
#include <CGAL/Bounding_arcs_2/tree/Segment_hierarchy.h>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace CGAL::Bounding_arcs::internal {

/// Between cuts that are nearer there would be a part that has no point which doubles tell from its ends.
inline constexpr double NEAREST_CUTS = 0x1p-52;

/// Where cuts that are hardly apart leave open how edges go round a vertex, they are one: tries that from some ulp on.
/// \param attempt bool(double nearest), first with NEAREST_CUTS
/// \return whether any succeeded
template <class Attempt> bool try_nearest_cuts(const Attempt& attempt) {
  constexpr double MANY_ULP = 0x1p-46, STEP = 8;
  for (double nearest = NEAREST_CUTS; nearest <= MANY_ULP; nearest *= STEP)
    if (attempt(nearest)) return true;
  return false;
}

/// A place on a curve, and that on the other one.
struct Meeting_place {
  Joint_place place, other;
  bool is_overlap_end = false;
};

/// Tells whether places on one curve are the same.
/// \param on has the curve, and `others` those that it meets
/// \pre their ranges touch; where one is an end of the curve that meets nothing, it is p
/// \return false where doubles do not tell, too, if there are no exact decisions
[[nodiscard]] inline bool are_same(const Segment_hierarchy& on, const Segment_hierarchy& others, const Meeting_place& p,
                                   const Meeting_place& q) {
  if (p.place.t.is_single() && q.place.t.is_single()) return true;  // and as they touch, the same one
  if (p.other.touches(q.other) && p.other.t.is_single() && q.other.t.is_single()) return true;
  if (on.decisions() == Decisions::DOUBLE || others.decisions() == Decisions::DOUBLE) return false;
  // A point with rational coordinates is on the other curve there, or not.
  for (const auto& [e, f] : {std::pair(&p, &q), std::pair(&q, &p)})
    for (const bool is_own : {true, false}) {
      const Joint_place& at = is_own ? e->place : e->other;
      if (!at.t.is_single()) continue;
      const auto point = (is_own ? on : others).exact_bezier(at.bezier).point(Exact_rational(at.t.lower));
      for (const Bracket& s : exact_parameters_at(others.exact_bezier(f->other.bezier), point))
        if (s.touches(f->other.t)) return true;
      return false;
    }
  const Bracket both{(std::max)(p.place.t.lower, q.place.t.lower), (std::min)(p.place.t.upper, q.place.t.upper)};
  const auto other_p = others.exact_bezier(p.other.bezier), other_q = others.exact_bezier(q.other.bezier);
  return exact_shared_parameter<Exact_rational>(on.exact_bezier(p.place.bezier), {other_p, p.is_overlap_end},
                                                {other_q, q.is_overlap_end}, both)
      .value_or(false);
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
