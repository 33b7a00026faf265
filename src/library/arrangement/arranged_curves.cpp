// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Curves of arrangements: what is known of them ahead, their parts that are monotone in x, what two have in common.

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>
#include <CGAL/Bounding_arcs_2/arrangement/internal/Exact_place.h>
#include <CGAL/Bounding_arcs_2/arrangement/internal/arr_predicates.h>
#include <CGAL/Bounding_arcs_2/curve/exact_bezier.h>
#include <CGAL/Bounding_arcs_2/curve/served_range.h>
#include <CGAL/Bounding_arcs_2/polynomial/Bernstein_polynomial.h>
#include <CGAL/Bounding_arcs_2/query/Intersection_search.h>
#include <CGAL/Bounding_arcs_2/query/piece_pair_intersections.h>
#include <CGAL/Bounding_arcs_2/tree/Drawing_hierarchy.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace CGAL::Bounding_arcs::internal {

namespace {

[[nodiscard]] Arranged_point_handle point_of_doubles(const Xy<double>& p) {
  auto data = std::make_shared<Arranged_point>();
  data->x = {p.x, p.x};
  data->y = {p.y, p.y};
  return data;
}

[[nodiscard]] const Bezier_curve_2<double>& checked(const Bezier_curve_2<double>& curve) {
  check_served(curve);
  return curve;
}

[[nodiscard]] bool is_end(const Bracket& t) { return t.is_single() && (t.lower == 0 || t.lower == 1); }

[[nodiscard]] double below(double x) { return std::nextafter(x, -std::numeric_limits<double>::infinity()); }
[[nodiscard]] double above(double x) { return std::nextafter(x, std::numeric_limits<double>::infinity()); }

}  // namespace

Arranged_curve::Arranged_curve(const Bezier_curve_2<double>& bezier, std::size_t curve, std::size_t piece)
    : evaluator_(checked(bezier)), curve_(curve), piece_(piece) {
  static std::atomic<std::uint64_t> count{0};
  number_ = ++count;
  const auto& p = bezier.control_points();
  start_ = point_of_doubles(p.front());
  end_ = p.front() == p.back() ? start_ : point_of_doubles(p.back());
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

const std::shared_ptr<const Integer_piece>& Arranged_curve::exact() const {
  return exact_([this] { return std::make_shared<const Integer_piece>(exact_bezier(bezier())); });
}

Arranged_curve::Box Arranged_curve::at(const Bracket& t) const {
  if (is_end(t)) {
    const Xy<double>& p = t.lower == 0 ? bezier().control_points().front() : bezier().control_points().back();
    return {{p.x, p.x}, {p.y, p.y}};
  }
  const double middle = t.lower + t.width() / 2, reach = evaluator_.point_error() + first_bound_ * t.width();
  const Xy<double> p = evaluator_(middle).point;
  return {{below(p.x - reach), above(p.x + reach)}, {below(p.y - reach), above(p.y + reach)}};
}

namespace {

/// \param t where a is at the point, and s where b is
[[nodiscard]] Arranged_point_handle common_point(const Arranged_curve_handle& a, const Bracket& t,
                                                 const Arranged_curve_handle& b, const Bracket& s,
                                                 bool is_overlap_end) {
  const auto end_of = [](const Arranged_curve& c, const Bracket& at, const Arranged_curve& other,
                         const Bracket& place) {
    const Arranged_point_handle& end = at.lower == 0 ? c.start() : c.end();
    add_place(*end, {other.number(), place});
    return end;
  };
  if (is_end(t)) return end_of(*a, t, *b, s);
  if (is_end(s)) return end_of(*b, s, *a, t);
  auto data = std::make_shared<Arranged_point>();
  const Arranged_curve::Box p = a->at(t), q = b->at(s);
  data->x = {(std::max)(p.x.lower, q.x.lower), (std::min)(p.x.upper, q.x.upper)};
  data->y = {(std::max)(p.y.lower, q.y.lower), (std::min)(p.y.upper, q.y.upper)};
  data->places = {{a->number(), t}, {b->number(), s}};
  data->curve = a;
  data->other = b;
  data->is_overlap_end = is_overlap_end;
  return data;
}

[[nodiscard]] Piece_intersections self_intersections(const Bezier_curve_2<double>& curve) {
  Drawing_2<double> drawing;
  drawing.add({curve});
  const Drawing_hierarchy hierarchy(drawing, Decisions::EXACT);
  const Intersections_2<> found = Intersection_search(hierarchy.in_unit()).all();
  Piece_intersections result;
  for (const auto& p : found.points) result.points.push_back({p.a.t, p.b.t, p.kind});
  for (const auto& o : found.overlaps) result.overlaps.push_back({o.a_from.t, o.a_to.t, o.b_from.t, o.b_to.t});
  return result;
}

[[nodiscard]] Arranged_meetings make_meetings(const Arranged_curve_handle& a, const Arranged_curve_handle& b) {
  const Piece_intersections found = a == b ? self_intersections(a->bezier()) : intersections(a->bezier(), b->bezier());
  Arranged_meetings result;
  for (const Piece_intersection& p : found.points)
    result.points.push_back({common_point(a, p.a, b, p.b, false), p.a, p.b, p.kind == Intersection_kind::TRANSVERSAL});
  for (const Piece_overlap& o : found.overlaps)
    result.overlaps.push_back({common_point(a, o.a_from, b, o.b_from, true), common_point(a, o.a_to, b, o.b_to, true),
                               o.a_from, o.a_to, o.b_from, o.b_to});
  return result;
}
[[nodiscard]] Arranged_meetings exchanged(Arranged_meetings m) {
  for (auto& p : m.points) std::swap(p.t, p.s);
  for (auto& o : m.overlaps) {
    std::swap(o.t_from, o.s_from);
    std::swap(o.t_to, o.s_to);
  }
  return m;
}

/// No loop, as all legs of the control polygon go ahead in one direction: a line across it meets the curve no more
/// often than the polygon.
[[nodiscard]] bool has_no_loop(const Arranged_curve& c) {
  const auto& p = c.bezier().control_points();
  const auto is_monotone = [&](auto is_ahead) {
    return std::adjacent_find(p.begin(), p.end(), [&](const auto& q, const auto& r) { return !is_ahead(q, r); }) ==
           p.end();
  };
  const Xy<double> chord = p.back() - p.front();
  const double room = 16 * HALF_ULP * c.evaluator().coordinate_size() * euclidean_norm(chord);  // of products
  return is_monotone([](const auto& q, const auto& r) { return q.x < r.x; }) ||
         is_monotone([](const auto& q, const auto& r) { return q.x > r.x; }) ||
         is_monotone([](const auto& q, const auto& r) { return q.y < r.y; }) ||
         is_monotone([](const auto& q, const auto& r) { return q.y > r.y; }) ||
         is_monotone([&](const auto& q, const auto& r) { return dot(chord, r - q) > room; });
}

}  // namespace

const Arranged_meetings& Meetings_of_pairs::of(const Arranged_curve_handle& a, const Arranged_curve_handle& b) {
  static const Arranged_meetings NONE;
  if (a == b ? has_no_loop(*a) : !a->x().touches(b->x()) || !a->y().touches(b->y())) return NONE;
  const bool is_exchanged = b->number() < a->number();
  const Arranged_curve_handle &first = is_exchanged ? b : a, &second = is_exchanged ? a : b;
  Known& known = known_[{first->number(), second->number()}];
  if (!known.a) {
    known.a = first;
    known.b = second;
    known.meetings = make_meetings(first, second);
    if (a != b) known.exchanged = exchanged(known.meetings);
  }
  return is_exchanged ? known.exchanged : known.meetings;
}

namespace {

using Interval_polynomial = Bernstein_polynomial<Unprotected_interval>;

/// Filter: ranges in (0,1) with one simple root each, and all roots there, by Descartes' rule in Bernstein's basis.
/// \pre rounding is upwards
/// \return false where intervals do not tell
[[nodiscard]] bool append_root_ranges(const Interval_polynomial& p, const Bracket& range, int depth,
                                      std::vector<Bracket>& to) {
  Sign_variations variations;
  for (const Unprotected_interval& c : p.scaled_coefficients())
    if (c.inf() != 0 || c.sup() != 0) variations.append(c.inf() > 0 ? 1 : (c.sup() < 0 ? -1 : 0));
  if (variations.most() == 0) return variations.first != 0;
  const bool has_one = variations.fewest == 1 && variations.most() == 1;
  constexpr int DEEPEST_OF_SEVERAL = 12, DEEPEST = 50;
  if (has_one && depth == DEEPEST) {
    to.push_back(range);
    return true;
  }
  if (!has_one && depth >= DEEPEST_OF_SEVERAL) return false;
  const auto [left, right] = p.halves();
  const std::size_t count = to.size();
  const Unprotected_interval& middle = right.scaled_coefficients().front();  // a root there would be in neither half
  const bool is_told = !middle.do_overlap(Unprotected_interval(0)) &&
                       append_root_ranges(left, {range.lower, range.middle()}, depth + 1, to) &&
                       append_root_ranges(right, {range.middle(), range.upper}, depth + 1, to);
  if (is_told || !has_one) return is_told;
  to.resize(count);
  to.push_back(range);  // as narrow as intervals tell
  constexpr int DEPTH_ENOUGH = 30;
  return depth >= DEPTH_ENOUGH;
}
[[nodiscard]] std::optional<std::vector<Bracket>> turn_ranges(const Bezier_curve_2<double>& c, bool is_vertical) {
  const Protect_FPU_rounding<true> upward;
  Interval_polynomial::Coefficients coordinates, weights;
  for (int i = 0; i <= c.degree(); ++i) {
    const auto& p = c.control_points()[static_cast<std::size_t>(i)];
    weights.emplace_back(c.weight(i));
    coordinates.push_back(Unprotected_interval(is_vertical ? p.y : p.x) * weights.back());
  }
  const Interval_polynomial x(std::move(coordinates)), w(std::move(weights));
  const Interval_polynomial slope = c.is_rational() ? x.derivative() * w - x * w.derivative() : x.derivative();
  std::vector<Bracket> ranges;
  if (!append_root_ranges(slope, {0, 1}, 0, ranges)) return std::nullopt;
  return ranges;
}

}  // namespace

const std::vector<Arranged_point_handle>& Arranged_curve::turns() const {
  return turns_([this] {
    std::vector<Arranged_point_handle> result;
    const auto add = [&](const Bracket& range) {
      auto turn = std::make_shared<Arranged_point>();
      const Box box = at(range);
      turn->x = is_vertical() ? x_ : box.x;
      turn->y = box.y;
      turn->places = {{number_, range}};
      turn->turning = weak_from_this();
      turn->turning_bezier = bezier();
      result.push_back(std::move(turn));
    };
    if (const auto ranges = turn_ranges(bezier(), is_vertical())) {
      for (const Bracket& range : *ranges) add(range);
    } else {
      for (Real_root& t : unit_roots(turn_polynomial(*exact(), is_vertical())))
        if (const Bracket range = t.range(); !is_end(range)) add(range);
    }
    return result;
  });
}

std::vector<Arr_x_monotone_curve_2> x_monotone_parts(const Arr_curve_2& curve) {
  const Arranged_curve_handle& c = curve.data();
  if (c->is_vertical() && c->y().is_single()) return {};
  std::vector<std::pair<Arr_point_2, Bracket>> ends{{Arr_point_2(c->start()), {0, 0}}};
  for (const Arranged_point_handle& turn : c->turns()) ends.emplace_back(Arr_point_2(turn), turn->places.front().t);
  ends.emplace_back(Arr_point_2(c->end()), Bracket{1, 1});
  std::vector<Arr_x_monotone_curve_2> result;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const bool is_rising = compare_xy(ends[i].first, ends[i + 1].first) == SMALLER;
    const auto &left = ends[is_rising ? i : i + 1], &right = ends[is_rising ? i + 1 : i];
    result.emplace_back(c, i, left.first, left.second, right.first, right.second, c->is_vertical());
  }
  return result;
}

std::vector<Xy<double>> approximate_polyline(const Arr_x_monotone_curve_2& c, double error) {
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
