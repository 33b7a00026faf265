// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The search for common points.

#ifndef BOUNDING_ARCS_LIBRARY_QUERY_INTERSECTION_SEARCH_H
#define BOUNDING_ARCS_LIBRARY_QUERY_INTERSECTION_SEARCH_H

#include <CGAL/Bounding_arcs_2/query/Intersections_2.h>
#include "../curve/exact_bezier.h"
#include "../tree/Segment_hierarchy.h"
#include "Newton_box.h"
#include "Segment_pair_search.h"
#include "exact_intersections.h"
#include "join_intersections.h"
#include "nearer_look.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

/// The search for common points of drawings: pairs of segments in doubles (Segment_pair_search.h), pairs of Bezier
/// pieces exactly, and joints counted once.
/// \tparam Curves Segment_hierarchy, or one that has regions of another kind
template <class Curves = Segment_hierarchy> class Intersection_search {
  template <class> friend class Intersection_search;
  using Pair = std::pair<std::uint32_t, std::uint32_t>;  // of Bezier pieces, numbered through

 public:
  Intersection_search(const Curves& a, const Curves& b) : Intersection_search(a, b, false) {}
  explicit Intersection_search(const Curves& a) : Intersection_search(a, a, true) {}

  [[nodiscard]] Intersections_2<> all() {
    find_all();
    return internal::joined(found_, pairs_.joints_a(), pairs_.joints_b(), is_self_);
  }
  /// Returns them by Bezier pieces, nothing joined: what is at a joint is there for each piece that ends or starts
  /// there.
  [[nodiscard]] Numbered_intersections by_pieces() && {
    find_all();
    return std::move(found_);
  }

  [[nodiscard]] std::optional<bool> any() {
    const auto is_certain = [this] {
      if (!pairs_.ends().empty() || !found_.points.empty() || !found_.overlaps.empty()) return true;
      for (const internal::Newton_box& root : pairs_.roots())
        if (root.is_inside()) return true;
      return false;
    };
    search([&] { return !is_certain(); });
    if (is_certain()) return true;
    Intersection_search whole(a_, b_);
    const Intersections_2<> rest = pairs_.open().empty() && pairs_.roots().empty() ? Intersections_2<>{} : whole.all();
    for (const Intersections_2<>::Intersection& p : rest.points)
      if (p.kind != Intersection_kind::UNDECIDED) return true;
    if (!rest.overlaps.empty()) return true;
    return rest.points.empty() ? std::optional(false) : std::nullopt;
  }

 private:
  Intersection_search(const Curves& a, const Curves& b, bool is_self)
      : a_(a), b_(b), is_self_(is_self), pairs_(a, b, is_self) {}

  void find_all() {
    search([] { return true; });
    leave_open_what_is_at_ends();
    if (is_self_)
      for (const std::uint32_t bezier : a_.hidden_tips()) open_.emplace_back(bezier, bezier);
    std::sort(open_.begin(), open_.end());
    open_.erase(std::unique(open_.begin(), open_.end()), open_.end());
    if (exact())
      open_.erase(
          std::remove_if(open_.begin(), open_.end(), [this](const Pair& beziers) { return is_seen_nearer(beziers); }),
          open_.end());
    keep_proven();
    if (!exact()) return add_undecided();
    for (const Pair& pair : open_) {
      if (looks_ == 0) add_exactly(pair);
      else found_.points.push_back({pair, {{0, 1}, {0, 1}, Intersection_kind::UNDECIDED}});
    }
  }

  // Filter of elimination, where that takes long: see nearer_look.h. Ends, overlaps, tangencies and turns back are left
  // open.
  [[nodiscard]] bool is_seen_nearer(const Pair& beziers) {
    constexpr int MOST_LOOKS = 3, LEAST = 64;  // of degrees' products
    const std::uint32_t a = beziers.first, b = beziers.second;
    const bool is_own = is_self_ && a == b;
    if (looks_ == MOST_LOOKS || a_.bezier(a).degree() * b_.bezier(b).degree() < LEAST) return false;
    if (is_own && std::binary_search(a_.hidden_tips().begin(), a_.hidden_tips().end(), a)) return false;
    const auto is_of_pair = [&](const internal::Newton_box& r) { return r.bezier_a == a && r.bezier_b == b; };
    std::vector<internal::Newton_box>& known = pairs_.roots();
    std::vector<internal::Newton_box> roots, found;
    std::copy_if(known.begin(), known.end(), std::back_inserter(roots), is_of_pair);
    const auto is_inside = [](const internal::Newton_box& r) { return r.is_inside(); };
    if (!std::all_of(roots.begin(), roots.end(), is_inside)) return false;
    for (const Numbered_point& place : places_of(beziers)) {
      const Bracket &t = place.common.a, &s = place.common.b;
      const auto is_there = [&](const internal::Newton_box& r) { return r.a.touches(t) && r.b.touches(s); };
      const auto is_within = [&](const internal::Newton_box& r) {
        return t.lower < r.a.lower && r.a.upper < t.upper && s.lower < r.b.lower && r.b.upper < s.upper;
      };
      for (const internal::Newton_box& r : roots)
        if (is_there(r) && !is_within(r)) return false;
      roots.erase(std::remove_if(roots.begin(), roots.end(), is_there), roots.end());  // they are found once more
      if (!add_nearer(place, found)) return false;
    }
    known.erase(std::remove_if(known.begin(), known.end(), is_of_pair), known.end());
    known.insert(known.end(), roots.begin(), roots.end());
    known.insert(known.end(), found.begin(), found.end());
    return true;
  }
  // Boxes with all that doubles leave open of two pieces, apart from each other. Where both are one, a box with equal
  // parameters is a square about these.
  [[nodiscard]] std::vector<Numbered_point> places_of(const Pair& beziers) const {
    std::vector<Numbered_point> places;
    for (const Numbered_point& o : pairs_.open())
      if (o.beziers == beziers)
        places.push_back({beziers, {internal::with_room(o.common.a), internal::with_room(o.common.b), o.common.kind}});
    for (std::size_t count = 0; count != places.size();) {
      count = places.size();
      std::vector<Numbered_point> joined;
      internal::add_clusters(std::move(places), joined);
      places = std::move(joined);
      for (Numbered_point& p : places)
        if (is_self_ && beziers.first == beziers.second && p.common.a.touches(p.common.b))
          p.common.a = p.common.b = {(std::min)(p.common.a.lower, p.common.b.lower),
                                     (std::max)(p.common.a.upper, p.common.b.upper)};
    }
    return places;
  }
  // The common points in a box. \return false where they are not all told
  [[nodiscard]] bool add_nearer(const Numbered_point& place, std::vector<internal::Newton_box>& found) const {
    constexpr double MOST = 0x1p-2;  // of parts: larger ones are what they were
    const auto [a, b] = place.beziers;
    const Bracket &t = place.common.a, &s = place.common.b;
    const auto is_part = [](const Bracket& r) { return 0 < r.lower && r.upper < 1 && r.width() < MOST; };
    if (!is_part(t) || !is_part(s)) return false;
    const bool is_square = is_self_ && a == b && t.touches(s);
    if (is_square && does_run_ahead(place)) return true;
    const auto look = internal::look_nearer(a_.exact_bezier(a), t, b_.exact_bezier(b), s);
    if (!look) return false;
    Intersection_search<> nearer = is_square ? Intersection_search<>(look->a) : Intersection_search<>(look->a, look->b);
    nearer.looks_ = looks_ + 1;
    const Numbered_intersections common = std::move(nearer).by_pieces();
    const auto is_crossing = [](const Numbered_point& p) {
      const Bracket &u = p.common.a, &v = p.common.b;
      return p.common.kind == Intersection_kind::TRANSVERSAL && u.lower > 0 && u.upper < 1 && v.lower > 0 &&
             v.upper < 1;
    };
    if (!common.overlaps.empty() || !std::all_of(common.points.begin(), common.points.end(), is_crossing)) return false;
    for (const Numbered_point& p : common.points) {
      const Bracket at = internal::parameter_on_whole(t, p.common.a), on = internal::parameter_on_whole(s, p.common.b);
      found.push_back({a, b, at, on, at, on, a_.evaluator(a)(at.middle()).point});
    }
    return true;
  }

  [[nodiscard]] bool exact() const { return a_.decisions() == Decisions::EXACT && b_.decisions() == Decisions::EXACT; }

  // \param go_on bool(), asked after each two segments
  template <class GoOn> void search(const GoOn& go_on) {
    const auto visit = [&](std::uint32_t i, std::uint32_t j) {
      if (is_self_ && j < i) std::swap(i, j);
      if (pairs_.is_same_piece(i, j) && a_.piece(i).first.t == b_.piece(j).first.t) {
        if (a_.piece(i).first.t == 0)
          found_.overlaps.push_back({{a_.bezier_of(i), b_.bezier_of(j)}, {{0, 0}, {1, 1}, {0, 0}, {1, 1}}});
        return go_on();
      }
      if (add_of_lines(a_.bezier_of(i), b_.bezier_of(j))) return go_on();
      if (const auto end = sole_common_end(a_.bezier_of(i), b_.bezier_of(j))) {
        const Spiral_piece_2 of_a = a_.piece(i), of_b = b_.piece(j);
        const Spiral_sample &p = end->first == 0 ? of_a.first : of_a.last,
                            &q = end->second == 0 ? of_b.first : of_b.last;
        if (p.t == end->first && q.t == end->second) pairs_.add_common_end(i, p.t, j, q.t);
        return go_on();
      }
      pairs_.look_at(i, j);
      return go_on();
    };
    if (is_self_) for_each_overlap(a_.boxes(), visit);
    else for_each_overlap(a_.boxes(), b_.boxes(), visit);
  }

  [[nodiscard]] bool are_lines(const Pair& beziers) const {
    const auto [a, b] = beziers;
    return is_line(a_.bezier(a)) && is_line(b_.bezier(b)) && a_.rounding(a) == 0 && b_.rounding(b) == 0;
  }
  // Filter: line segments, but for those that cross between their ends.
  // \return whether all of their common points are told
  [[nodiscard]] bool add_of_lines(std::uint32_t a, std::uint32_t b) {
    if (!are_lines({a, b})) return false;
    const std::optional<Piece_intersections> common = line_intersections(a_.bezier(a), b_.bezier(b));
    if (!common) return false;
    for (const Piece_intersections::Intersection& p : common->points)
      if (!is_self_ || !pairs_.is_joint_of_neighbours({a, b}, p.a, p.b)) found_.points.push_back({{a, b}, p});
    for (const Piece_intersections::Overlap& o : common->overlaps) found_.overlaps.push_back({{a, b}, o});
    return true;
  }
  // Filter: a level or upright line through a common end has the other control points of both pieces on different
  // sides, and none on it, so the curves, too.  Comparisons of doubles: exact.
  // \return the parameters of the only common point, if it is such a one
  [[nodiscard]] std::optional<std::pair<double, double>> sole_common_end(std::uint32_t a, std::uint32_t b) const {
    if ((is_self_ && a == b) || a_.rounding(a) != 0 || b_.rounding(b) != 0) return std::nullopt;
    const auto &p = a_.bezier(a).control_points(), &q = b_.bezier(b).control_points();
    for (const bool is_p_last : {false, true})
      for (const bool is_q_last : {false, true}) {
        const Xy<double>& at = is_p_last ? p.back() : p.front();
        if (!(at == (is_q_last ? q.back() : q.front()))) continue;
        const auto side = [&at](const auto& points, bool is_last, double Xy<double>::*number) {
          const auto is_at = [&](auto beyond) {
            return std::all_of(points.begin() + (is_last ? 0 : 1), points.end() - (is_last ? 1 : 0), beyond);
          };
          if (is_at([&](const Xy<double>& r) { return r.*number < at.*number; })) return -1;
          return is_at([&](const Xy<double>& r) { return r.*number > at.*number; }) ? 1 : 0;
        };
        for (const auto number : {&Xy<double>::x, &Xy<double>::y})
          if (side(p, is_p_last, number) * side(q, is_q_last, number) < 0)
            return std::pair(is_p_last ? 1.0 : 0.0, is_q_last ? 1.0 : 0.0);
      }
    return std::nullopt;
  }

  // A root whose range reaches over an end of its piece may be on the next one, or none.
  void leave_open_what_is_at_ends() {
    for (const Numbered_point& o : pairs_.open()) {
      if (!open_.empty() && open_.back() == o.beziers) continue;
      if (!does_run_ahead(o)) open_.push_back(o.beziers);
    }
    for (const internal::Newton_box& root : pairs_.roots())
      if (!root.is_inside()) open_.push_back({root.bezier_a, root.bezier_b});
  }
  // Filter: of one piece, from the one part to the other one.
  [[nodiscard]] bool does_run_ahead(const Numbered_point& o) const {
    const Bracket &t = o.common.a, &s = o.common.b;
    return is_self_ && o.beziers.first == o.beziers.second && exact() &&
           runs_ahead(a_.exact_bezier(o.beziers.first), (std::min)(t.lower, s.lower), (std::max)(t.upper, s.upper));
  }
  [[nodiscard]] bool is_open(const Pair& beziers) const {
    return std::binary_search(open_.begin(), open_.end(), beziers);
  }

  // Roots of pairs that are not open, each once, and common ends.
  void keep_proven() {
    std::vector<internal::Newton_box>& roots = pairs_.roots();
    const auto before = [](const internal::Newton_box& x, const internal::Newton_box& y) {
      if (x.bezier_a != y.bezier_a) return x.bezier_a < y.bezier_a;
      return x.bezier_b != y.bezier_b ? x.bezier_b < y.bezier_b : x.a.lower < y.a.lower;
    };
    std::sort(roots.begin(), roots.end(), before);
    std::vector<const internal::Newton_box*> kept;  // of the same two pieces
    for (const internal::Newton_box& root : roots) {
      const Pair beziers{root.bezier_a, root.bezier_b};
      if ((is_open(beziers) && exact()) || !root.is_inside()) continue;
      if (!kept.empty() && beziers != Pair{kept.back()->bezier_a, kept.back()->bezier_b}) kept.clear();
      const auto is_this = [&](const internal::Newton_box* k) { return k->is_same(root) || root.is_same(*k); };
      if (std::any_of(kept.begin(), kept.end(), is_this)) continue;
      found_.points.push_back({beziers, {root.a, root.b, Intersection_kind::TRANSVERSAL}});
      kept.push_back(&root);
    }
    for (const Numbered_point& end : pairs_.ends()) {
      if (is_open(end.beziers) && exact()) continue;
      found_.points.push_back({end.beziers, {end.common.a, end.common.b, kind_at(end)}});
    }
  }
  [[nodiscard]] Intersection_kind kind_at(const Numbered_point& end) const {
    const auto [first, second] = end.beziers;
    const double t = end.common.a.lower, s = end.common.b.lower;
    const Xy<double> u = end_direction(a_.bezier(first), t), v = end_direction(b_.bezier(second), s);
    // differences err by 2 roundings of coordinates, and products by one of themselves
    const double error_u = 4 * (a_.rounding(first) + HALF_ULP * a_.evaluator(first).coordinate_size()),
                 error_v = 4 * (b_.rounding(second) + HALF_ULP * b_.evaluator(second).coordinate_size());
    const double length_u = euclidean_norm(u), length_v = euclidean_norm(v);
    if (std::fabs(cross(u, v)) >
        length_u * error_v + length_v * error_u + error_u * error_v + 4 * HALF_ULP * length_u * length_v)
      return Intersection_kind::TRANSVERSAL;
    const auto exact_u = end_direction(a_.exact_bezier(first), t), exact_v = end_direction(b_.exact_bezier(second), s);
    return cross(exact_u, exact_v) == Exact_rational(0) ? Intersection_kind::TANGENTIAL
                                                        : Intersection_kind::TRANSVERSAL;
  }

  void add_exactly(const Pair& beziers) {
    if (are_lines(beziers)) {  // which cross, as add_of_lines left them open
      found_.points.push_back({beziers, line_crossing(a_.bezier(beziers.first), b_.bezier(beziers.second))});
      return;
    }
    const bool is_own = is_self_ && beziers.first == beziers.second;
    const Piece_intersections exact =
        is_own ? exact_self_intersections(a_.exact_bezier(beziers.first))
               : exact_intersections(a_.exact_bezier(beziers.first), b_.exact_bezier(beziers.second));
    for (const Piece_intersections::Intersection& p : exact.points) found_.points.push_back({beziers, p});
    for (const Piece_intersections::Overlap& o : exact.overlaps) found_.overlaps.push_back({beziers, o});
  }

  // Ranges that touch are one.
  void add_undecided() {
    std::vector<Numbered_point> open = pairs_.open();
    for (const internal::Newton_box& root : pairs_.roots())
      if (!root.is_inside())
        open.push_back(
            {{root.bezier_a, root.bezier_b}, {within(root.a), within(root.b), Intersection_kind::UNDECIDED}});
    internal::add_clusters(std::move(open), found_.points);
  }
  [[nodiscard]] static Bracket within(const Bracket& t) {
    return {std::clamp(t.lower, 0.0, 1.0), std::clamp(t.upper, 0.0, 1.0)};
  }

  const Curves &a_, &b_;
  bool is_self_;
  Segment_pair_search<Curves> pairs_;
  int looks_ = 0;           // how often parts were enlarged
  std::vector<Pair> open_;  // sorted, once it is complete
  Numbered_intersections found_;
};

}  // namespace CGAL::Bounding_arcs

#endif
