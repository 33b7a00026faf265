// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The axis of a part with two discs: one edge, whose discs touch both arcs, the first one from its start to its end and
// the second one the other way round.
//
// Where an element of either arc ends, a search has the disc that touches there.  Between two of these discs both feet
// are on one element each, and the discs are the zeros of
//   F(u, v) = (q - p).(Tq - Tp),   dF/du = (1 - Tp.Tq)(p' - r p's turn),   dF/dv the same with q,
// both positive as no maximal disc is curved less than the boundary where it touches: what brackets the root is known.

#ifndef BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_AXIS_PATH_H
#define BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_AXIS_PATH_H

#include "Axis_parts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// A disc of an edge with its feet on both arcs.
struct Axis_sample {
  Boundary_place a, b;
  Xy<double> center;
  double radius;
};

class Axis_path {
 public:
  Axis_path(const Axis_parts& parts, std::uint32_t part, double eps)
      : parts_(parts), boundary_(parts.boundary()), part_(part), eps_(eps), most_(boundary_.largest_radius()),
        arc_a_(parts.parts[part].arcs[0]), arc_b_(parts.parts[part].arcs[1]) {
    const auto pieces = [&](std::uint32_t arc) {
      std::vector<Piece> result;
      parts.for_each_element(parts.arcs[arc], [&](std::uint32_t e, double u0, double u1) {
        result.push_back({e, u0, u1});
      });
      return result;
    };
    a_ = pieces(arc_a_);
    b_ = pieces(arc_b_);
  }

  /// Returns the samples from the disc before the first arc to the one behind it.
  [[nodiscard]] std::vector<Axis_sample> samples() {
    std::size_t i = 0, j = b_.size() - 1;
    State last = end({a_[0].element, a_[0].u0}, {b_[j].element, b_[j].u1}, 1);
    push(last);
    const auto go_to = [&](const State& next) {
      refine(last, next, 0);
      push(next);
      last = next;
    };
    // Which arc's element ends first: that whose disc touches the other arc where both are now. Rounding may tell that
    // of both, or of neither; then the one whose disc is nearer to what is there.
    while (i + 1 < a_.size() || j > 0) {
      double gap_a = HUGE_VAL, gap_b = HUGE_VAL;  // below 0 where nothing is in doubt
      Boundary_place q, p;
      double radius_b = 0;
      if (i + 1 < a_.size()) {
        if (partner_of_ != i)
          partner_ = across({a_[i].element, a_[i].u1}, arc_a_, arc_b_, last.sample.b, last.sample.radius),
          partner_of_ = i;
        const std::size_t k = parts_.steps(parts_.arcs[arc_b_], partner_.place);
        q = on(b_, j, partner_, k);
        gap_a = k >= j ? -1 : partner_.disc.gap(boundary_(q).point);
      }
      if (j > 0 && gap_a >= 0) {
        const Partner partner = across({b_[j].element, b_[j].u0}, arc_b_, arc_a_, last.sample.a, last.sample.radius);
        radius_b = partner.disc.radius;
        const std::size_t k = parts_.steps(parts_.arcs[arc_a_], partner.place);
        p = on(a_, i, partner, k);
        gap_b = k == i ? -1 : partner.disc.gap(boundary_(p).point);
      }
      // discs at ends of elements that turn to the left by little are in what is beyond, by as much on either side
      const double most = ROUNDING * boundary_.resolution() + 2 * boundary_.largest_rounded_turn() * last.sample.radius;
      if ((std::min)(gap_a, gap_b) > most) has_failed_ = true;
      if (gap_a <= gap_b) {
        go_to(facing(true, {a_[i].element, a_[i].u1}, partner_.disc.radius, q, b_[j].u0, b_[j].u1));
        ++i;
        last = state({a_[i].element, a_[i].u0}, last.sample.b);
      } else {
        go_to(facing(false, {b_[j].element, b_[j].u0}, radius_b, p, a_[i].u0, a_[i].u1));
        --j;
        last = state(last.sample.a, {b_[j].element, b_[j].u1});
      }
    }
    const State stop = end({a_[i].element, a_[i].u1}, {b_[0].element, b_[0].u0}, 0);
    refine(last, stop, 0);
    push(stop);
    put_first_in_order(1);
    std::reverse(samples_.begin(), samples_.end());
    put_first_in_order(-1);
    std::reverse(samples_.begin(), samples_.end());
    return std::move(samples_);
  }
  /// Whether some discs could not be found.
  [[nodiscard]] bool has_failed() const { return has_failed_; }

 private:
  static constexpr double ROUNDING = 64;  // times the resolution
  struct Piece {
    std::uint32_t element;
    double u0, u1;
  };
  struct State {
    Axis_sample sample;
    double rate_a = 0, rate_b = 0;  // how fast dF/du, dF/dv grow
    double speed_a = 0, speed_b = 0;
    Xy<double> way;    // of the axis
    double slope = 0;  // of the radius along it
  };

  // Where the first disc touches an arc of its own circle along its length, discs of cuts on that are the same but for
  // rounding, and so are their feet: one that is behind its place keeps that of the disc before.
  // \param forward 1 from the first disc on, -1 where samples are the other way round
  void put_first_in_order(double forward) {
    for (std::size_t k = 1; k + 1 < samples_.size(); ++k) {
      Axis_sample& s = samples_[k];
      const double off = euclidean_norm(s.center - samples_[0].center) + std::fabs(s.radius - samples_[0].radius);
      if (off > ROUNDING * boundary_.resolution()) return;
      if (forward * way(arc_a_, samples_[k - 1].a, s.a) < 0) s.a = samples_[k - 1].a;
      if (forward * way(arc_b_, samples_[k - 1].b, s.b) > 0) s.b = samples_[k - 1].b;
    }
  }
  // Above 0 where the second place comes behind the first one on an arc.
  [[nodiscard]] double way(std::uint32_t arc, const Boundary_place& p, const Boundary_place& q) const {
    const std::size_t of_p = parts_.steps(parts_.arcs[arc], p), of_q = parts_.steps(parts_.arcs[arc], q);
    return of_p == of_q ? q.u - p.u : (of_p < of_q ? 1 : -1);
  }
  void push(const State& s) {
    constexpr std::size_t MANY = 64;  // of one part, and 64 times what a parabola as large as all would need
    if (samples_.size() > MANY * (1 + static_cast<std::size_t>(std::sqrt(boundary_.size() / eps_)))) has_failed_ = true;
    else samples_.push_back(s.sample);
  }

  /// What the disc that touches at a place touches on the other arc.
  struct Partner {
    Boundary_place place;
    Touching_disc disc;
  };
  // A joint without a corner has two tangents: that of a disc of some radius is between them.
  [[nodiscard]] Boundary_jet with_tangent_of_disc(const Boundary_place& p, double radius) const {
    Boundary_jet jet = boundary_(p);
    const double turn = boundary_.turn_to_disc(p, radius);
    if (turn != 0) jet.tangent = jet.tangent + turn * perp(jet.tangent);
    return jet;
  }
  // \param radius that it may have: where two tangents differ, the disc found with that tells a better one
  Partner across(const Boundary_place& p, std::uint32_t own, std::uint32_t other, const Boundary_place& near,
                 double radius) {
    const Axis_parts::Others others{parts_, part_, own};
    const auto found = [&](double of_disc) -> std::optional<Partner> {
      Axis_parts::Search search(boundary_, others, with_tangent_of_disc(p, of_disc), most_);
      search.start_from(near);
      parts_.run(search, others);
      return search.is_found() ? std::optional(Partner{search.place(), search.disc()}) : std::nullopt;
    };
    std::optional<Partner> partner = found(radius);
    if (partner && has_two_normals(p, partner->disc.radius)) partner = found(partner->disc.radius);
    if (partner) return *partner;
    // beside the feet of an end's disc, on a line that leaves a corner, rounding may leave nothing in any disc
    for (const bool is_start : {false, true}) {
      const Touching_disc& disc = parts_.nodes[parts_.parts[part_].nodes[is_start ? 1 : 0]].disc;
      if (disc.gap(boundary_(p).point) > ROUNDING * boundary_.resolution()) continue;
      const Boundary_arc& arc = parts_.arcs[other];
      return {is_start == (other == arc_a_) ? arc.from : arc.to, disc};
    }
    has_failed_ = true;
    return {parts_.arcs[other].from, {boundary_(p).point, 0}};
  }
  // A partner, or the end of a piece that it is beyond. The disc touches that as well, where it is so by rounding
  // alone. A ring's end is its start.
  [[nodiscard]] Boundary_place on(const std::vector<Piece>& pieces, std::size_t wanted, const Partner& partner,
                                  std::size_t of) const {
    const Piece& piece = pieces[wanted];
    if (of == wanted) return {piece.element, std::clamp(partner.place.u, piece.u0, piece.u1)};
    const Boundary_place first{piece.element, piece.u0}, last{piece.element, piece.u1};
    const auto gap = [&](const Boundary_place& p) { return partner.disc.gap(boundary_(p).point); };
    const bool is_ring = boundary_({pieces.front().element, pieces.front().u0}).point ==
                         boundary_({pieces.back().element, pieces.back().u1}).point;
    return (is_ring ? gap(first) <= gap(last) : of < wanted) ? first : last;
  }

  State state(const Boundary_place& a, const Boundary_place& b) const {
    return state(a, boundary_(a), b, boundary_(b));
  }
  State state(const Boundary_place& a, const Boundary_jet& p, const Boundary_place& b, const Boundary_jet& q) const {
    const Touching_disc disc = disc_of(p, q);
    return with({a, b, disc.center, disc.radius}, p, q);
  }
  static State with(const Axis_sample& sample, const Boundary_jet& p, const Boundary_jet& q) {
    State s;
    s.sample = sample;
    s.rate_a = p.speed - p.turn * sample.radius;
    s.rate_b = q.speed - q.turn * sample.radius;
    s.speed_a = p.speed > 0 ? p.speed : sample.radius;
    s.speed_b = q.speed > 0 ? q.speed : sample.radius;
    const Xy<double> n = p.normal(), m = q.normal();
    const Xy<double> way = dot(n, m) > 0 ? n + m : perp(m - n);
    s.way = (1 / euclidean_norm(way)) * way;
    s.slope = dot(s.way, n);
    return s;
  }
  // At the part's own discs, whose radius is known better than two feet next to each other tell it.
  State end(const Boundary_place& a, const Boundary_place& b, std::size_t node) const {
    const Touching_disc& disc = parts_.nodes[parts_.parts[part_].nodes[node]].disc;
    return with({a, b, disc.center, disc.radius}, boundary_(a), boundary_(b));
  }

  // How far the edge may be from the segment between two of its points, of which its directions there tell: a quarter
  // of the length times the sine for a parabola, more than there is where it bends both ways.
  [[nodiscard]] bool is_straight(const State& s, const State& t) const {
    const Xy<double> chord = t.sample.center - s.sample.center;
    const double length = euclidean_norm(chord), rise = t.sample.radius - s.sample.radius;
    if (length + std::fabs(rise) <= 0.5 * eps_) return true;
    constexpr double SHARE = 0.9;  // of the tolerance
    const double most = 4 * SHARE * eps_;
    for (const State* end : {&s, &t}) {
      const double along = dot(end->way, chord), beside = std::fabs(cross(end->way, chord));
      if (beside + std::fabs((along < 0 ? -end->slope : end->slope) * length - rise) > most) return false;
      if (length > most && std::fabs(along) < 0.5 * length) return false;
    }
    return true;
  }
  void refine(const State& s, const State& t, int depth) {
    constexpr int MOST_DEPTH = 24;
    if (has_failed_ || depth >= MOST_DEPTH || is_straight(s, t)) return;
    const double on_a = std::fabs(t.sample.a.u - s.sample.a.u) * (std::max)(s.speed_a, t.speed_a),
                 on_b = std::fabs(t.sample.b.u - s.sample.b.u) * (std::max)(s.speed_b, t.speed_b);
    const bool is_half_of_a = halves_a(s.sample, on_a, on_b);
    State middle = between(is_half_of_a, s, t);
    // the other foot may be beyond a joint that is rounded off
    if (boundary_.turn_of_joint(is_half_of_a ? middle.sample.b : middle.sample.a) != 0)
      middle = between(!is_half_of_a, s, t);
    if (!(middle.sample.radius > 0)) {
      if (!are_at_one_point(s.sample, t.sample)) has_failed_ = true;
      return;
    }
    refine(s, middle, depth + 1);
    push(middle);
    refine(middle, t, depth + 1);
  }
  // Discs that touch both sides of a tip in its corner, as far as rounding tells, with their centers on one line.
  [[nodiscard]] bool are_at_one_point(const Axis_sample& s, const Axis_sample& t) const {
    const Xy<double> at = boundary_(s.a).point;
    const auto is_there = [&](const Boundary_place& p) {
      return euclidean_norm(boundary_(p).point - at) <= ROUNDING * boundary_.resolution();
    };
    const Axis_sample &large = s.radius < t.radius ? t : s, &small = s.radius < t.radius ? s : t;
    const double beside = std::fabs(cross(large.center - at, small.center - at));
    return is_there(s.b) && is_there(t.a) && is_there(t.b) && beside <= 0.5 * eps_ * large.radius;
  }
  // Between a curve and its own end the foot on the curve tells the disc. From the other one Newton's method might come
  // to where both tangents are the same.
  [[nodiscard]] bool halves_a(const Axis_sample& at, double on_a, double on_b) const {
    const std::uint32_t a = at.a.element, b = at.b.element;
    if (boundary_.after(a) != b && boundary_.after(b) != a) return on_a >= on_b;
    if (boundary_.element(b).is_corner) return on_a > 0;
    return boundary_.element(a).is_corner ? !(on_b > 0) : on_a >= on_b;
  }
  // The disc half way along one of the arcs, by Newton's method on the other one.
  [[nodiscard]] State between(bool is_half_of_a, const State& s, const State& t) const {
    const Boundary_place &from = is_half_of_a ? s.sample.a : s.sample.b, &to = is_half_of_a ? t.sample.a : t.sample.b;
    const Boundary_place &start = is_half_of_a ? s.sample.b : s.sample.a,
                         &stop = is_half_of_a ? t.sample.b : t.sample.a;
    const Boundary_place p{from.element, 0.5 * (from.u + to.u)};
    const double low = (std::min)(start.u, stop.u), high = (std::max)(start.u, stop.u);
    const auto rate = [&](const State& x) {
      const double r = is_half_of_a ? x.rate_a / x.rate_b : x.rate_b / x.rate_a;
      return std::isfinite(r) ? -r : 0;
    };
    const double middle = 0.5 * (start.u + stop.u), guess = middle + (to.u - from.u) / 8 * (rate(s) - rate(t));
    const Boundary_place q{start.element, low < guess && guess < high ? guess : middle};
    return facing(is_half_of_a, p, s.sample.radius, q, low, high);
  }
  // The disc that touches at p, on the first arc if is_of_a, and in a range of the other one.
  // \param radius about that which it has
  [[nodiscard]] State facing(bool is_of_a, const Boundary_place& p, double radius, Boundary_place q, double low,
                             double high) const {
    const Boundary_jet fixed = with_tangent_of_disc(p, radius);
    Boundary_jet moving = boundary_(q);
    constexpr int MOST_STEPS = 60;
    constexpr double SETTLED = 0x1p-26;  // of the element, and of an angle: the next step would be of a last bit
    const Boundary_element& element = boundary_.element(q.element);
    const double settled = SETTLED * (element.last - element.first);
    for (int step = 0; step < MOST_STEPS && low < high; ++step) {
      const Xy<double> way = moving.point - fixed.point;
      const double turn_to = 1 - dot(moving.tangent, fixed.tangent), f = dot(way, moving.tangent - fixed.tangent);
      if (f > 0) high = q.u;
      else low = q.u;
      const double slope = moving.speed * turn_to + moving.turn * dot(way, moving.normal());
      double next = q.u - f / slope;
      const bool is_newton = slope > 0 && next >= low && next <= high;
      if (!is_newton) next = low + (high - low) / 2;
      const double change = std::fabs(next - q.u);
      q.u = next;
      if (change == 0) break;
      moving = boundary_(q);
      if (is_newton && change <= settled && std::fabs(moving.turn) * change <= 2 * SETTLED) break;
    }
    State s = is_of_a ? state(p, fixed, q, moving) : state(q, moving, p, fixed);
    const bool is_at_end = !(low < high) || q.u == low || q.u == high;
    touch(s.sample, fixed, moving, is_at_end);
    return s;
  }

  // Whether a joint has two normals that rounding tells apart in the center.
  [[nodiscard]] bool has_two_normals(const Boundary_place& p, double radius) const {
    return std::fabs(boundary_.turn_of_joint(p)) * radius > boundary_.resolution();
  }

  // Where the foot is at the end of an element, which may turn there by less than a corner does; and where normals turn
  // so fast, in a sharp tip, that their rounding tells in the center.
  void touch(Axis_sample& sample, const Boundary_jet& fixed, const Boundary_jet& moving, bool is_at_end) const {
    const Xy<double> way = moving.point - fixed.point;
    const double height = dot(way, fixed.normal());
    if (!(height > boundary_.resolution())) return;
    const Xy<double> gap = way + sample.radius * (moving.normal() - fixed.normal());
    const double of_height = sample.radius / height * HALF_ULP * boundary_.size();
    if (!is_at_end && !(euclidean_norm(gap) > 4 * boundary_.resolution() + 8 * of_height)) return;
    sample.radius = dot(way, way) / (2 * height);
    sample.center = fixed.point + sample.radius * fixed.normal();
  }

  const Axis_parts& parts_;
  const Axis_boundary& boundary_;
  std::uint32_t part_;
  double eps_, most_;
  std::uint32_t arc_a_, arc_b_;
  std::vector<Piece> a_, b_;
  std::vector<Axis_sample> samples_;
  Partner partner_{};
  std::size_t partner_of_ = static_cast<std::size_t>(-1);
  bool has_failed_ = false;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
