// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The parts to begin with, one a region: rings are cut at their leaves, and holes are linked with what surrounds them
// by a maximal disc each.  The disc that touches a hole where it is farthest to the right touches what is farther to
// the right; near there one is taken that touches a part other than the hole's own, so that links make no cycle.

#ifndef CGAL_BOUNDING_ARCS_2_INTERNAL_MEDIAL_AXIS_START_AXIS_PARTS_H
#define CGAL_BOUNDING_ARCS_2_INTERNAL_MEDIAL_AXIS_START_AXIS_PARTS_H

#include <CGAL/Bounding_arcs_2/internal/medial_axis/Axis_leaves.h>
#include <CGAL/Bounding_arcs_2/internal/medial_axis/Axis_parts.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

class Axis_start {
 public:
  explicit Axis_start(Axis_parts& parts) : parts_(parts), boundary_(parts.boundary()) {
    const auto count = static_cast<std::uint32_t>(boundary_.rings().size());
    Leaf_finder finder(boundary_);
    for (std::uint32_t r = 0; r < count; ++r) add_ring(r, finder.leaves(r));
    parts_.add_all_fragments();
    for (std::uint32_t r = 0; r < count; ++r)
      if (!boundary_.rings()[r].is_outer) link(r);
    for (const Axis_part& part : parts_.parts)
      if (part.nodes.empty() && !part.arcs.empty()) close_circle(part.arcs.front());
  }
  /// Where it is false, a hole has no place, or a ring no leaf.
  [[nodiscard]] bool is_complete() const { return is_complete_; }

 private:
  void add_ring(std::uint32_t r, const Ring_leaves& found) {
    const Boundary_ring& ring = boundary_.rings()[r];
    const std::size_t n = found.leaves.size();
    Axis_part part;
    circles_.push_back(found);
    if (n == 0) {
      const Boundary_place start{ring.begin, boundary_.element(ring.begin).first};
      part.arcs.push_back(static_cast<std::uint32_t>(parts_.arcs.size()));
      parts_.arcs.push_back({start, parts_.end_before(start)});
    }
    for (std::size_t i = 0; i < n; ++i) {
      const Axis_leaf &leaf = found.leaves[i], &next = found.leaves[(i + 1) % n];
      part.arcs.push_back(static_cast<std::uint32_t>(parts_.arcs.size()));
      parts_.arcs.push_back({parts_.start_behind(leaf.last), parts_.end_before(next.first)});
      part.nodes.push_back(static_cast<std::uint32_t>(parts_.nodes.size()));
      parts_.nodes.push_back({Axis_node_kind::LEAF, next.centre, next.radius, {next.first, next.last}});
    }
    parts_.parts.push_back(part);
  }

  // A ring that has one curvature and nothing within it.
  void close_circle(std::uint32_t arc) {
    const Ring_leaves& ring = circles_[boundary_.element(parts_.arcs[arc].from.element).ring];
    if (!ring.is_circle) {
      is_complete_ = false;
      return;
    }
    const Axis_leaf& disc = ring.circle;
    parts_.nodes.push_back({Axis_node_kind::LEAF, disc.centre, disc.radius, {disc.first, disc.last}});
  }

  // A disc that touches a hole and something else than its part; where discs are special, as at the extreme point of a
  // hole with symmetry, feet would be where arcs begin and end at once.
  void link(std::uint32_t r) {
    const Boundary_place extreme = rightmost(boundary_.rings()[r]);
    std::uint32_t e = extreme.element;
    constexpr int MOST_ELEMENTS = 4;
    for (int k = 0; k < MOST_ELEMENTS; ++k, e = boundary_.before(e))
      for (const double share : {0.63, 0.29}) {
        const Boundary_element& element = boundary_.element(e);
        if (link_at({e, element.first + share * (element.last - element.first)})) return;
      }
    if (!link_at(extreme)) is_complete_ = false;
  }
  struct Not_element {
    const Axis_boundary& boundary;
    std::uint32_t element;
    template <class Visit> void for_each(std::uint32_t e, const Visit& visit) const {
      const Boundary_element &other = boundary.element(e), &own = boundary.element(element);
      const bool is_other_side =
          other.ring != own.ring && boundary.rings()[other.ring].curve == boundary.rings()[own.ring].curve;
      if (e != element && !is_other_side) visit(other.first, other.last);
    }
  };
  bool link_at(const Boundary_place& p) {
    const Boundary_jet jet = boundary_(p);
    const Not_element others{boundary_, p.element};
    Disc_search<Not_element> search(boundary_, others, jet.point, jet.normal(), boundary_.largest_radius());
    search.search();
    if (!search.is_found()) return false;
    const std::uint32_t own = parts_.arc_of(Axis_parts::NONE, Axis_parts::NONE, p),
                        other = parts_.arc_of(Axis_parts::NONE, Axis_parts::NONE, search.place());
    if (own == Axis_parts::NONE || other == Axis_parts::NONE || parts_.arcs[own].part == parts_.arcs[other].part)
      return false;
    const auto node = static_cast<std::uint32_t>(parts_.nodes.size());
    parts_.nodes.push_back({Axis_node_kind::CUT, search.centre(), search.radius(), {p, search.place()}});
    Axis_part all = opened(other, search.place());
    const Axis_part hole = opened(own, p);
    all.nodes.push_back(node);
    all.arcs.insert(all.arcs.end(), hole.arcs.begin(), hole.arcs.end());
    all.nodes.insert(all.nodes.end(), hole.nodes.begin(), hole.nodes.end());
    all.nodes.push_back(node);
    const std::uint32_t part = parts_.arcs[other].part;
    parts_.parts[parts_.arcs[own].part] = {};
    parts_.parts[part] = all;
    parts_.number(part);
    return true;
  }
  // A part with one arc cut at a place, from what is behind that on.
  Axis_part opened(std::uint32_t arc, const Boundary_place& at) {
    const Axis_part& part = parts_.parts[parts_.arcs[arc].part];
    const std::size_t n = part.arcs.size(), i = parts_.arcs[arc].position;
    Axis_part result;
    result.arcs.push_back(parts_.split(arc, at));
    if (part.nodes.empty()) {  // a ring without leaves, which begins anywhere: its two ends are one arc
      result.arcs.front() = parts_.join(result.arcs.front(), arc);
      return result;
    }
    for (std::size_t k = 0; k < n; ++k) {
      result.nodes.push_back(part.nodes[(i + k) % n]);
      result.arcs.push_back(part.arcs[(i + k + 1) % n]);
    }
    return result;
  }

  [[nodiscard]] Boundary_place rightmost(const Boundary_ring& ring) const {
    Boundary_place best{ring.begin, boundary_.element(ring.begin).first};
    double most = boundary_(best).point.x;
    for (std::uint32_t i = ring.begin; i < ring.end; ++i) {
      const Boundary_element& e = boundary_.element(i);
      const double x = e.is_corner ? e.point.x : boundary_({i, e.first}).point.x;
      if (x < most || (x == most && !e.is_corner)) continue;
      most = x;
      // at a corner the normal to the right
      const Xy<double> n = perp(e.tangent);
      best = e.is_corner ? Boundary_place{i, std::clamp(std::atan2(n.y, n.x), e.first, e.last)}
                         : Boundary_place{i, e.first};
    }
    return best;
  }

  Axis_parts& parts_;
  const Axis_boundary& boundary_;
  std::vector<Ring_leaves> circles_;
  bool is_complete_ = true;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
