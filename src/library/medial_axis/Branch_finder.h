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

#include "Axis_parts.h"
#include "Touch_finder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

struct Axis_branch {
  std::vector<std::uint32_t> arcs;  ///< positions in the part, rising
  std::vector<Boundary_place> feet;
  Xy<double> center;
  double radius;
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
    const Boundary_arc& arc = parts_.arcs[part.arcs[own_]];
    const std::uint32_t after = (own_ + 1) % n, before = (own_ + n - 1) % n;
    double low = 0, high = parts_.length(arc);
    Side from{before, parts_.arcs[part.arcs[before]].to, parts_.nodes[part.nodes[before]]},
        to{after, parts_.arcs[part.arcs[after]].from, parts_.nodes[part.nodes[own_]]};
    constexpr int MOST_STEPS = 120;  // elements, then bits of a parameter
    for (int step = 0; step < MOST_STEPS; ++step) {
      const double middle = low + (high - low) / 2;
      const Boundary_place p = place(arc, middle);
      if (const auto branch = newton(p, from, to, 0.5)) return branch;
      if (!(low < middle && middle < high)) break;
      const Boundary_jet jet = boundary_(p);
      const Axis_parts::Others others{parts_, part_, part.arcs[own_]};
      Axis_parts::Search search(boundary_, others, jet.point, jet.normal(), most_);
      search.start_from(from.foot);
      search.start_from(to.foot);
      parts_.run(search, others);
      const std::uint32_t found =
          search.is_found() ? parts_.arc_of(part_, part.arcs[own_], search.place()) : Axis_parts::NONE;
      if (found == Axis_parts::NONE) return std::nullopt;
      const Side side{parts_.arcs[found].position, search.place(), search.center(), search.radius()};
      // any of the jumps would do; one between both halves of the part leaves less to be cut again
      if ((side.position + n - own_) % n <= n / 2) high = middle, to = side;
      else low = middle, from = side;
    }
    return collapsed(place(arc, low), from, to);
  }

 private:
  // What the disc that ends the interval touches.
  struct Side {
    std::uint32_t position;
    Boundary_place foot;
    Xy<double> center;
    double radius;
    Side(std::uint32_t i, const Boundary_place& p, const Axis_node& node)
        : position(i), foot(p), center(node.center), radius(node.radius) {}
    Side(std::uint32_t i, const Boundary_place& p, const Xy<double>& c, double r)
        : position(i), foot(p), center(c), radius(r) {}
  };

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
    const Boundary_arc* arc;
    Boundary_place place;
  };
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
    if (u > e->last && foot.place.u == e->last) {
      const std::uint32_t next = boundary_.after(foot.place.element);
      const Boundary_place p{next, boundary_.element(next).first};
      if (parts_.is_on(*foot.arc, p)) foot.place = p;
      return true;
    }
    if (u < e->first && foot.place.u == e->first) {
      const std::uint32_t next = boundary_.before(foot.place.element);
      const Boundary_place p{next, boundary_.element(next).last};
      if (parts_.is_on(*foot.arc, p)) foot.place = p;
      return true;
    }
    foot.place.u = std::clamp(u, e->first, e->last);
    return true;
  }

  [[nodiscard]] std::optional<Axis_branch> newton(const Boundary_place& p, const Side& from, const Side& to,
                                                  double share) const {
    const Axis_part& part = parts_.parts[part_];
    const auto arc = [&](std::uint32_t i) { return &parts_.arcs[part.arcs[i]]; };
    std::array<Foot_of_disc, 3> feet{
        Foot_of_disc{arc(own_), p}, {arc(to.position), to.foot}, {arc(from.position), from.foot}};
    Xy<double> center = share * from.center + (1 - share) * to.center;
    double radius = share * from.radius + (1 - share) * to.radius, last = HUGE_VAL;
    constexpr int MOST_STEPS = 24;
    for (int step = 0; step < MOST_STEPS; ++step) {
      Xy<double> direction[3], ways[3];
      double distance[3];
      for (std::size_t i = 0; i < 3; ++i) {
        if (!step_to(center, feet[i]) || !step_to(center, feet[i])) return std::nullopt;
        const Boundary_jet jet = boundary_(feet[i].place);
        const Xy<double> way = center - jet.point;
        const double d = euclidean_norm(way), side = dot(way, jet.normal());
        if (!(side > 0)) return std::nullopt;
        direction[i] = (1 / d) * way;
        distance[i] = d;
        ways[i] = way;
      }
      // distance + direction.change is the new radius, of all three
      const Xy<double> a = direction[1] - direction[0], b = direction[2] - direction[0];
      const double determinant = cross(a, b);
      // distance[0] - distance[i], as exact as the feet are close: the center of discs through a gap hangs on it
      const auto farther = [&](std::size_t i) {
        const Xy<double> gap = boundary_(feet[i].place).point - boundary_(feet[0].place).point;
        return dot(gap, ways[0] + ways[i]) / (distance[0] + distance[i]);
      };
      const double f = farther(1), g = farther(2);
      if (!(std::fabs(determinant) > 0)) return std::nullopt;
      const Xy<double> change{(f * b.y - g * a.y) / determinant, (g * a.x - f * b.x) / determinant};
      const double size = euclidean_norm(change);
      if (!(size <= most_)) return std::nullopt;
      const bool is_settled =
          size <= 4 * HALF_ULP * boundary_.size() || (size >= last && last <= boundary_.resolution());
      center = center + change;
      radius = distance[0] + dot(direction[0], change);
      last = size;
      if (is_settled || (step + 1 == MOST_STEPS && size <= boundary_.resolution()))
        return checked(feet, center, radius, from, to);
    }
    return std::nullopt;
  }

  // Whether the disc is one of the part's: its feet on the arcs, and nothing in it.
  [[nodiscard]] std::optional<Axis_branch> checked(std::array<Foot_of_disc, 3>& feet, const Xy<double>& center,
                                                   double radius, const Side& from, const Side& to) const {
    const double room = 8 * boundary_.resolution() + 0x1p-44 * radius;
    if (!(radius > room)) return std::nullopt;  // a point where curves meet, which several arcs come to
    for (Foot_of_disc& foot : feet) {
      step_to(center, foot);
      if (!parts_.is_on(*foot.arc, foot.place)) return std::nullopt;
      const Boundary_jet jet = boundary_(foot.place);
      const Xy<double> way = center - jet.point;
      if (!(std::fabs(euclidean_norm(way) - radius) <= room)) return std::nullopt;
      // the end of an arc, at a convex corner, from beyond
      constexpr double SLANTING = 0x1p-10;
      if (jet.speed > 0 && std::fabs(dot(way, jet.tangent)) > SLANTING * radius + 4 * std::sqrt(room * radius))
        return std::nullopt;
    }
    if (is_outside_of_tip(feet, {own_, to.position, from.position}, radius)) return std::nullopt;
    Closest_search search(boundary_.curves(), center, radius - room);
    search.search();
    if (search.result()) return std::nullopt;
    if (auto joined = joined_at(center, radius)) return joined;
    return in_order({own_, to.position, from.position}, {feet[0].place, feet[1].place, feet[2].place}, center, radius);
  }

  // Whether a disc touches both sides of a sharp tip there, from outside: within, it would be smaller than its distance
  // from the tip. Where sides have one tangent, rounding does not tell which of them is before the other. A disc that
  // touches two corners is at the mouth of what is between them, where it may be large.
  [[nodiscard]] bool is_outside_of_tip(const std::array<Foot_of_disc, 3>& feet,
                                       const std::array<std::uint32_t, 3>& positions, double radius) const {
    const Axis_part& part = parts_.parts[part_];
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        if (positions[k] != (positions[i] + 1) % part.arcs.size()) continue;
        const Axis_node& node = parts_.nodes[part.nodes[positions[i]]];
        if (node.kind != Axis_node_kind::LEAF || node.radius != 0) continue;
        if (dot(boundary_(feet[i].arc->to).tangent, boundary_(feet[k].arc->from).tangent) > 0) continue;
        constexpr double NEAR = 0.25;
        const auto is_near = [&](const Foot_of_disc& foot) {
          return euclidean_norm(boundary_(foot.place).point - node.center) < NEAR * radius;
        };
        if (is_near(feet[i]) && is_near(feet[k]) && !are_apart(feet[i].place, feet[k].place)) return true;
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
      if (auto joined = joined_at(side->center, side->radius)) return joined;
    for (const Side* side : {&to, &from}) {
      const Side& other = side == &to ? from : to;
      const double d = euclidean_norm(boundary_(other.foot).point - side->center);
      if (std::fabs(d - side->radius) <= ROOM * boundary_.resolution())
        return in_order({own_, to.position, from.position}, {p, to.foot, from.foot}, side->center, side->radius);
    }
    return std::nullopt;
  }
  // The vertex of more than three arcs about a disc.
  [[nodiscard]] std::optional<Axis_branch> joined_at(const Xy<double>& center, double radius) const {
    if (!is_joining_) return std::nullopt;
    auto found = Touch_finder(parts_, part_).find({center, radius});
    if (!found) return std::nullopt;
    return Axis_branch{std::move(found->arcs), std::move(found->feet), found->disc.center, found->disc.radius};
  }
  [[nodiscard]] static Axis_branch in_order(std::array<std::uint32_t, 3> arcs, std::array<Boundary_place, 3> feet,
                                            const Xy<double>& center, double radius) {
    for (const std::size_t i : {0U, 1U, 0U})
      if (arcs[i] > arcs[i + 1]) std::swap(arcs[i], arcs[i + 1]), std::swap(feet[i], feet[i + 1]);
    return {{arcs.begin(), arcs.end()}, {feet.begin(), feet.end()}, center, radius};
  }

  const Axis_parts& parts_;
  const Axis_boundary& boundary_;
  std::uint32_t part_, own_ = 0;
  bool is_joining_;
  double most_;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
