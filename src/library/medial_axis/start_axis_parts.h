// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The parts to begin with, one a region: rings are cut at their leaves, and holes are linked with what surrounds them
// by a maximal disc each.  The disc that touches a hole where it is farthest to the right touches a ring that is so
// farther to the right; others are taken only if theirs is, too, so that links make trees.

#ifndef BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_START_AXIS_PARTS_H
#define BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_START_AXIS_PARTS_H

#include <CGAL/Bounding_arcs_2/medial_axis/medial_axis.h>
#include "Axis_leaves.h"
#include "Axis_parts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// Calls work(i) for i = 0, ..., count - 1.
/// \param at_once how many follow each other in one thread
template <class Work> void for_each_in_turn(Index_loop loop, std::size_t at_once, std::size_t count, const Work& work) {
  loop((count + at_once - 1) / at_once, [&](std::size_t k) {
    for (std::size_t i = k * at_once; i < (std::min)((k + 1) * at_once, count); ++i) work(i);
  });
}

class Axis_start {
 public:
  Axis_start(Axis_parts& parts, Index_loop loop)
      : parts_(parts), boundary_(parts.boundary()), starts_(boundary_.rings().size()) {
    const auto count = static_cast<std::uint32_t>(starts_.size());
    for_each_in_turn(loop, RANGE_SIZE, count, [&](std::size_t r) {
      starts_[r].found = Leaf_finder(boundary_).leaves(static_cast<std::uint32_t>(r));
      starts_[r].most = farthest(boundary_.rings()[r]);
    });
    find_links(loop);
    for (std::uint32_t r = 0; r < count; ++r) add_ring(r);
    add_leaves();
    for (const std::uint32_t r : unlinked_)
      if (!starts_[r].has_shared_leaf) unresolved_.push_back(boundary_(rightmost(boundary_.rings()[r])).point);
    for (std::uint32_t i = 0; i < parts_.arcs.size(); ++i) parts_.add_fragments(i);
    for (const Link& l : links_) join(l);
    collect_parts();
  }
  /// By how much joints were rounded off, and rings are no circles that count as such.
  [[nodiscard]] double moved() const {
    double most = 0;
    for (const Ring_start& start : starts_) most = (std::max)(most, start.found.moved);
    return most;
  }
  /// Points of holes that have no place, and of rings without a leaf.
  [[nodiscard]] const std::vector<Xy<double>>& unresolved() const { return unresolved_; }

 private:
  static constexpr std::uint32_t NONE = Axis_parts::NONE;
  struct Ring_start {
    Ring_leaves found;
    double most = 0;            // x
    std::uint32_t only = NONE;  // the arc of a ring without leaves
    bool is_linked = false, has_shared_leaf = false;
    Boundary_place first_link{};  // where such a ring begins and ends
  };
  struct Link {
    Boundary_place own, other;
    Touching_disc disc;
  };
  // What follows an arc: a disc, none in rings without, and an arc.
  struct Next {
    std::uint32_t node = NONE, arc = NONE;
  };

  std::uint32_t add_arc(const Boundary_place& from, const Boundary_place& to) {
    parts_.arcs.push_back({from, to});
    next_.emplace_back();
    return static_cast<std::uint32_t>(parts_.arcs.size() - 1);
  }
  std::uint32_t add_node(const Axis_node& node) {
    parts_.nodes.push_back(node);
    return static_cast<std::uint32_t>(parts_.nodes.size() - 1);
  }

  void add_ring(std::uint32_t r) {
    Ring_start& start = starts_[r];
    const std::vector<Axis_leaf>& leaves = start.found.leaves;
    const std::size_t n = leaves.size();
    if (n == 0) {
      const Boundary_ring& ring = boundary_.rings()[r];
      const Boundary_place at =
          start.is_linked ? start.first_link : Boundary_place{ring.begin, boundary_.element(ring.begin).first};
      const Boundary_place from = parts_.start_behind(at), to = parts_.end_before(at);
      start.only = add_arc(from, to);
      parts_.arcs.back().is_ring = from.element == to.element && from.u == to.u;
    }
    const auto first = static_cast<std::uint32_t>(parts_.arcs.size());
    for (std::size_t i = 0; i < n; ++i) {
      const Axis_leaf &leaf = leaves[i], &next = leaves[(i + 1) % n];
      const std::uint32_t arc = add_arc(parts_.start_behind(leaf.last), parts_.end_before(next.first));
      touched_.push_back({next, arc, i + 1 < n ? arc + 1 : first});
    }
  }

  // A disc that touches an arc in a leaf, between two arcs of a ring.
  struct Touched_arc {
    Axis_leaf leaf;
    std::uint32_t before, behind;
  };
  // Discs of leaves are nodes. One that touches several arcs, as those of one circle, is one node: counterclockwise
  // about it, a part has what is behind one of these, and what is before the next one.
  void add_leaves() {
    std::sort(touched_.begin(), touched_.end(), [](const Touched_arc& a, const Touched_arc& b) {
      return a.leaf.disc.center.x != b.leaf.disc.center.x ? a.leaf.disc.center.x < b.leaf.disc.center.x
                                                          : a.before < b.before;
    });
    std::vector<bool> is_done(touched_.size(), false);
    for (std::size_t i = 0; i < touched_.size(); ++i) {
      if (is_done[i]) continue;
      std::vector<std::size_t> same{i};
      for (std::size_t k = i + 1;
           k < touched_.size() && is_near(touched_[k].leaf.disc.center.x, touched_[i].leaf.disc.center.x); ++k)
        if (!is_done[k] && are_same(touched_[i].leaf.disc, touched_[k].leaf.disc)) same.push_back(k), is_done[k] = true;
      add_leaf(same);
    }
  }
  [[nodiscard]] bool is_near(double x, double y) const {
    constexpr double NEAR = 0x1p-40;  // of the size
    return std::fabs(x - y) <= NEAR * boundary_.size();
  }
  [[nodiscard]] bool are_same(const Touching_disc& a, const Touching_disc& b) const {
    return a.radius > 0 && b.radius > 0 && is_near(a.radius, b.radius) && is_near(a.center.x, b.center.x) &&
           is_near(a.center.y, b.center.y);
  }
  void add_leaf(std::vector<std::size_t>& same) {
    const Axis_leaf& first = touched_[same.front()].leaf;
    const auto angle = [&](std::size_t i) {
      const Xy<double> way = boundary_(touched_[i].leaf.first).point - first.disc.center;
      return std::atan2(way.y, way.x);
    };
    if (same.size() > 1)
      std::sort(same.begin(), same.end(), [&](std::size_t a, std::size_t b) { return angle(a) < angle(b); });
    Axis_node node{same.size() > 1 ? Axis_node_kind::BRANCH : Axis_node_kind::LEAF, first.disc, {}};
    for (const std::size_t i : same)
      node.touches.push_back(touched_[i].leaf.first), node.touches.push_back(touched_[i].leaf.last);
    const std::uint32_t number = add_node(node);
    for (const std::size_t i : same) {
      const std::uint32_t ring = boundary_.element(touched_[i].leaf.first.element).ring;
      const std::uint32_t of_first = boundary_.element(first.first.element).ring;
      if (ring != of_first) starts_[ring].has_shared_leaf = starts_[of_first].has_shared_leaf = true;
    }
    for (std::size_t k = 0; k < same.size(); ++k)
      next_[touched_[same[(k + 1) % same.size()]].before] = {number, touched_[same[k]].behind};
  }

  // The links of all holes, of which none depends on another one.
  void find_links(Index_loop loop) {
    std::vector<std::optional<Link>> links(starts_.size());
    for_each_in_turn(loop, RANGE_SIZE, links.size(), [&](std::size_t r) {
      if (!boundary_.rings()[r].is_outer) links[r] = link(static_cast<std::uint32_t>(r));
    });
    for (std::uint32_t r = 0; r < links.size(); ++r) {
      if (boundary_.rings()[r].is_outer) continue;
      if (!links[r]) {
        unlinked_.push_back(r);
        continue;
      }
      for (const Boundary_place& place : {links[r]->own, links[r]->other}) {
        Ring_start& start = starts_[boundary_.element(place.element).ring];
        if (!start.is_linked) start.is_linked = true, start.first_link = place;
      }
      links_.push_back(*links[r]);
    }
  }
  // A disc that touches a hole and a ring that is farther to the right; where discs are special, as at the extreme
  // point of a hole with symmetry, feet would be where arcs begin and end at once.
  [[nodiscard]] std::optional<Link> link(std::uint32_t r) const {
    const Boundary_place extreme = rightmost(boundary_.rings()[r]);
    std::uint32_t e = extreme.element;
    constexpr int MOST_ELEMENTS = 4;
    for (int k = 0; k < MOST_ELEMENTS; ++k, e = boundary_.before(e))
      for (const double share : {0.63, 0.29}) {
        const Boundary_element& element = boundary_.element(e);
        if (auto found = link_at(r, {e, element.first + share * (element.last - element.first)})) return found;
      }
    return link_at(r, extreme);
  }
  // Whether a leaf touches an arc that has a place.
  [[nodiscard]] bool is_on_leaf(const Boundary_place& p) const {
    const std::uint32_t ring = boundary_.element(p.element).ring;
    const auto& leaves = starts_[ring].found.leaves;
    return std::any_of(leaves.begin(), leaves.end(), [&](const Axis_leaf& leaf) {
      const Boundary_place from = parts_.start_behind(leaf.first), to = parts_.start_behind(leaf.last);
      const bool is_point = from.element == to.element && from.u == to.u;
      return !is_point && parts_.is_on({from, parts_.end_before(leaf.last)}, p);
    });
  }
  [[nodiscard]] std::optional<Link> link_at(std::uint32_t r, const Boundary_place& p) const {
    const auto others = [&](std::uint32_t e, const auto& visit) {
      if (e != p.element && e != boundary_.back_of(p.element))
        visit(boundary_.element(e).first, boundary_.element(e).last);
    };
    Disc_search search(boundary_, others, boundary_(p), boundary_.largest_radius());
    search.search();
    if (!search.is_found()) return std::nullopt;
    const Boundary_place q = search.place();
    if (!(starts_[boundary_.element(q.element).ring].most > starts_[r].most)) return std::nullopt;
    if (is_on_leaf(p) || is_on_leaf(q)) return std::nullopt;
    return Link{p, q, search.disc()};
  }

  // The arc that ends at a place, and the one that goes on there: one and the same where a ring begins.
  struct Opened {
    std::uint32_t before, behind;
  };
  Opened opened(const Boundary_place& at) {
    Ring_start& start = starts_[boundary_.element(at.element).ring];
    if (start.only != NONE && next_[start.only].arc == NONE) return {start.only, start.only};
    const std::uint32_t arc = parts_.arc_of(NONE, NONE, at);
    if (arc == NONE) return {NONE, NONE};
    const std::uint32_t behind = parts_.split(arc, at);
    next_.push_back(next_[arc]);
    return {arc, behind};
  }
  void join(const Link& link) {
    const Opened own = opened(link.own), other = opened(link.other);
    if (own.before == NONE || other.before == NONE) {
      unresolved_.push_back(link.disc.center);
      return;
    }
    const std::uint32_t node = add_node({Axis_node_kind::CUT, link.disc, {link.own, link.other}});
    next_[own.before] = {node, other.behind};
    next_[other.before] = {node, own.behind};
  }

  void collect_parts() {
    std::vector<bool> is_known(parts_.arcs.size());
    for (std::uint32_t first = 0; first < is_known.size(); ++first) {
      Axis_part part;
      for (std::uint32_t arc = first; arc != NONE && !is_known[arc]; arc = next_[arc].arc) {
        is_known[arc] = true;
        part.arcs.push_back(arc);
        if (next_[arc].node != NONE) part.nodes.push_back(next_[arc].node);
      }
      if (part.arcs.empty()) continue;
      if (part.nodes.empty()) close_circle(part.arcs.front());
      parts_.parts.push_back(part);
      parts_.number(static_cast<std::uint32_t>(parts_.parts.size() - 1));
    }
  }
  // A ring that has one curvature and nothing within it.
  void close_circle(std::uint32_t arc) {
    const Ring_leaves& ring = starts_[boundary_.element(parts_.arcs[arc].from.element).ring].found;
    if (!ring.is_circle) {
      unresolved_.push_back(boundary_(parts_.arcs[arc].from).point);
      return;
    }
    add_node({Axis_node_kind::LEAF, ring.circle.disc, {ring.circle.first, ring.circle.last}});
  }

  // Where a hole is farthest to the right, on the side that looks there.
  [[nodiscard]] Boundary_place rightmost(const Boundary_ring& ring) const {
    Boundary_place best{ring.begin, boundary_.element(ring.begin).first};
    double most = -std::numeric_limits<double>::infinity();
    for (std::uint32_t i = ring.begin; i < ring.end; ++i) {
      const Boundary_element& e = boundary_.element(i);
      const Boundary_jet jet = boundary_({i, e.first});
      if (jet.point.x < most || (jet.point.x == most && !e.is_corner)) continue;
      if (!e.is_corner && !(jet.normal().x > 0)) continue;
      most = jet.point.x;
      const double u = e.is_corner ? std::clamp(boundary_.angle_of(i, {1, 0}), e.first, e.last) : e.first;
      best = {i, u};
    }
    return best;
  }
  [[nodiscard]] double farthest(const Boundary_ring& ring) const {
    double most = -std::numeric_limits<double>::infinity();
    for (std::uint32_t i = ring.begin; i < ring.end; ++i)
      most = (std::max)(most, boundary_({i, boundary_.element(i).first}).point.x);
    return most;
  }

  Axis_parts& parts_;
  const Axis_boundary& boundary_;
  std::vector<Ring_start> starts_;
  std::vector<Link> links_;
  std::vector<Next> next_;
  std::vector<Touched_arc> touched_;
  std::vector<std::uint32_t> unlinked_;  // holes that no disc links
  std::vector<Xy<double>> unresolved_;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
