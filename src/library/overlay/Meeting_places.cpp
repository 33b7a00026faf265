// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of Meeting_places.h.

#include "Meeting_places.h"

#include <CGAL/Bounding_arcs_2/number/expected.h>
#include "../tree/Segment_hierarchy.h"

#include <CGAL/FPU.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

namespace CGAL::Bounding_arcs::internal {

Meeting_places::Meeting_places(const Segment_hierarchy& a, const Segment_hierarchy& b,
                               const Numbered_intersections& found)
    : curves_{&a, &b} {
  meetings_.reserve(found.points.size() + 2 * found.overlaps.size());
  for (const Numbered_point& p : found.points) {
    if (p.common.kind == Intersection_kind::UNDECIDED && !undecided_)
      undecided_ = static_cast<Place_number>(2 * meetings_.size());
    meetings_.push_back({{p.beziers.first, p.beziers.second}, {p.common.a, p.common.b}});
  }
  first_overlap_ = meetings_.size();
  for (const Numbered_overlap& o : found.overlaps) {
    meetings_.push_back({{o.beziers.first, o.beziers.second}, {o.common.a_from, o.common.b_from}});
    meetings_.push_back({{o.beziers.first, o.beziers.second}, {o.common.a_to, o.common.b_to}});
  }
}

std::optional<int> Meeting_places::compare(Place_number p, Place_number q) {
  const Bracket &a = bracket(p), &b = bracket(q);
  if (a.upper < b.lower) return -1;
  if (b.upper < a.lower) return 1;
  if (a.is_single() && b.is_single()) return 0;
  if (const std::optional<int> order = compare_by_known_points(p, q)) return order;
  if (are_crossings_of_same_lines(p, q)) return 0;
  if (curves_[0]->decisions() == Decisions::DOUBLE || curves_[1]->decisions() == Decisions::DOUBLE) return std::nullopt;
  return parameter(p).compare(parameter(q));
}

namespace {

/// The coordinate of all points of a piece along an axis.
[[nodiscard]] std::optional<double> level(const Bezier_curve_2<double>& c, double Xy<double>::*axis) {
  const double at = c.control_points().front().*axis;
  for (const Xy<double>& p : c.control_points())
    if (p.*axis != at) return std::nullopt;
  return at;
}

/// The sign of a coordinate's derivative by the parameter over a range; 0 where doubles do not tell.
[[nodiscard]] int sign_of_slope(const Bezier_evaluator& curve, const Bracket& range, double Xy<double>::*axis) {
  const auto& p = curve.curve().control_points();
  if (p.size() == 2) return p[0].*axis < p[1].*axis ? 1 : (p[0].*axis > p[1].*axis ? -1 : 0);
  const Derivative_in_range slope = derivative_in(curve, range);
  return slope.value.*axis > slope.error ? 1 : (slope.value.*axis < -slope.error ? -1 : 0);
}

}  // namespace

Meeting_places::Known_point Meeting_places::known_point(const Meeting& m) const {
  Known_point known;
  for (const std::size_t i : {0, 1}) {
    if (curves_[i]->rounding(m.bezier[i]) != 0) continue;
    const Bezier_curve_2<double>& c = curves_[i]->bezier(m.bezier[i]);
    if (is_end_of_piece(m.t[i])) {
      const Xy<double>& end = m.t[i].lower == 0 ? c.control_points().front() : c.control_points().back();
      return {end.x, end.y};
    }
    if (!known.x) known.x = level(c, &Xy<double>::x);
    if (!known.y) known.y = level(c, &Xy<double>::y);
  }
  return known;
}

std::optional<int> Meeting_places::compare_by_known_points(Place_number p, Place_number q) const {
  if (curves_of(p).rounding(bezier_of(p)) != 0) return std::nullopt;
  const Known_point a = known_point(meetings_[p / 2]), b = known_point(meetings_[q / 2]);
  const Bezier_evaluator& curve = curves_of(p).evaluator(bezier_of(p));
  const Bracket both{(std::min)(bracket(p).lower, bracket(q).lower), (std::max)(bracket(p).upper, bracket(q).upper)};
  const auto order = [&](const std::optional<double>& u, const std::optional<double>& v,
                         double Xy<double>::*axis) -> std::optional<int> {
    if (!u || !v) return std::nullopt;
    const int slope = sign_of_slope(curve, both, axis);
    if (slope == 0) return std::nullopt;
    return *u < *v ? -slope : (*u > *v ? slope : 0);
  };
  const std::optional<int> by_x = order(a.x, b.x, &Xy<double>::x);
  return by_x ? by_x : order(a.y, b.y, &Xy<double>::y);
}

Sorted_places Meeting_places::sorted(std::vector<Place_number> places) {
  std::sort(places.begin(), places.end(), [this](Place_number p, Place_number q) {
    const Bracket &a = bracket(p), &b = bracket(q);
    return std::tie(a.lower, a.upper, p) < std::tie(b.lower, b.upper, q);
  });
  Sorted_places result;
  auto& classes = result.classes;
  std::size_t first = 0;  // of the classes whose brackets touch
  double upper = 0;       // of these
  for (const Place_number p : places) {
    const bool is_apart = bracket(p).lower > upper;
    if (is_apart) first = classes.size();
    upper = is_apart ? bracket(p).upper : (std::max)(upper, bracket(p).upper);
    std::size_t low = first, high = classes.size();
    while (low < high) {
      const std::size_t middle = low + (high - low) / 2;
      const Place_number known = classes[middle].front();
      const std::optional<int> order = compare(p, known);
      if (!order) return {{}, p};
      if (*order == 0) {
        classes[middle].push_back(p);
        break;
      }
      (*order < 0 ? high : low) = *order < 0 ? middle : middle + 1;
    }
    if (low < high) continue;
    classes.emplace_back(1, p);
    std::rotate(classes.begin() + static_cast<std::ptrdiff_t>(low), classes.end() - 1, classes.end());
  }
  return result;
}

// Filter: a line that crosses two lines with the same ends, as those of a curve and of its copy.
bool Meeting_places::are_crossings_of_same_lines(Place_number p, Place_number q) const {
  const auto line = [this](Place_number r) {
    const Segment_hierarchy& curves = curves_of(r);
    const Bezier_curve_2<double>& c = curves.bezier(bezier_of(r));
    return is_line(c) && curves.rounding(bezier_of(r)) == 0 ? &c.control_points() : nullptr;
  };
  const auto *a = line(p ^ 1U), *b = line(q ^ 1U);
  return a != nullptr && b != nullptr && line(p) != nullptr && !is_overlap_end(p) && !is_overlap_end(q) &&
         ((a->front() == b->front() && a->back() == b->back()) || (a->front() == b->back() && a->back() == b->front()));
}

Exact_curve& Meeting_places::curve(const Segment_hierarchy& of, std::uint32_t bezier) {
  std::unique_ptr<Exact_curve>& known = exact_curves_[&of == curves_[0] ? 0 : 1][bezier];
  if (!known) known = std::make_unique<Exact_curve>(of.exact_bezier(bezier));
  return *known;
}

const Exact_parameter& Meeting_places::parameter(Place_number p) {
  std::unique_ptr<Exact_parameter>& known = parameters_[p];
  if (!known) known = std::make_unique<Exact_parameter>(found_parameter(p));
  return *known;
}

const Exact_meetings& Meeting_places::exact_meetings_of(Place_number p) {
  const std::uint32_t own = bezier_of(p), other = bezier_of(p ^ 1U);
  const auto [at, is_new] = exact_meetings_.try_emplace({own, other, p % 2});
  if (is_new) {
    const Integer_piece& piece = curve(curves_of(p), own).piece();
    const bool is_one = curves_[0] == curves_[1] && own == other;
    at->second = is_one ? exact_meetings(piece, p % 2 == 0 ? Parameter_order::RISING : Parameter_order::FALLING)
                        : exact_meetings(piece, curve(curves_of(p ^ 1U), other).piece());
  }
  return at->second;
}

Exact_parameter Meeting_places::found_parameter(Place_number p) {
  const Protect_FPU_rounding<true> nearest(CGAL_FE_TONEAREST);
  const Bracket& t = bracket(p);
  if (t.is_single()) return Exact_parameter(Exact_rational(t.lower));
  Exact_curve &own = curve(curves_of(p), bezier_of(p)), &other = curve(curves_of(p ^ 1U), bezier_of(p ^ 1U));
  if (is_overlap_end(p) && !other.piece().is_point()) return overlap_end(p);
  if (std::optional<Exact_parameter> crossing = crossing_of_segments(own, other)) return *crossing;
  std::vector<Exact_parameter> found = candidates(p, {p});
  return found.size() == 1 ? found.front() : told_apart(p);
}

// The common points of two pieces whose brackets touch, from one on: their places on the first curve. Points of the
// same two pieces are found one after the other, but for common ends, which touch no other point.
std::vector<Place_number> Meeting_places::touching(Place_number p) const {
  const auto is_of_pair = [&](Place_number q) { return meetings_[q / 2].bezier == meetings_[p / 2].bezier; };
  const auto end = static_cast<Place_number>(2 * first_overlap_);
  std::vector<Place_number> group{p - p % 2};
  Place_number first = group.front();
  while (first > 0 && is_of_pair(first - 2)) first -= 2;
  for (std::size_t i = 0; i < group.size(); ++i)
    for (Place_number q = first; q < end && is_of_pair(q); q += 2)
      if (bracket(q).touches(bracket(group[i])) && bracket(q + 1).touches(bracket(group[i] + 1)) &&
          std::find(group.begin(), group.end(), q) == group.end())
        group.push_back(q);
  std::sort(group.begin(), group.end());  // the same from each of them on
  return group;
}

// Which of these common points has which parameters: any that are within its brackets, as that only gives them names.
Exact_parameter Meeting_places::told_apart(Place_number p) {
  const std::vector<Place_number> group = touching(p);
  const std::vector<Exact_pair> pairs = exact_pairs(group);
  if (pairs.size() != group.size()) fail(pairs.size());
  std::vector<std::size_t> owner(group.size(), group.size());  // of a pair, along augmenting ways (Kuhn 1955)
  std::vector<char> is_tried;
  const std::function<bool(std::size_t)> is_given = [&](std::size_t i) {
    for (std::size_t j = 0; j < pairs.size(); ++j) {
      if (!pairs[j].t.is_in(bracket(group[i])) || !pairs[j].s.is_in(bracket(group[i] + 1))) continue;
      if (std::exchange(is_tried[j], 1) != 0 || (owner[j] < group.size() && !is_given(owner[j]))) continue;
      owner[j] = i;
      return true;
    }
    return false;
  };
  for (std::size_t i = 0; i < group.size(); ++i) {
    is_tried.assign(group.size(), 0);
    if (!is_given(i)) fail(0);
  }
  const auto own = std::find(group.begin(), group.end(), p - p % 2) - group.begin();
  const Exact_pair& pair = pairs[std::find(owner.begin(), owner.end(), own) - owner.begin()];
  return p % 2 == 0 ? pair.t : pair.s;
}

// The exact parameters of these common points on both curves: those of either curve that are at one point.
std::vector<Meeting_places::Exact_pair> Meeting_places::exact_pairs(const std::vector<Place_number>& group) {
  const Meeting& any = meetings_[group.front() / 2];
  const bool is_one = curves_[0] == curves_[1] && any.bezier[0] == any.bezier[1];
  std::vector<Place_number> second;
  for (const Place_number q : group) second.push_back(q + 1);
  const std::vector<Exact_parameter> of_second = candidates(second.front(), second);
  std::vector<Exact_pair> pairs;
  for (const Exact_parameter& t : candidates(group.front(), group)) {
    Exact_place at(curve(*curves_[0], any.bezier[0]), t);
    for (const Exact_parameter& s : of_second) {
      const auto is_in = [&](Place_number q) { return t.is_in(bracket(q)) && s.is_in(bracket(q + 1)); };
      const auto is_this = [&](const Exact_pair& p) { return t.compare(p.t) == 0 && s.compare(p.s) == 0; };
      if ((!is_one || t.compare(s) < 0) && std::any_of(group.begin(), group.end(), is_in) &&
          std::none_of(pairs.begin(), pairs.end(), is_this) &&
          Exact_place(curve(*curves_[1], any.bezier[1]), s).is_at(at))
        pairs.push_back({t, s});
    }
  }
  return pairs;
}

void Meeting_places::fail(std::size_t found) {
  throw std::logic_error(
      expected("common point of curves", "one exact parameter in its bracket", std::to_string(found)));
}

// Exact parameters within the brackets of some places of common points, in rising order, that of each of these.
std::vector<Exact_parameter> Meeting_places::candidates(Place_number p, const std::vector<Place_number>& beside) {
  std::vector<Exact_parameter> found;
  const auto add = [&](const Real_root& t, const Bracket& s) {
    Exact_parameter at(t);
    const auto is_at = [&](Place_number q) { return s.touches(bracket(q ^ 1U)) && at.is_in(bracket(q)); };
    if (std::any_of(beside.begin(), beside.end(), is_at)) found.push_back(std::move(at));
  };
  const Bracket& s = bracket(p ^ 1U);
  if (s.is_single() && beside.size() == 1) {
    const Exact_point at = curve(curves_of(p ^ 1U), bezier_of(p ^ 1U)).point(Exact_rational(s.lower));
    for (const Real_root& t : exact_roots_at(curve(curves_of(p), bezier_of(p)).piece(), at)) add(t, s);
  } else {
    for (const Exact_meeting& e : exact_meetings_of(p).points) add(e.t, e.s);
  }
  std::sort(found.begin(), found.end(),
            [](const Exact_parameter& a, const Exact_parameter& b) { return a.compare(b) < 0; });
  return found;
}

// An end of the overlap whose ends are in the brackets of both ends.
Exact_parameter Meeting_places::overlap_end(Place_number p) {
  const Place_number from = p - (p - overlap_place(0, 0)) / 2 % 2 * 2, to = from + 2;
  const auto is_inside = [](const Bracket& range, const Exact_parameter& t) {  // they are exact results, rounded
    return range.is_single() ? t.compare(Exact_rational(range.lower)) == 0
                             : t.compare(Exact_rational(range.lower)) > 0 && t.compare(Exact_rational(range.upper)) < 0;
  };
  std::optional<Exact_parameter> found;
  for (const Exact_overlap& o : exact_meetings_of(p).overlaps)
    for (const bool falls : {false, true}) {  // the first curve's parameter rises from an end to the other one
      if (falls && p % 2 == 0) continue;
      const Exact_parameter t_from(falls ? o.t_to : o.t_from), t_to(falls ? o.t_from : o.t_to);
      if (!is_inside(bracket(from), t_from) || !is_inside(bracket(to), t_to) ||
          !bracket(from ^ 1U).touches(Real_root(falls ? o.s_to : o.s_from).range()) ||
          !bracket(to ^ 1U).touches(Real_root(falls ? o.s_from : o.s_to).range()))
        continue;
      const Exact_parameter& t = p == from ? t_from : t_to;
      if (found && t.compare(*found) != 0) fail(2);
      found = t;
      break;
    }
  if (!found) fail(0);
  return *found;
}

}  // namespace CGAL::Bounding_arcs::internal
