// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// All arcs of a part that a disc touches within rounding, and the one disc that touches them all.
//
// Where many discs are nearly equal, any three arcs have one, which may miss the others by a multiple of the rounding.
// They are one vertex: the arcs near a first disc are collected, a disc is fitted to what is nearest of them, and arcs
// that it misses are left out until it touches all the rest.

#ifndef BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_TOUCH_FINDER_H
#define BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_TOUCH_FINDER_H

#include "../query/Closest_search.h"
#include "Axis_parts.h"
#include "fitted_disc.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// A disc with the arcs that it touches, positions in the part, rising.
struct Touched_disc {
  Fitted_disc disc;
  std::vector<std::uint32_t> arcs;
  std::vector<Boundary_place> feet;
};

class Touch_finder {
 public:
  Touch_finder(const Axis_parts& parts, std::uint32_t part) : parts_(parts), boundary_(parts.boundary()), part_(part) {}

  /// \param near a disc that touches three arcs, as far as is known of them
  /// \return nothing where it touches no more than three, or none touches them
  [[nodiscard]] std::optional<Touched_disc> find(const Fitted_disc& near) const {
    constexpr double CLOSE = 0x1p-32;  // of the size: what three close feet may make of rounding
    constexpr int MOST_ROUNDS = 8;
    std::vector<Touch> touches = touches_of(near, CLOSE * boundary_.size());
    Fitted_disc disc = near;
    for (int round = 0; round < MOST_ROUNDS && touches.size() > 3; ++round) {
      std::vector<Xy<double>> points;
      for (const Touch& t : touches) points.push_back(t.point);
      disc = fitted(disc, points, 0);
      const double gap = most_gap(disc, points);
      const double room = 4 * boundary_.resolution();
      if (gap <= room) return touched(disc, room);
      const auto misses = [&](const Touch& t) {
        return std::fabs(euclidean_norm(t.point - disc.center) - disc.radius) > (std::max)(room, gap / 2);
      };
      touches.erase(std::remove_if(touches.begin(), touches.end(), misses), touches.end());
    }
    return std::nullopt;
  }

 private:
  struct Touch {
    std::uint32_t position;
    Boundary_place place;
    Xy<double> point;
    double gap;
  };

  // Once more with the disc as it is now, whose feet are not quite the same.
  [[nodiscard]] std::optional<Touched_disc> touched(const Fitted_disc& disc, double room) const {
    Closest_search search(boundary_.curves(), disc.center, disc.radius - 2 * room);
    search.search();
    if (search.result()) return std::nullopt;
    std::vector<Touch> touches = touches_of(disc, 2 * room);
    if (touches.size() < 4) return std::nullopt;
    Touched_disc result{disc, {}, {}};
    for (const Touch& t : touches) result.arcs.push_back(t.position), result.feet.push_back(t.place);
    return result;
  }

  // The places next to the disc, one of each arc that is no farther away, by the positions of arcs.
  [[nodiscard]] std::vector<Touch> touches_of(const Fitted_disc& disc, double room) const {
    std::vector<Touch> all;
    const double most = (disc.radius + room) * (disc.radius + room);
    const auto is_near = [&](const Box_tree::Node& node, std::size_t k) {
      return squared_distance(disc.center, node, k) <= most;
    };
    for_each_item(boundary_.curves().boxes(), is_near, [&](const Box_tree::Node& node, std::size_t k) {
      look_at(node.child[k], disc, room, all);
      return true;
    });
    std::sort(all.begin(), all.end(), [](const Touch& a, const Touch& b) {
      return a.position != b.position ? a.position < b.position : a.gap < b.gap;
    });
    const auto is_same = [](const Touch& a, const Touch& b) { return a.position == b.position; };
    all.erase(std::unique(all.begin(), all.end(), is_same), all.end());
    return all;
  }
  void look_at(std::uint32_t segment, const Fitted_disc& disc, double room, std::vector<Touch>& all) const {
    if (distance_bounds(disc.center, boundary_.curves().region(segment)).lower > disc.radius + room) return;
    for (const std::uint32_t e : boundary_.sides(segment).of) {
      if (e == Axis_boundary::NONE) continue;
      look_at_element(e, disc, room, all);
      if (boundary_.element(e).is_corner) continue;  // a point
      for (const std::uint32_t corner : {boundary_.before(e), boundary_.after(e)})
        if (boundary_.element(corner).is_corner) look_at_element(corner, disc, room, all);
    }
  }
  void look_at_element(std::uint32_t e, const Fitted_disc& disc, double room, std::vector<Touch>& all) const {
    const Axis_parts::Others ranges{parts_, part_, Axis_parts::NONE};
    ranges.for_each(e, [&](double u0, double u1) {
      const std::optional<Boundary_place> p = foot(e, u0, u1, disc, room);
      if (!p) return;
      const Boundary_jet jet = boundary_(*p);
      const Xy<double> way = disc.center - jet.point;
      const double gap = std::fabs(euclidean_norm(way) - disc.radius);
      // touched from inside
      if (gap > room || !(dot(way, jet.normal()) > 0)) return;
      const std::uint32_t arc = parts_.arc_of(part_, Axis_parts::NONE, *p);
      if (arc != Axis_parts::NONE) all.push_back({parts_.arcs[arc].position, *p, jet.point, gap});
    });
  }
  [[nodiscard]] std::optional<Boundary_place> foot(std::uint32_t e, double u0, double u1, const Fitted_disc& disc,
                                                   double room) const {
    const Boundary_element& element = boundary_.element(e);
    const Segment_hierarchy& curves = boundary_.curves();
    if (element.is_corner)
      return Boundary_place{e, std::clamp(boundary_.angle_of(e, disc.center - element.point), u0, u1)};
    const double t0 = element.is_reversed ? -u1 : u0, t1 = element.is_reversed ? -u0 : u1;
    if (!(t0 < t1)) return Boundary_place{e, u0};
    const Spiral_piece_2 all = curves.piece(element.segment);
    const auto sample = [&](double t) {
      return t == all.first.t ? all.first : (t == all.last.t ? all.last : curves.sample(element.segment, t));
    };
    const Spiral_piece_2 piece{element.segment, sample(t0), sample(t1)};
    Closest_search search(curves, disc.center, disc.radius + 2 * room);
    search.look_at(piece, curves.region(piece));
    const auto found = search.result();
    if (!found) return std::nullopt;
    return boundary_.place(e, std::clamp(found->place.t, t0, t1));
  }

  const Axis_parts& parts_;
  const Axis_boundary& boundary_;
  std::uint32_t part_;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
