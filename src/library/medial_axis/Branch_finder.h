// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A vertex of the axis of a part with three discs or more: a maximal disc that touches three of its arcs, or more.
//
// Along one arc, what its maximal discs touch besides goes from the arc before to the arc after: bisection finds where
// that jumps, and Newton's method for center, radius and three feet ends it as soon as it gets to an empty disc.

#ifndef BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_BRANCH_FINDER_H
#define BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_BRANCH_FINDER_H

#include "../query/Closest_search.h"
#include "Axis_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// A disc with the arcs that it touches.
struct Axis_branch {
  std::vector<std::uint32_t> arcs;  ///< positions in the part, rising
  std::vector<Boundary_place> feet;
  Touching_disc disc;
};

class Branch_finder {
 public:
  /// \param is_joining whether all arcs that a disc touches within rounding are looked for
  Branch_finder(const Axis_parts& parts, std::uint32_t part, bool is_joining)
      : parts_(parts), boundary_(parts.boundary()), part_(part), is_joining_(is_joining),
        most_(boundary_.largest_radius()) {}

  /// \pre the part has three arcs at least
  [[nodiscard]] std::optional<Axis_branch> find() {
    const Axis_part& part = parts_.parts[part_];
    const auto n = static_cast<std::uint32_t>(part.arcs.size());
    own_ = longest(part);
    if (auto branch = find_along()) return branch;
    // an arc may leave its neighbour within rounding only: others tell the discs apart that touch both
    constexpr std::uint32_t FEW = 4;
    const std::uint32_t first = own_;
    for (std::uint32_t i = 1; i <= (std::min)(FEW, n / 2); ++i)
      for (const std::uint32_t own : {(first + i) % n, (first + n - i) % n}) {
        own_ = own;
        if (auto branch = find_along()) return branch;
      }
    return std::nullopt;
  }

 private:
  // What the disc that ends the interval touches.
  struct Side {
    std::uint32_t position;
    Boundary_place foot;
    Touching_disc disc;
  };

  [[nodiscard]] std::optional<Axis_branch> find_along() const {
    const Axis_part& part = parts_.parts[part_];
    const auto n = static_cast<std::uint32_t>(part.arcs.size());
    const Boundary_arc& arc = parts_.arcs[part.arcs[own_]];
    const std::uint32_t after = (own_ + 1) % n, before = (own_ + n - 1) % n;
    double low = 0, high = parts_.length(arc);
    Side from{before, parts_.arcs[part.arcs[before]].to, parts_.nodes[part.nodes[before]].disc},
        to{after, parts_.arcs[part.arcs[after]].from, parts_.nodes[part.nodes[own_]].disc};
    constexpr int MOST_STEPS = 120;  // elements, then bits of a parameter
    for (int step = 0; step < MOST_STEPS; ++step) {
      const double middle = low + (high - low) / 2;
      const Boundary_place p = place(arc, middle);
      if (const auto branch = newton(p, from, to)) return branch;
      if (!(low < middle && middle < high)) break;
      const Axis_parts::Others others{parts_, part_, part.arcs[own_]};
      Axis_parts::Search search(boundary_, others, boundary_(p), most_);
      search.start_from(from.foot);
      search.start_from(to.foot);
      parts_.run(search, others);
      const std::uint32_t found =
          search.is_found() ? parts_.arc_of(part_, part.arcs[own_], search.place()) : Axis_parts::NONE;
      if (found == Axis_parts::NONE) return std::nullopt;
      const Side side{parts_.arcs[found].position, search.place(), search.disc()};
      // any of the jumps would do; one between both halves of the part leaves less to be cut again
      if ((side.position + n - own_) % n <= n / 2) high = middle, to = side;
      else low = middle, from = side;
    }
    return collapsed(place(arc, low), from, to);
  }

  // The arc that runs through most elements, or of those with one the longest.
  [[nodiscard]] std::uint32_t longest(const Axis_part& part) const {
    std::uint32_t best = 0, most = 0;
    double extent = 0;
    for (std::uint32_t i = 0; i < part.arcs.size(); ++i) {
      const Boundary_arc& arc = parts_.arcs[part.arcs[i]];
      const std::uint32_t count = parts_.length(arc);
      if (count < most) continue;
      const double length = count > 1 ? 0 : euclidean_norm(boundary_(arc.to).point - boundary_(arc.from).point);
      if (count > most || length > extent) best = i, most = count, extent = length;
    }
    return best;
  }
  // Elements of an arc are numbered through; a fraction is one of the element's parameters.
  [[nodiscard]] Boundary_place place(const Boundary_arc& arc, double x) const {
    const std::uint32_t count = parts_.length(arc), k = (std::min)(static_cast<std::uint32_t>(x), count - 1);
    const Boundary_ring& ring = boundary_.rings()[boundary_.element(arc.from.element).ring];
    const std::uint32_t e = ring.begin + (arc.from.element - ring.begin + k) % (ring.end - ring.begin);
    const Boundary_element& element = boundary_.element(e);
    const double u0 = k == 0 ? arc.from.u : element.first, u1 = k + 1 == count ? arc.to.u : element.last;
    return {e, (std::min)(u0 + (x - k) * (u1 - u0), u1)};
  }

  struct Foot_of_disc {
    std::uint32_t position;
    const Boundary_arc* arc;
    Boundary_place place;
  };
  using Feet = std::array<Foot_of_disc, 3>;
  [[nodiscard]] Feet feet_of(const Boundary_place& p, const Side& from, const Side& to) const {
    const auto foot = [&](std::uint32_t position, const Boundary_place& place) {
      return Foot_of_disc{position, &parts_.arcs[parts_.parts[part_].arcs[position]], place};
    };
    return {foot(own_, p), foot(to.position, to.foot), foot(from.position, from.foot)};
  }
  // One of Newton's steps for the point of an arc next to a center; it may go on to a neighbouring element.
  // \return whether it is a nearest point
  bool step_to(const Xy<double>& center, Foot_of_disc& foot) const {
    const Boundary_element* e = &boundary_.element(foot.place.element);
    const Boundary_jet jet = boundary_(foot.place);
    const Xy<double> way = center - jet.point;
    double u = 0;
    if (e->is_corner) {
      u = boundary_.angle_of(foot.place.element, way);
    } else {
      const double rate = jet.speed - jet.turn * dot(way, jet.normal());
      if (!(rate > 0)) return false;
      u = foot.place.u + dot(way, jet.tangent) / rate;
    }
    const bool is_behind = u > e->last && foot.place.u == e->last;
    if (is_behind || (u < e->first && foot.place.u == e->first)) {
      const std::uint32_t next = is_behind ? boundary_.after(foot.place.element) : boundary_.before(foot.place.element);
      const Boundary_place p{next, is_behind ? boundary_.element(next).first : boundary_.element(next).last};
      if (parts_.is_on(*foot.arc, p)) foot.place = p;
      return true;
    }
    foot.place.u = std::clamp(u, e->first, e->last);
    return true;
  }

  [[nodiscard]] std::optional<Axis_branch> newton(const Boundary_place& p, const Side& from, const Side& to) const {
    Feet feet = feet_of(p, from, to);
    Touching_disc disc{0.5 * (from.disc.center + to.disc.center), 0.5 * (from.disc.radius + to.disc.radius)};
    double last = HUGE_VAL;
    constexpr int MOST_STEPS = 24;
    for (int step = 0; step < MOST_STEPS; ++step) {
      Xy<double> direction[3], points[3], ways[3];
      double distance[3];
      for (std::size_t i = 0; i < 3; ++i) {
        if (!step_to(disc.center, feet[i]) || !step_to(disc.center, feet[i])) return std::nullopt;
        const Boundary_jet jet = boundary_(feet[i].place);
        const Xy<double> way = disc.center - jet.point;
        const double d = euclidean_norm(way), side = dot(way, jet.normal());
        if (!(side > 0)) return std::nullopt;
        direction[i] = (1 / d) * way;
        distance[i] = d;
        points[i] = jet.point, ways[i] = way;
      }
      // distance + direction.change is the new radius, of all three
      const Xy<double> a = direction[1] - direction[0], b = direction[2] - direction[0];
      const double determinant = cross(a, b);
      // distance[0] - distance[i]; the center of discs through a gap hangs on all its bits
      const auto farther = [&](std::size_t i) {
        constexpr double CLOSE = 0x1p-10;  // feet, of the distance
        const Xy<double> gap = points[i] - points[0];
        return euclidean_norm(gap) < CLOSE * distance[0] ? dot(gap, ways[0] + ways[i]) / (distance[0] + distance[i])
                                                         : distance[0] - distance[i];
      };
      const double f = farther(1), g = farther(2);
      if (!(std::fabs(determinant) > 0)) return std::nullopt;
      const Xy<double> change{(f * b.y - g * a.y) / determinant, (g * a.x - f * b.x) / determinant};
      const double size = euclidean_norm(change);
      if (!(size <= most_)) return std::nullopt;
      const bool is_settled =
          size <= 4 * HALF_ULP * boundary_.size() || (size >= last && last <= boundary_.resolution());
      disc = {disc.center + change, distance[0] + dot(direction[0], change)};
      last = size;
      if (is_settled || (step + 1 == MOST_STEPS && size <= boundary_.resolution())) return checked(feet, disc);
    }
    return std::nullopt;
  }

  // Whether the disc is one of the part's: its feet on the arcs, and nothing in it.
  [[nodiscard]] std::optional<Axis_branch> checked(Feet& feet, const Touching_disc& disc) const {
    const auto& [center, radius] = disc;
    const double room = 8 * boundary_.resolution() + 0x1p-44 * radius;
    if (!(radius > room)) return std::nullopt;  // a point where curves meet, which several arcs come to
    for (Foot_of_disc& foot : feet) {
      step_to(center, foot);
      if (!parts_.is_on(*foot.arc, foot.place)) return std::nullopt;
      const Boundary_jet jet = boundary_(foot.place);
      if (!(disc.gap(jet.point) <= room) || is_slanting(jet, disc, room)) return std::nullopt;
    }
    if (is_outside_of_tip(feet, radius)) return std::nullopt;
    Closest_search search(boundary_.curves(), center, radius - room);
    search.search();
    if (search.result()) return std::nullopt;
    if (auto joined = joined_at(disc)) return joined;
    return in_order(feet, disc);
  }

  // Whether a disc that is at the end of an element is beyond it: behind a convex corner, or round a reflex one.
  [[nodiscard]] static bool is_slanting(const Boundary_jet& jet, const Touching_disc& disc, double room) {
    constexpr double SLANTING = 0x1p-10;
    const double beside = std::fabs(dot(disc.center - jet.point, jet.tangent));
    return jet.speed > 0 && beside > SLANTING * disc.radius + 4 * std::sqrt(room * disc.radius);
  }

  // Whether a disc touches both sides of a sharp tip there, from outside: within, it would be smaller than its distance
  // from the tip. Where sides have one tangent, rounding does not tell which of them is before the other. A disc that
  // touches two corners is at the mouth of what is between them, where it may be large.
  [[nodiscard]] bool is_outside_of_tip(const Feet& feet, double radius) const {
    const Axis_part& part = parts_.parts[part_];
    for (const Foot_of_disc& before : feet)
      for (const Foot_of_disc& behind : feet) {
        if (behind.position != (before.position + 1) % part.arcs.size()) continue;
        const Axis_node& node = parts_.nodes[part.nodes[before.position]];
        if (node.kind != Axis_node_kind::LEAF || node.disc.radius != 0) continue;
        if (dot(boundary_(before.arc->to).tangent, boundary_(behind.arc->from).tangent) > 0) continue;
        constexpr double NEAR = 0.25;
        const auto is_near = [&](const Foot_of_disc& foot) {
          return euclidean_norm(boundary_(foot.place).point - node.disc.center) < NEAR * radius;
        };
        if (is_near(before) && is_near(behind) && !are_apart(before.place, behind.place)) return true;
      }
    return false;
  }

  // Whether two places are corners that are told apart.
  [[nodiscard]] bool are_apart(const Boundary_place& p, const Boundary_place& q) const {
    const Boundary_element &a = boundary_.element(p.element), &b = boundary_.element(q.element);
    return a.is_corner && b.is_corner && euclidean_norm(a.point - b.point) > boundary_.joint_size();
  }

  // Nothing is left between two discs: one of them touches all three places within rounding, or a branch is missing.
  [[nodiscard]] std::optional<Axis_branch> collapsed(const Boundary_place& p, const Side& from, const Side& to) const {
    constexpr double ROOM = 64;  // times the resolution
    for (const Side* side : {&to, &from})
      if (auto joined = joined_at(side->disc)) return joined;
    for (const Side* side : {&to, &from}) {
      const Side& other = side == &to ? from : to;
      if (side->disc.gap(boundary_(other.foot).point) <= ROOM * boundary_.resolution())
        return in_order(feet_of(p, from, to), side->disc);
    }
    return std::nullopt;
  }
  [[nodiscard]] static Axis_branch in_order(Feet feet, const Touching_disc& disc) {
    std::sort(feet.begin(), feet.end(),
              [](const Foot_of_disc& a, const Foot_of_disc& b) { return a.position < b.position; });
    Axis_branch branch{{}, {}, disc};
    for (const Foot_of_disc& foot : feet) branch.arcs.push_back(foot.position), branch.feet.push_back(foot.place);
    return branch;
  }

  // All arcs of a part that a disc touches within rounding, and the one disc that touches them all.
  //
  // Where many discs are nearly equal, any three arcs have one, which may miss the others by a multiple of the
  // rounding. They are one vertex: the arcs near a first disc are collected, a disc is fitted to what is nearest of
  // them, and arcs that it misses are left out until it touches all the rest.

  // \param near a disc that touches three arcs, as far as is known of them
  // \return nothing where it touches no more than three, or none touches them
  [[nodiscard]] std::optional<Axis_branch> joined_at(const Touching_disc& near) const {
    if (!is_joining_) return std::nullopt;
    constexpr double CLOSE = 0x1p-32;  // of the size: what three close feet may make of rounding
    constexpr int MOST_ROUNDS = 8;
    std::vector<Touch> touches = touches_of(near, CLOSE * boundary_.size());
    Touching_disc disc = near;
    for (int round = 0; round < MOST_ROUNDS && touches.size() > 3; ++round) {
      std::vector<Xy<double>> points;
      for (const Touch& t : touches) points.push_back(t.point);
      disc = fitted(disc, points, 0);
      const double gap = most_gap(disc, points);
      const double room = 4 * boundary_.resolution();
      if (gap <= room) return touched(disc, room);
      const auto misses = [&](const Touch& t) { return disc.gap(t.point) > (std::max)(room, gap / 2); };
      touches.erase(std::remove_if(touches.begin(), touches.end(), misses), touches.end());
    }
    return std::nullopt;
  }
  struct Touch {
    std::uint32_t position;
    Boundary_place place;
    Xy<double> point;
    double gap;
  };

  // Once more with the disc as it is now, whose feet are not quite the same.
  [[nodiscard]] std::optional<Axis_branch> touched(const Touching_disc& disc, double room) const {
    Closest_search search(boundary_.curves(), disc.center, disc.radius - 2 * room);
    search.search();
    if (search.result()) return std::nullopt;
    std::vector<Touch> touches = touches_of(disc, 2 * room);
    if (touches.size() < 4) return std::nullopt;
    Axis_branch result{{}, {}, disc};
    for (const Touch& t : touches) result.arcs.push_back(t.position), result.feet.push_back(t.place);
    return result;
  }

  // The places next to the disc, one of each arc that is no farther away, by the positions of arcs.
  [[nodiscard]] std::vector<Touch> touches_of(const Touching_disc& disc, double room) const {
    std::vector<Touch> all;
    const double most = (disc.radius + room) * (disc.radius + room);
    const auto is_near = [&](const Box_tree::Node& node, std::size_t k) {
      return squared_distance(disc.center, node, k) <= most;
    };
    for_each_item(boundary_.curves().boxes(), is_near, [&](const Box_tree::Node& node, std::size_t k) {
      if (distance_bounds(disc.center, boundary_.curves().region(node.child[k])).lower <= disc.radius + room)
        boundary_.for_each_element_of(node.child[k], [&](std::uint32_t e) { look_at(e, disc, room, all); });
      return true;
    });
    std::sort(all.begin(), all.end(), [](const Touch& a, const Touch& b) {
      return a.position != b.position ? a.position < b.position : a.gap < b.gap;
    });
    const auto is_same = [](const Touch& a, const Touch& b) { return a.position == b.position; };
    all.erase(std::unique(all.begin(), all.end(), is_same), all.end());
    return all;
  }
  void look_at(std::uint32_t e, const Touching_disc& disc, double room, std::vector<Touch>& all) const {
    const Axis_parts::Others ranges{parts_, part_, Axis_parts::NONE};
    ranges(e, [&](double u0, double u1) {
      const std::optional<Boundary_place> p = foot(e, u0, u1, disc, room);
      if (!p) return;
      const Boundary_jet jet = boundary_(*p);
      const double gap = disc.gap(jet.point);
      // touched from inside
      if (gap > room || !(dot(disc.center - jet.point, jet.normal()) > 0) || is_slanting(jet, disc, room)) return;
      const std::uint32_t arc = parts_.arc_of(part_, Axis_parts::NONE, *p);
      if (arc != Axis_parts::NONE) all.push_back({parts_.arcs[arc].position, *p, jet.point, gap});
    });
  }
  [[nodiscard]] std::optional<Boundary_place> foot(std::uint32_t e, double u0, double u1, const Touching_disc& disc,
                                                   double room) const {
    const Boundary_element& element = boundary_.element(e);
    const Segment_hierarchy& curves = boundary_.curves();
    if (element.is_corner)
      return Boundary_place{e, std::clamp(boundary_.angle_of(e, disc.center - element.point), u0, u1)};
    if (!(u0 < u1)) return Boundary_place{e, u0};
    const Spiral_piece_2 piece = boundary_.piece(e, u0, u1);
    Closest_search search(curves, disc.center, disc.radius + 2 * room);
    search.look_at(piece, curves.region(piece));
    const auto found = search.result();
    if (!found) return std::nullopt;
    return boundary_.place(e, std::clamp(found->place.t, piece.first.t, piece.last.t));
  }

  const Axis_parts& parts_;
  const Axis_boundary& boundary_;
  std::uint32_t part_, own_ = 0;
  bool is_joining_;
  double most_;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
