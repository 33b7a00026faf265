// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Curves of arrangements: what is known of them ahead, their parts that are monotone in x, what two have in common.

#include "../overlay/Meeting_places.h"
#include "exact_places.h"

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>
#include <CGAL/Bounding_arcs_2/arrangement/internal/arr_predicates.h>
#include <CGAL/Bounding_arcs_2/curve/served_range.h>
#include <CGAL/Bounding_arcs_2/query/intersections.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>
#include "../polynomial/Interval_isolation.h"
#include "../query/Intersection_search.h"
#include "../tree/Segment_hierarchy.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

namespace CGAL::Bounding_arcs::internal {

namespace {

[[nodiscard]] const Bezier_curve_2<double>& checked(const Bezier_curve_2<double>& curve) {
  check_served(curve);
  return curve;
}

}  // namespace

Arranged_curve::Arranged_curve(const Bezier_curve_2<double>& bezier, std::size_t curve, std::size_t piece)
    : evaluator_(checked(bezier)), curve_(curve), piece_(piece) {
  static std::atomic<std::uint64_t> count{0};
  number_ = ++count;
  const auto& p = bezier.control_points();
  start_ = Arr_point_2(p.front().x, p.front().y).data();
  end_ = p.front() == p.back() ? start_ : Arr_point_2(p.back().x, p.back().y).data();
  const auto by_x = [](const Xy<double>& a, const Xy<double>& b) { return a.x < b.x; };
  const auto by_y = [](const Xy<double>& a, const Xy<double>& b) { return a.y < b.y; };
  const auto x = std::minmax_element(p.begin(), p.end(), by_x), y = std::minmax_element(p.begin(), p.end(), by_y);
  x_ = {x.first->x, x.second->x};
  y_ = {y.first->y, y.second->y};
  // |C'| <= |C'(0)| + max |C''|
  const Curve_jet jet = evaluator_(0);
  first_bound_ = (euclidean_norm(jet.first) + evaluator_.first_error() + evaluator_.second_bound()) * (1 + 0x1p-40);
}
Arranged_curve::~Arranged_curve() = default;

Arranged_curve::Box Arranged_curve::at(const Bracket& t) const {
  if (is_end_of_piece(t)) {
    const Xy<double>& p = t.lower == 0 ? bezier().control_points().front() : bezier().control_points().back();
    return {{p.x, p.x}, {p.y, p.y}};
  }
  const double reach = evaluator_.point_error() + first_bound_ * t.width();
  const Xy<double> p = evaluator_(t.middle()).point;
  return {x_.is_single() ? x_ : range_around(p.x, reach), y_.is_single() ? y_ : range_around(p.y, reach)};
}

namespace {

/// Notes that a point is on a curve: on the branch that holds the parameter, or on those that exact numbers tell where
/// the curve turns next to it.
void add_place(const Arranged_point& p, const Arranged_curve& c, const Bracket& t) {
  std::size_t first = 0, last = 0;
  if (is_end_of_piece(t)) {
    first = last = t.lower == 0 ? 0 : c.turns().size();
  } else {
    for (const Bracket& turn : c.turns()) {
      if (turn.upper < t.lower) ++first;
      if (turn.lower <= t.upper) ++last;
    }
  }
  if (first == last) add_place(p, {c.number(), first, t});
  else add_places(p, c, t);
}

/// \param t where the first curve is at the point, and s where the second one is
/// \param exact the same in exact numbers, if that is known
[[nodiscard]] Arranged_point_handle common_point(const std::shared_ptr<const Arranged_pair>& pair, const Bracket& t,
                                                 const Bracket& s, std::shared_ptr<Exact_place> exact = nullptr) {
  const Arranged_curve &a = *pair->a, &b = *pair->b;
  Arranged_point_handle point;
  if (is_end_of_piece(t)) {
    point = t.lower == 0 ? a.start() : a.end();
  } else if (is_end_of_piece(s)) {
    point = s.lower == 0 ? b.start() : b.end();
  } else {
    auto data = std::make_shared<Arranged_point>();
    const Arranged_curve::Box p = a.at(t), q = b.at(s);
    data->x = {(std::max)(p.x.lower, q.x.lower), (std::min)(p.x.upper, q.x.upper)};
    data->y = {(std::max)(p.y.lower, q.y.lower), (std::min)(p.y.upper, q.y.upper)};
    data->pair = pair;
    data->t = t;
    data->s = s;
    data->exact = std::move(exact);
    point = std::move(data);
  }
  add_place(*point, a, t);
  add_place(*point, b, s);
  return point;
}

/// What a curve has in common with itself, each pair of parameters in rising order.
[[nodiscard]] Piece_intersections self_intersections(const Bezier_curve_2<double>& curve) {
  Drawing_2<double> drawing;
  drawing.add({curve});
  const Bounding_arc_tree_2 hierarchy(drawing, Decisions::EXACT);
  const Numbered_intersections found = Intersection_search(hierarchy.in_unit()).by_pieces();
  Piece_intersections result;
  for (const Numbered_point& p : found.points)
    result.points.push_back(p.common.a.lower < p.common.b.lower
                                ? p.common
                                : Piece_intersections::Intersection{p.common.b, p.common.a, p.common.kind});
  for (const Numbered_overlap& o : found.overlaps) result.overlaps.push_back(o.common);
  return result;
}

/// Whether brackets tell exact parameters, of which each is in one of them: of a point both parameters.
[[nodiscard]] bool are_told_by_brackets(const std::vector<Piece_intersections::Intersection>& points,
                                        bool is_one_curve) {
  std::vector<Bracket> of_a, of_b;
  for (const Piece_intersections::Intersection& p : points) {
    of_a.push_back(p.a);
    (is_one_curve ? of_a : of_b).push_back(p.b);
  }
  for (std::vector<Bracket>* brackets : {&of_a, &of_b}) {
    std::sort(brackets->begin(), brackets->end(), [](const Bracket& t, const Bracket& s) {
      return std::tie(t.lower, t.upper) < std::tie(s.lower, s.upper);
    });
    const auto may_be_one = [](const Bracket& t, const Bracket& s) {
      return t.touches(s) && !(t.is_single() && s.is_single());
    };
    if (std::adjacent_find(brackets->begin(), brackets->end(), may_be_one) != brackets->end()) return false;
  }
  return true;
}

/// What two curves have in common, in brackets that tell all of it; no overlaps but of lines.
[[nodiscard]] std::optional<Piece_intersections> common_by_doubles(const Arranged_pair& pair) {
  const Bezier_curve_2<double>&a = pair.a->bezier(), &b = pair.b->bezier();
  const bool is_one_curve = pair.a == pair.b, are_lines = is_line(a) && is_line(b) && !is_one_curve;
  std::optional<Piece_intersections> found;
  if (are_lines) found = line_intersections(a, b);
  if (!found) found = is_one_curve ? self_intersections(a) : intersections_by_doubles(a, b);
  if (!found && are_lines) found = Piece_intersections{{line_crossing(a, b)}, {}};
  if (!found || (!are_lines && !found->overlaps.empty()) || !are_told_by_brackets(found->points, is_one_curve))
    return std::nullopt;
  return found;
}

void add_exact_meetings(Arranged_meetings& to) {
  const Exact_common& common = exact_common(*to.pair);
  const Arranged_curve &first = common.is_b_first ? *to.pair->b : *to.pair->a,
                       &second = common.is_b_first ? *to.pair->a : *to.pair->b;
  const auto point = [&](const Exact_parameter& t, const Bracket& s) {
    const Bracket range = t.range();
    return common_point(to.pair, common.is_b_first ? s : range, common.is_b_first ? range : s,
                        std::make_shared<Exact_place>(first.exact(), t));
  };
  for (const Exact_meeting& m : common.found.points)
    to.points.push_back({point(Exact_parameter(m.t), m.s), m.kind == Intersection_kind::TRANSVERSAL});
  const auto way = [](const Arranged_curve& c, const Exact_parameter& start, const Exact_parameter& end) {
    const bool is_forward = start.compare(end) < 0;
    const Branches at_start = branches_at(c, start), at_end = branches_at(c, end);
    return Arranged_meetings::Way{is_forward ? at_start.behind : at_start.before,
                                  is_forward ? at_end.before : at_end.behind, is_forward};
  };
  for (const Exact_overlap& o : common.found.overlaps) {
    const Exact_parameter t_from(o.t_from), t_to(o.t_to), s_from(o.s_from), s_to(o.s_to);
    const auto along_first = way(first, t_from, t_to), along_second = way(second, s_from, s_to);
    to.overlaps.push_back({point(t_from, s_from.range()), point(t_to, s_to.range()),
                           common.is_b_first ? along_second : along_first,
                           common.is_b_first ? along_first : along_second});
  }
}

[[nodiscard]] Arranged_meetings make_meetings(std::shared_ptr<const Arranged_pair> pair) {
  Arranged_meetings result{std::move(pair), {}, {}};
  const Arranged_curve &a = *result.pair->a, &b = *result.pair->b;
  const std::optional<Piece_intersections> found = common_by_doubles(*result.pair);
  if (!found) {
    add_exact_meetings(result);
    return result;
  }
  for (const Piece_intersections::Intersection& p : found->points)
    result.points.push_back({common_point(result.pair, p.a, p.b), p.kind == Intersection_kind::TRANSVERSAL});
  const auto is_to_right = [](const Arranged_curve& line) {
    return compare_xy(Arr_point_2(line.start()), Arr_point_2(line.end())) == SMALLER;
  };
  for (const Piece_intersections::Overlap& o : found->overlaps)
    result.overlaps.push_back({common_point(result.pair, o.a_from, o.b_from),
                               common_point(result.pair, o.a_to, o.b_to),
                               {0, 0, true},
                               {0, 0, is_to_right(a) == is_to_right(b)}});
  return result;
}

/// Whether tangents turn by less than half a turn, or run along the chord. Tangents are combinations of the control
/// polygon's legs, with coefficients that are not negative; so all go ahead in one direction.
[[nodiscard]] bool goes_ahead(const Arranged_curve& c) {
  const auto& p = c.bezier().control_points();
  const double size = 16 * HALF_ULP * c.evaluator().coordinate_size();  // of products of differences, by their lengths
  const auto are_legs = [&](const auto& is_leg_of) {
    return std::adjacent_find(p.begin(), p.end(), [&](const auto& q, const auto& r) { return !is_leg_of(r - q); }) ==
           p.end();
  };
  const Xy<double> chord = p.back() - p.front();
  const double along = size * euclidean_norm(chord);
  if (are_legs([&](const Xy<double>& leg) { return dot(chord, leg) > along; })) return true;
  for (std::size_t i = 1; i < p.size(); ++i) {  // all others are to the left of one leg
    const Xy<double> first = p[i] - p[i - 1];
    const double beside = size * euclidean_norm(first);
    if (are_legs([&](const Xy<double>& leg) { return leg == first || cross(first, leg) > beside; })) return true;
  }
  return false;
}

/// Whether it is a polynomial cubic a t^3 + b t^2 + c t + d without a loop. A loop is at parameters of sum u and
/// product v with a (u^2 - v) + b u + c = 0. The cross product with a has u alone, the dot product has v. Both
/// parameters are in [0,1] where u^2 >= 4 v, 0 <= u <= 2, v >= 0 and 1 - u + v >= 0.
[[nodiscard]] bool is_cubic_without_loop(const Bezier_curve_2<double>& curve) {
  if (curve.degree() != 3 || curve.is_rational()) return false;
  const Protect_FPU_rounding<true> upward;
  using Interval = Unprotected_interval;
  Xy<Interval> p[4];
  for (std::size_t i = 0; i < 4; ++i)
    p[i] = {Interval(curve.control_points()[i].x), Interval(curve.control_points()[i].y)};
  const Interval three(3);
  const Xy<Interval> first = p[1] - p[0], second = p[2] - p[1], c = three * first, b = three * (second - first),
                     a = (p[3] - p[0]) - three * second;
  const Interval turn = cross(a, b);
  if (certain_sign(turn) == 0) return false;
  const Interval u = -cross(a, c) / turn, v = u * u + (dot(a, b) * u + dot(a, c)) / dot(a, a);
  for (const Interval& must_not_be_negative : {u * u - Interval(4) * v, u, Interval(2) - u, v, Interval(1) - u + v})
    if (certain_sign(must_not_be_negative) < 0) return true;
  return false;
}

/// Filter of what a curve has in common with itself.
[[nodiscard]] bool has_no_loop(const Arranged_curve& c) { return goes_ahead(c) || is_cubic_without_loop(c.bezier()); }

}  // namespace

const Arranged_meetings& Meetings_of_pairs::of(const Arranged_curve_handle& a, const Arranged_curve_handle& b) {
  static const Arranged_meetings NONE;
  if (a == b ? has_no_loop(*a) : !a->x().touches(b->x()) || !a->y().touches(b->y())) return NONE;
  const bool is_exchanged = b->number() < a->number();
  const Arranged_curve_handle &first = is_exchanged ? b : a, &second = is_exchanged ? a : b;
  Arranged_meetings& known = known_[{first->number(), second->number()}];
  if (!known.pair) known = make_meetings(std::make_shared<const Arranged_pair>(first, second));
  return known;
}

namespace {

/// Filter: ranges in (0,1) with one simple root of x' each, and all roots there; of y' where the piece is upright.
/// \return nothing where intervals do not tell
[[nodiscard]] std::optional<std::vector<Bracket>> turn_ranges(const Bezier_curve_2<double>& c, bool is_vertical) {
  const Protect_FPU_rounding<true> upward;
  internal::Interval_isolation::Polynomial::Coefficients coordinates, weights;
  for (int i = 0; i <= c.degree(); ++i) {
    const auto& p = c.control_points()[static_cast<std::size_t>(i)];
    weights.emplace_back(c.weight(i));
    coordinates.push_back(Unprotected_interval(is_vertical ? p.y : p.x) * weights.back());
  }
  const internal::Interval_isolation::Polynomial x(std::move(coordinates)), w(std::move(weights)),
      way = c.is_rational() ? x.derivative() * w - x * w.derivative() : x.derivative(), change = way.derivative();
  const internal::Interval_isolation found(way);
  if (!found.undecided.empty()) return std::nullopt;
  std::vector<Bracket> ranges;
  for (const Root_cell& cell : found.cells) {
    constexpr double NARROW = 0x1p-50, ENOUGH = 0x1p-30;
    Bracket range{cell.lo, cell.hi};
    while (range.width() > NARROW) {  // by signs, and by Newton's method in intervals (Moore 1966)
      const Unprotected_interval t(range.middle()), at = way(t), rise = change({range.lower, range.upper});
      Bracket next = range;
      if (const int sign = certain_sign(at); sign != 0) (sign == cell.lower_sign ? next.lower : next.upper) = t.inf();
      if (certain_sign(rise) != 0) {
        const Unprotected_interval root = t - at / rise;
        next = {(std::max)(next.lower, root.inf()), (std::min)(next.upper, root.sup())};
      }
      if (next.width() > range.width() / 2) break;
      range = next;
    }
    if (range.width() > ENOUGH) return std::nullopt;
    ranges.push_back(range);
  }
  std::sort(ranges.begin(), ranges.end(), [](const Bracket& p, const Bracket& q) { return p.lower < q.lower; });
  return ranges;
}

}  // namespace

const std::vector<Bracket>& Arranged_curve::turns() const {
  return turns_([this] {
    if (auto ranges = turn_ranges(bezier(), is_vertical())) return *std::move(ranges);
    std::vector<Bracket> ranges;
    for (const Exact_parameter& t : exact_turns()) ranges.push_back(t.range());
    return ranges;
  });
}

std::vector<Arr_curve_2::Part> x_monotone_parts(const Arr_curve_2& curve) {
  const Arranged_curve_handle& c = curve.data();
  if (c->is_vertical() && c->y().is_single()) return {};
  std::vector<Arr_curve_2::Part::End> ends{{Arr_point_2(c->start()), {0, 0}}};
  for (const Bracket& range : c->turns()) {
    auto turn = std::make_shared<Arranged_point>();
    turn->turn = ends.size() - 1;
    const Arranged_curve::Box box = c->at(range);
    turn->x = box.x;
    turn->y = box.y;
    turn->turning = c;
    turn->places = {{c->number(), turn->turn, range}, {c->number(), turn->turn + 1, range}};
    ends.push_back({Arr_point_2(std::move(turn)), range});
  }
  ends.push_back({Arr_point_2(c->end()), {1, 1}});
  for (const Arr_curve_2::Part::End* end : {&ends.front(), &ends.back()}) add_place(*end->point.data(), *c, end->t);
  std::vector<Arr_curve_2::Part> result;
  bool is_rising = compare_xy(ends[0].point, ends[1].point) == SMALLER;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i, is_rising = !is_rising)
    result.emplace_back(c, i, is_rising, ends[is_rising ? i : i + 1], ends[is_rising ? i + 1 : i]);
  return result;
}

std::vector<Xy<double>> approximate_polyline(const Arr_curve_2::Part& c, double error) {
  const double from = c.left_parameter().middle(), to = c.right_parameter().middle();
  constexpr double MOST = 1e6;
  const double legs =
      std::ceil(std::fabs(to - from) * std::sqrt(c.data()->evaluator().second_bound() / (8 * error)));  // |C''| h^2 / 8
  const auto count = static_cast<std::size_t>(std::clamp(legs, 1.0, MOST));
  const auto rounded = [](const Arr_point_2& p) { return Xy<double>{p.x().middle(), p.y().middle()}; };
  const Xy<double> last = rounded(c.right());
  std::vector<Xy<double>> result{rounded(c.left())};
  for (std::size_t i = 1; i < count; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(count);
    const Xy<double> p = c.data()->evaluator()(from + part * (to - from)).point;
    result.push_back(
        {(std::min)((std::max)(p.x, result.back().x), last.x), p.y});  // beside an upright tangent x is off by an ulp
  }
  result.push_back(last);
  return result;
}

}  // namespace CGAL::Bounding_arcs::internal
