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

/// What a branch of a curve and one of another have of an overlap.
struct Shared_branch {
  bool has_start, has_end;  ///< where the overlap starts and ends; else they go on to the ends of the branches
};
/// Branches belong to each other where both are as many turns from the overlap's start: parts of two curves run
/// together only where these are the same.
[[nodiscard]] std::optional<Shared_branch> shared_branch(const Arranged_meetings::Way& a, std::size_t branch_a,
                                                         const Arranged_meetings::Way& b, std::size_t branch_b) {
  const auto turns_before = [](const Arranged_meetings::Way& way, std::size_t branch) {
    return way.is_forward ? branch - way.first : way.first - branch;  // more than any number beyond the start
  };
  const std::size_t turns = turns_before(a, branch_a), all = turns_before(a, a.last);
  if (turns > all || turns_before(b, branch_b) != turns) return std::nullopt;
  return Shared_branch{turns == 0, turns == all};
}

}  // namespace

std::vector<Arr_common_part> common_parts(const Arr_x_monotone_curve_2& c, const Arr_x_monotone_curve_2& d,
                                          Meetings_of_pairs& meetings) {
  std::vector<Arr_common_part> result;
  const auto add_point = [&](const Arr_point_2& p, unsigned multiplicity) {
    for (Arr_common_part& known : result)
      if (!known.part && compare_xy(known.point, p) == EQUAL) {
        known.multiplicity = 0;  // places of one point on branches that it is not told of
        return;
      }
    result.push_back({std::nullopt, p, multiplicity});
  };
  // \param left, right the ends of what both branches have in common, if these do not go on there
  const auto add_part = [&](const Arr_point_2* left, const Arr_point_2* right) {
    for (const Arr_x_monotone_curve_2* e : {&c, &d}) {
      if (!left || compare_xy(*left, e->left()) == SMALLER) left = &e->left();
      if (!right || compare_xy(*right, e->right()) == LARGER) right = &e->right();
    }
    const Comparison_result order = compare_xy(*left, *right);
    if (order == EQUAL) add_point(*left, 0);
    if (order == SMALLER)
      result.push_back({c.part({*left, parameter_at(c, *left)}, {*right, parameter_at(c, *right)}), {}, 0});
  };
  const bool is_one_curve = c.data() == d.data();
  if (is_one_curve && c.branch() == d.branch()) {
    add_part(nullptr, nullptr);
    return result;
  }
  const Arranged_meetings& known = meetings.of(c.data(), d.data());
  if (is_one_curve || !known.overlaps.empty())  // neighbouring branches
    for (const Arr_point_2* p : {&c.left(), &c.right()})
      for (const Arr_point_2* q : {&d.left(), &d.right()})
        if (compare_xy(*p, *q) == EQUAL) add_point(*p, 0);
  for (const Arranged_meetings::Overlap& o : known.overlaps)
    for (const bool is_c_first : {true, false}) {  // of one curve either part may be
      if (!is_one_curve && is_c_first != (known.pair->a == c.data())) continue;
      const Arranged_meetings::Way &of_c = is_c_first ? o.a : o.b, &of_d = is_c_first ? o.b : o.a;
      const std::optional<Shared_branch> shared = shared_branch(of_c, c.branch(), of_d, d.branch());
      if (!shared) continue;
      const Arr_point_2 start(o.from), end(o.to);
      const Arr_point_2 *from = shared->has_start ? &start : nullptr, *to = shared->has_end ? &end : nullptr;
      const bool is_to_right = of_c.is_forward == c.is_rising();
      add_part(is_to_right ? from : to, is_to_right ? to : from);
    }
  for (const Arranged_meetings::Point& m : known.points) {
    const Arr_point_2 p(m.point);
    const Arranged_place *on_c = known_place(p, c), *on_d = known_place(p, d);
    if (on_c && on_d && is_on_part(p, on_c->t, c) && is_on_part(p, on_d->t, d)) add_point(p, m.is_transversal ? 1 : 0);
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
