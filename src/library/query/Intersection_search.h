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

/// The search for common points of drawings: pairs of segments in doubles, pairs of Bezier pieces exactly, and joints
/// counted once.
///
/// Doubles prove each common point of two spiral segments, or tell the parameters between which they leave it open.
///
/// Pieces A and B are apart, or their tangents are nowhere parallel, or one is halved.
///
///  * Tangents nowhere parallel: they meet at most once, as a chord between two common points would have a direction of
///    both.  Newton's steps lead to a point, where a root is proven to be (Newton_box.h), or none on the pieces.
///  * A common end P is a common point.  With tangents nowhere parallel it is the only one.  It is, too, where A
///    backwards and then B run ahead in one direction u all the way, T.u > 0: such a path does not meet itself.
/// \tparam Curves Segment_hierarchy, or one that has regions of another kind
template <class Curves = Segment_hierarchy> class Intersection_search {
  template <class> friend class Intersection_search;
  using Pair = std::pair<std::uint32_t, std::uint32_t>;  // of Bezier pieces, numbered through
  using Piece = Piece_in_hand<typename Curves::Region>;

 public:
  Intersection_search(const Curves& a, const Curves& b) : a_(a), b_(b), joints_a_(a), joints_b_(b) {}
  explicit Intersection_search(const Curves& a) : Intersection_search(a, a) { is_self_ = true; }

  [[nodiscard]] Intersections_2<> all() {
    find_all();
    return internal::joined(found_, joints_a_, joints_b_, is_self_);
  }
  /// Returns them by Bezier pieces, nothing joined: what is at a joint is there for each piece that ends or starts
  /// there.
  [[nodiscard]] Numbered_intersections by_pieces() && {
    find_all();
    return std::move(found_);
  }

  [[nodiscard]] std::optional<bool> any() {
    const auto is_certain = [this] {
      if (!ends_.empty() || !found_.points.empty() || !found_.overlaps.empty()) return true;
      for (const internal::Newton_box& root : roots_)
        if (root.is_inside()) return true;
      return false;
    };
    search([&] { return !is_certain(); });
    if (is_certain()) return true;
    Intersection_search whole(a_, b_);
    const Intersections_2<> rest = undecided_.empty() && roots_.empty() ? Intersections_2<>{} : whole.all();
    for (const Intersections_2<>::Intersection& p : rest.points)
      if (p.kind != Intersection_kind::UNDECIDED) return true;
    if (!rest.overlaps.empty()) return true;
    return rest.points.empty() ? std::optional(false) : std::nullopt;
  }

 private:
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
    std::vector<internal::Newton_box> roots, found;
    std::copy_if(roots_.begin(), roots_.end(), std::back_inserter(roots), is_of_pair);
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
    roots_.erase(std::remove_if(roots_.begin(), roots_.end(), is_of_pair), roots_.end());
    roots_.insert(roots_.end(), roots.begin(), roots.end());
    roots_.insert(roots_.end(), found.begin(), found.end());
    return true;
  }
  // Boxes with all that doubles leave open of two pieces, apart from each other. Where both are one, a box with equal
  // parameters is a square about these.
  [[nodiscard]] std::vector<Numbered_point> places_of(const Pair& beziers) const {
    std::vector<Numbered_point> places;
    for (const Numbered_point& o : undecided_)
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
      if (is_same_piece(i, j) && a_.piece(i).first.t == b_.piece(j).first.t) {
        if (a_.piece(i).first.t == 0)
          found_.overlaps.push_back({{a_.bezier_of(i), b_.bezier_of(j)}, {{0, 0}, {1, 1}, {0, 0}, {1, 1}}});
        return go_on();
      }
      if (add_of_lines(a_.bezier_of(i), b_.bezier_of(j))) return go_on();
      if (const auto end = sole_common_end(a_.bezier_of(i), b_.bezier_of(j))) {
        const Spiral_piece_2 of_a = a_.piece(i), of_b = b_.piece(j);
        const Spiral_sample &p = end->first == 0 ? of_a.first : of_a.last,
                            &q = end->second == 0 ? of_b.first : of_b.last;
        if (p.t == end->first && q.t == end->second) add_common_end(i, p.t, j, q.t);
        return go_on();
      }
      look_at(i, j);
      return go_on();
    };
    if (is_self_) for_each_overlap(a_.boxes(), visit);
    else for_each_overlap(a_.boxes(), b_.boxes(), visit);
  }

  // Common points of two segments, each proven, or the parameters where doubles leave it open.
  void look_at(std::uint32_t segment_a, std::uint32_t segment_b) {
    error_ = a_.error(segment_a) + b_.error(segment_b);
    budget_ = MOST_PAIRS;
    const auto of_a = a_.region(segment_a), of_b = b_.region(segment_b);  // most are apart, and need no pieces
    if (!are_apart(of_a, of_b)) refine({directed(a_, segment_a), of_a}, {directed(b_, segment_b), of_b});
  }
  // Takes a common end of pieces.
  void add_common_end(std::uint32_t i, double t, std::uint32_t j, double s) {
    if (!is_end(t) || !is_end(s)) return;  // a cut of one piece, or of two with the same numbers
    const Pair beziers{a_.bezier_of(i), b_.bezier_of(j)};
    if (is_self_ && is_joint_of_neighbours(beziers, {t, t}, {s, s})) return;
    ends_.push_back({beziers, {{t, t}, {s, s}}});
  }

  static constexpr int MOST_PAIRS = 400;  // halvings that a tangency within 2^-40 takes, twice

  // A segment as long as a cut is wide does not tell its directions at its ends. All of them are near the one in its
  // middle, as C'' has a bound.
  [[nodiscard]] static Spiral_piece_2 directed(const Curves& curves, std::uint32_t segment) {
    Spiral_piece_2 piece = curves.piece(segment);
    if (std::isfinite(tangent_error(piece.first, piece.last))) return piece;
    const std::uint32_t bezier = curves.bezier_of(segment);
    const Bezier_evaluator& curve = curves.evaluator(bezier);
    const double rounding = curves.rounding(bezier), span = piece.last.t - piece.first.t, t = piece.first.t + span / 2;
    const internal::Curve_jet jet = curve(t);
    const double speed = euclidean_norm(jet.first), error = curve.errors_at(t, jet).first,
                 change = span * (curve.second_bound() + curve.second_change(rounding));
    constexpr double MOST = 0.25;  // a cone that is told apart from others
    const double share = (error + curve.first_change(rounding, error) + change) / speed;
    if (!(share <= MOST)) return piece;
    // vectors that differ by that share of one of them differ by less than (1 + share^2) times as much as directions
    const double room = share * (1 + share * share) * (1 + 0x1p-40) + 4 * HALF_ULP;
    for (Spiral_sample* end : {&piece.first, &piece.last}) {
      end->tangent = (1 / speed) * jet.first;
      end->tangent_error = room;
    }
    return piece;
  }

  void leave_open(const Piece& a, const Piece& b) {
    undecided_.push_back(
        {{a_.bezier_of(a.piece.segment), b_.bezier_of(b.piece.segment)},
         {{a.piece.first.t, a.piece.last.t}, {b.piece.first.t, b.piece.last.t}, Intersection_kind::UNDECIDED}});
  }

  // \pre they are not apart
  void refine(const Piece& a, const Piece& b) {
    const Cones cones(a.piece, b.piece);
    if (is_settled_at_end(a.piece, b.piece, cones)) return;
    if (cones.are_transversal && is_settled_by_newton(a, b)) return;
    const Xy<double> chord_a = a.piece.last.point - a.piece.first.point,
                     chord_b = b.piece.last.point - b.piece.first.point;
    const double size_a = dot(chord_a, chord_a), size_b = dot(chord_b, chord_b);
    constexpr double LEAST = 64;  // times the errors: pieces that are no longer are points as far as doubles tell
    const double least = LEAST * error_;
    if (--budget_ < 0 || (std::max)(size_a, size_b) < least * least) return leave_open(a, b);
    const bool of_a = size_a >= size_b;
    const Piece& longer = of_a ? a : b;
    const Curves& curves = of_a ? a_ : b_;
    const auto middle = halves(curves, longer.piece);
    if (!middle) return leave_open(a, b);
    for (const Spiral_piece_2* half : {&middle->first, &middle->second}) {
      const Piece part{*half, curves.region(*half)};
      const Piece &first = of_a ? part : a, &second = of_a ? b : part;
      if (!are_apart(first.region, second.region)) refine(first, second);
    }
  }

  // How the tangents of two pieces, each in the cone between its ends', which is less than half a turn wide, lie.
  struct Cones {
    const Spiral_piece_2 &a, &b;
    double room;
    bool are_transversal;

    Cones(const Spiral_piece_2& first, const Spiral_piece_2& second) : a(first), b(second) {
      room = tangent_error(a.first, a.last) + tangent_error(b.first, b.last) + TANGENT_ROUNDING;
      const double c00 = cross(a.first.tangent, b.first.tangent), c01 = cross(a.first.tangent, b.last.tangent),
                   c10 = cross(a.last.tangent, b.first.tangent), c11 = cross(a.last.tangent, b.last.tangent);
      are_transversal = (std::min)((std::min)(c00, c01), (std::min)(c10, c11)) > room ||
                        (std::max)((std::max)(c00, c01), (std::max)(c10, c11)) < -room;
    }
    // Whether A away from its end and B away from its one run ahead in opposite directions.
    [[nodiscard]] bool run_apart(double sign_a, double sign_b) const {
      const Xy<double> a0 = -sign_a * a.first.tangent, a1 = -sign_a * a.last.tangent, b0 = sign_b * b.first.tangent,
                       b1 = sign_b * b.last.tangent;
      const Xy<double> ahead = (a0 + a1) + (b0 + b1);
      return (std::min)((std::min)(dot(ahead, a0), dot(ahead, a1)), (std::min)(dot(ahead, b0), dot(ahead, b1))) >
             4 * room;
    }
  };

  [[nodiscard]] bool is_settled_at_end(const Spiral_piece_2& a, const Spiral_piece_2& b, const Cones& cones) {
    for (const bool at_a : {false, true})
      for (const bool at_b : {false, true}) {
        const Spiral_sample &p = at_a ? a.last : a.first, &q = at_b ? b.last : b.first;
        if (!(p.point == q.point) || !is_same_end(a.segment, p.t, b.segment, q.t)) continue;
        if (!cones.are_transversal && !cones.run_apart(at_a ? -1 : 1, at_b ? -1 : 1)) return false;
        add_common_end(a.segment, p.t, b.segment, q.t);
        return true;
      }
    return false;
  }

  // \pre tangents are nowhere parallel
  [[nodiscard]] bool is_settled_by_newton(const Piece& a, const Piece& b) {
    const auto of = [](const Segment_hierarchy& curves, const Spiral_piece_2& p) {
      const std::uint32_t bezier = curves.bezier_of(p.segment);
      return internal::Newton_piece{
          curves.evaluator(bezier), curves.rounding(bezier), bezier, p.first.t, p.last.t, p.first.point, p.last.point};
    };
    const double t0 = a.piece.first.t, t1 = a.piece.last.t, s0 = b.piece.first.t, s1 = b.piece.last.t;
    const std::optional<internal::Newton_box> root = internal::newton_box(of(a_, a.piece), of(b_, b.piece));
    if (!root) return false;
    if (has_common_end(*root, a.piece.segment, b.piece.segment)) return root->is_unique_on(t0, t1, s0, s1);
    if (root->is_on(t0, t1, s0, s1)) {
      roots_.push_back(*root);
      return true;
    }
    return root->is_unique_on(t0, t1, s0, s1);
  }

  // Whether the only root in a box is a common end, which the pieces at that end tell.
  [[nodiscard]] bool has_common_end(const internal::Newton_box& root, std::uint32_t segment_a,
                                    std::uint32_t segment_b) const {
    if (root.is_inside()) return false;
    const auto end_of = [](const Curves& curves, std::uint32_t segment, double t) {
      const auto& p = curves.bezier(curves.bezier_of(segment)).control_points();
      Spiral_sample end;
      end.t = t;
      end.point = t == 0 ? p.front() : p.back();
      return end;
    };
    for (const double t : {0.0, 1.0})
      for (const double s : {0.0, 1.0}) {
        const Spiral_sample p = end_of(a_, segment_a, t), q = end_of(b_, segment_b, s);
        if (root.is_on(t, t, s, s) && p.point == q.point && is_same_end(segment_a, t, segment_b, s)) return true;
      }
    return false;
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
      if (!is_self_ || !is_joint_of_neighbours({a, b}, p.a, p.b)) found_.points.push_back({{a, b}, p});
    for (const Piece_intersections::Overlap& o : common->overlaps) found_.overlaps.push_back({{a, b}, o});
    return true;
  }
  [[nodiscard]] bool is_joint_of_neighbours(const Pair& beziers, const Bracket& t, const Bracket& s) const {
    if (!t.is_single() || !is_end(t.lower) || !s.is_single() || !is_end(s.lower)) return false;
    const Joint_place at_a = joints_a_.place(beziers.first, t), at_b = joints_b_.place(beziers.second, s);
    return at_a.bezier == at_b.bezier && at_a.t.lower == at_b.t.lower;
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

  [[nodiscard]] static bool is_end(double t) { return t == 0 || t == 1; }
  // Whether C_i(t) and C_j(s) are one point: both at ends of Bezier pieces, or the same cut of the same piece.
  [[nodiscard]] bool is_same_end(std::uint32_t i, double t, std::uint32_t j, double s) const {
    const bool is_one = is_self_ && a_.bezier_of(i) == b_.bezier_of(j);
    if (t == s && (is_one || is_same_piece(i, j))) return true;
    if (!is_end(t) || !is_end(s)) return false;
    const std::uint32_t bezier_a = a_.bezier_of(i), bezier_b = b_.bezier_of(j);
    if (a_.rounding(bezier_a) == 0 && b_.rounding(bezier_b) == 0) return true;  // as their doubles are
    const auto p = a_.exact_bezier(bezier_a).control_points(), q = b_.exact_bezier(bezier_b).control_points();
    return (t == 0 ? p.front() : p.back()) == (s == 0 ? q.front() : q.back());
  }
  // Whether segments are of Bezier pieces with the same numbers, of different drawings or at different places of one.
  [[nodiscard]] bool is_same_piece(std::uint32_t i, std::uint32_t j) const {
    const std::uint32_t bezier_a = a_.bezier_of(i), bezier_b = b_.bezier_of(j);
    if (is_self_ && bezier_a == bezier_b) return false;
    const auto& p = a_.bezier(bezier_a);
    const auto& q = b_.bezier(bezier_b);
    if (!(p.control_points() == q.control_points()) || p.weights() != q.weights()) return false;
    if (a_.rounding(bezier_a) == 0 && b_.rounding(bezier_b) == 0) return true;
    const auto exact_p = a_.exact_bezier(bezier_a), exact_q = b_.exact_bezier(bezier_b);
    return exact_p.control_points() == exact_q.control_points() && exact_p.weights() == exact_q.weights();
  }

  // A root whose range reaches over an end of its piece may be on the next one, or none.
  void leave_open_what_is_at_ends() {
    for (const Numbered_point& o : undecided_) {
      if (!open_.empty() && open_.back() == o.beziers) continue;
      if (!does_run_ahead(o)) open_.push_back(o.beziers);
    }
    for (const internal::Newton_box& root : roots_)
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
    std::vector<internal::Newton_box>& roots = roots_;
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
    for (const Numbered_point& end : ends_) {
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
    std::vector<Numbered_point> open = undecided_;
    for (const internal::Newton_box& root : roots_)
      if (!root.is_inside())
        open.push_back(
            {{root.bezier_a, root.bezier_b}, {within(root.a), within(root.b), Intersection_kind::UNDECIDED}});
    internal::add_clusters(std::move(open), found_.points);
  }
  [[nodiscard]] static Bracket within(const Bracket& t) {
    return {std::clamp(t.lower, 0.0, 1.0), std::clamp(t.upper, 0.0, 1.0)};
  }

  const Curves &a_, &b_;
  Curve_joints joints_a_, joints_b_;
  bool is_self_ = false;
  int looks_ = 0;  // how often parts were enlarged
  std::vector<internal::Newton_box> roots_;
  std::vector<Numbered_point> undecided_;  // between these parameters may be common points that doubles do not tell
  double error_ = 0;                       // of the two segments that are looked at
  int budget_ = 0;
  std::vector<Numbered_point> ends_;  // that are common
  std::vector<Pair> open_;            // sorted, once it is complete
  Numbered_intersections found_;
};

}  // namespace CGAL::Bounding_arcs

#endif
