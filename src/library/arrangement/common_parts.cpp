// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What two parts of curves have in common: points, and parts that they share.

#include <CGAL/Bounding_arcs_2/arrangement/internal/arr_predicates.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

namespace CGAL::Bounding_arcs::internal {

namespace {

/// How many turns an overlap takes before it comes to a part of its curve, negative if that is before its start: parts
/// of two curves run together only where these are the same.
/// \param from, to where the overlap starts on the curve, and where it ends
[[nodiscard]] std::ptrdiff_t branches_along(const Arranged_point_handle& start, const Bracket& from, const Bracket& to,
                                            const Arr_x_monotone_curve_2& c) {
  const bool is_rising = from.middle() < to.middle();
  std::ptrdiff_t before = 0;  // turns before the start, or at it where the curve is run along
  for (const Arranged_point_handle& turn : c.data()->turns()) {
    const Bracket& at = turn->places.front().t;
    const bool is_start = at.touches(from) && compare_xy(Arr_point_2(turn), Arr_point_2(start)) == EQUAL;
    if (is_start ? is_rising : at.middle() < from.middle()) ++before;
  }
  const auto branch = static_cast<std::ptrdiff_t>(c.branch());
  return is_rising ? branch - before : before - branch;
}

/// The ends of what a part has of an overlap that goes on beyond it, perhaps, from left to right.
/// \pre the overlap comes to the part
[[nodiscard]] std::pair<Arr_point_2, Arr_point_2> part_of_overlap(const Arranged_meetings::Overlap& o,
                                                                  const Bracket& from, const Bracket& to,
                                                                  const Arr_x_monotone_curve_2& c) {
  const bool is_to_right = c.is_rising() == (from.middle() < to.middle());
  const Bracket &at_left = is_to_right ? from : to, &at_right = is_to_right ? to : from;
  const double sign = c.is_rising() ? 1 : -1;
  const bool begins_before =
      sign * at_left.middle()<sign * c.left_parameter().middle(), ends_behind = sign * at_right.middle()> sign *
      c.right_parameter().middle();
  return {begins_before ? c.left() : Arr_point_2(is_to_right ? o.from : o.to),
          ends_behind ? c.right() : Arr_point_2(is_to_right ? o.to : o.from)};
}

/// Whether the ranges of an overlap and of a part are apart.
[[nodiscard]] bool are_apart(const Bracket& from, const Bracket& to, const Arr_x_monotone_curve_2& c) {
  const Bracket &a = c.left_parameter(), &b = c.right_parameter();
  return (std::max)(from.upper, to.upper) < (std::min)(a.lower, b.lower) ||
         (std::max)(a.upper, b.upper) < (std::min)(from.lower, to.lower);
}

}  // namespace

std::vector<Arr_common_part> common_parts(const Arr_x_monotone_curve_2& c, const Arr_x_monotone_curve_2& d,
                                          Meetings_of_pairs& meetings) {
  std::vector<Arr_common_part> result;
  const auto add_point = [&](const Arr_point_2& p, unsigned multiplicity) {
    for (const Arr_common_part& known : result)
      if (!known.part && compare_xy(known.point, p) == EQUAL) return;
    result.push_back({std::nullopt, p, multiplicity});
  };
  // \param left, right ends of what both curves have in common, as far as the whole curves go
  const auto add_part = [&](Arr_point_2 left, Arr_point_2 right) {
    for (const Arr_x_monotone_curve_2* e : {&c, &d}) {
      if (compare_xy(left, e->left()) == SMALLER) left = e->left();
      if (compare_xy(right, e->right()) == LARGER) right = e->right();
    }
    const Comparison_result order = compare_xy(left, right);
    if (order == EQUAL) add_point(left, 0);
    if (order == SMALLER)
      result.push_back({c.part(left, parameter_at(c, left, meetings), right, parameter_at(c, right, meetings)), {}, 0});
  };
  const bool is_one_curve = c.data() == d.data();
  if (is_one_curve && c.branch() == d.branch()) {
    add_part(c.left(), c.right());
    return result;
  }
  const auto add_common_ends = [&] {
    for (const Arr_point_2* p : {&c.left(), &c.right()})
      for (const Arr_point_2* q : {&d.left(), &d.right()})
        if (compare_xy(*p, *q) == EQUAL) add_point(*p, 0);
  };
  if (is_one_curve) add_common_ends();  // neighbouring parts
  const Arranged_meetings& known = meetings.of(c.data(), d.data());
  for (const bool is_second : {false, true}) {
    if (is_second && !is_one_curve) break;
    for (const auto& o : known.overlaps) {
      const Bracket &t_from = is_second ? o.s_from : o.t_from, &t_to = is_second ? o.s_to : o.t_to,
                    &s_from = is_second ? o.t_from : o.s_from, &s_to = is_second ? o.t_to : o.s_to;
      if (are_apart(t_from, t_to, c) || are_apart(s_from, s_to, d)) continue;
      if (branches_along(o.from, t_from, t_to, c) != branches_along(o.from, s_from, s_to, d)) {
        add_common_ends();
        continue;
      }
      const auto [c_left, c_right] = part_of_overlap(o, t_from, t_to, c);
      const auto [d_left, d_right] = part_of_overlap(o, s_from, s_to, d);
      const Arr_point_2 left = compare_xy(c_left, d_left) == SMALLER ? d_left : c_left,
                        right = compare_xy(c_right, d_right) == LARGER ? d_right : c_right;
      if (compare_xy(left, right) != LARGER) add_part(left, right);
    }
    for (const auto& m : known.points) {
      const Bracket &t = is_second ? m.s : m.t, &s = is_second ? m.t : m.s;
      const Arr_point_2 p(m.point);
      if (is_on_part(p, t, c) && is_on_part(p, s, d)) add_point(p, m.is_transversal ? 1 : 0);
    }
  }
  const auto is_on_a_part = [&result](const Arr_common_part& q) {
    return !q.part && std::any_of(result.begin(), result.end(), [&q](const Arr_common_part& r) {
      return r.part && compare_xy(r.part->left(), q.point) != LARGER && compare_xy(q.point, r.part->right()) != LARGER;
    });
  };
  std::vector<Arr_common_part> once;
  std::copy_if(result.begin(), result.end(), std::back_inserter(once),
               [&](const Arr_common_part& r) { return !is_on_a_part(r); });
  result = std::move(once);
  const auto first = [](const Arr_common_part& r) { return r.part ? r.part->left() : r.point; };
  std::sort(result.begin(), result.end(), [&](const Arr_common_part& p, const Arr_common_part& q) {
    return compare_xy(first(p), first(q)) == SMALLER;
  });
  return result;
}

}  // namespace CGAL::Bounding_arcs::internal
