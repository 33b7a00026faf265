// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the axis of a ring ends: at convex corners, and at maxima of curvature whose osculating disc is empty.
//
// Curvature is monotone along a spiral segment, so its maxima are among the segments' ends.  Values that are the same
// within what they may be wrong by are one: a circular arc of largest curvature is one leaf, whose disc touches all of
// it.

#ifndef CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_INTERNAL_AXIS_LEAVES_H
#define CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_INTERNAL_AXIS_LEAVES_H

#include <CGAL/Bounding_arcs_2/medial_axis/internal/Axis_boundary.h>
#include <CGAL/Bounding_arcs_2/medial_axis/internal/Disc_search.h>
#include <CGAL/Bounding_arcs_2/medial_axis/internal/make_axis_boundary.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// A disc that touches the boundary from one place on up to another one.
struct Axis_leaf {
  Boundary_place first, last;
  Xy<double> center;
  double radius;
};

struct Ring_leaves {
  std::vector<Axis_leaf> leaves;
  bool is_circle = false;  ///< the ring has one curvature, that of its disc
  Axis_leaf circle{};
};

class Leaf_finder {
 public:
  explicit Leaf_finder(const Axis_boundary& boundary) : boundary_(boundary) {}

  [[nodiscard]] Ring_leaves leaves(std::uint32_t ring) {
    const std::vector<End> ends = ends_of(boundary_.rings()[ring]);
    const std::size_t n = ends.size();
    Ring_leaves result;
    std::size_t start = 0;  // of a group of ends with one value
    while (start < n && are_same(ends[(start + n - 1) % n], ends[start])) ++start;
    if (start == n) {
      result.is_circle = ends.front().value > 0 && std::isfinite(ends.front().value);
      if (result.is_circle) result.circle = osculating(ends.front(), ends.back());
      return result;
    }
    for (std::size_t i = start; i < start + n;) {
      std::size_t last = i;
      while (last + 1 < start + n && are_same(ends[last % n], ends[(last + 1) % n])) ++last;
      const End &from = ends[i % n], &to = ends[last % n];
      const bool is_maximum =
          from.value > from.error && is_less(ends[(i + n - 1) % n], from) && is_less(ends[(last + 1) % n], to);
      if (is_maximum) add(from, to, result.leaves);
      i = last + 1;
    }
    return result;
  }

 private:
  struct End {
    Boundary_place place;
    double value, error;
    bool is_corner = false;
    std::uint32_t next = 0;  // behind a convex corner
  };
  [[nodiscard]] static bool are_same(const End& a, const End& b) {
    if (a.is_corner || b.is_corner) return false;
    constexpr double SAME = 0x1p-32;  // of curvature; rounded control points of a spline make joints differ by less
    if (a.value == b.value) return true;
    return std::isfinite(a.value) && std::isfinite(b.value) &&
           std::fabs(a.value - b.value) <=
               a.error + b.error + SAME * (std::max)(std::fabs(a.value), std::fabs(b.value));
  }

  [[nodiscard]] static bool is_less(const End& a, const End& b) {
    return a.value < b.value || (!a.is_corner && b.is_corner);
  }

  [[nodiscard]] End end_at(const Boundary_place& p) const {
    const auto curvature = boundary_.curvature(p);
    return {p, curvature.value, curvature.error};
  }
  // Curvature from one end of an element to the next: infinite at corners.
  [[nodiscard]] std::vector<End> ends_of(const Boundary_ring& ring) const {
    constexpr double INFINITE = std::numeric_limits<double>::infinity();
    std::vector<End> ends;
    for (std::uint32_t i = ring.begin; i < ring.end; ++i) {
      const Boundary_element& e = boundary_.element(i);
      const std::uint32_t next = boundary_.after(i);
      if (e.is_corner) {
        ends.push_back({{i, e.first}, -INFINITE, 0});
        continue;
      }
      for (const double u : {e.first, e.last}) ends.push_back(end_at({i, u}));
      if (!boundary_.element(next).is_corner && is_convex_corner(i, next))
        ends.push_back({{i, e.last}, INFINITE, 0, true, next});
    }
    return ends;
  }
  [[nodiscard]] bool is_convex_corner(std::uint32_t i, std::uint32_t next) const {
    const Boundary_element &e = boundary_.element(i), &f = boundary_.element(next);
    const Directed_piece p{boundary_.curves().piece(e.segment), e.is_reversed},
        q{boundary_.curves().piece(f.segment), f.is_reversed};
    return Axis_boundary_maker::turn_of(p, q) > Axis_boundary_maker::LEAST_TURN;
  }

  [[nodiscard]] Axis_leaf osculating(const End& from, const End& to) const {
    const Boundary_jet jet = boundary_(from.place);
    const double r = std::isfinite(from.value) ? 1 / from.value : 0;
    return {from.place, to.place, jet.point + r * jet.normal(), r};
  }

  void add(const End& from, const End& to, std::vector<Axis_leaf>& leaves) {
    if (from.is_corner) {
      const Boundary_place behind{from.next, boundary_.element(from.next).first};
      leaves.push_back({from.place, behind, boundary_(from.place).point, 0});
      return;
    }
    const Axis_leaf leaf = osculating(from, to);
    if (leaf.radius == 0 || (leaf.radius < boundary_.largest_radius() && is_empty(leaf))) leaves.push_back(leaf);
  }

  // What falls off from the largest curvature stays outside of the disc (Kneser), however many elements it runs
  // through; anything else might be in it.
  struct All_but {
    const Axis_boundary& boundary;
    std::uint32_t first, last;  // elements, in order around the ring
    template <class Visit> void for_each(std::uint32_t e, const Visit& visit) const {
      const Boundary_element& element = boundary.element(e);
      const auto &ring = boundary.rings()[element.ring], &own = boundary.rings()[boundary.element(first).ring];
      // the other side of the curve is where this one is
      if (ring.curve == own.curve && ring.begin != own.begin) return;
      if (!is_between(e) && !is_between(boundary.back_of(e))) visit(element.first, element.last);
    }
    [[nodiscard]] bool is_between(std::uint32_t e) const {
      if (e == Axis_boundary::NONE || boundary.element(e).ring != boundary.element(first).ring) return false;
      return first <= last ? first <= e && e <= last : e >= first || e <= last;
    }
  };
  // The elements beside the leaf's, and more of them for as long as curvature falls without a corner.
  [[nodiscard]] All_but others_of(const Axis_leaf& leaf) const {
    const Boundary_element &e = boundary_.element(leaf.first.element), &f = boundary_.element(leaf.last.element);
    All_but others{boundary_, leaf.first.u == e.first ? boundary_.before(leaf.first.element) : leaf.first.element,
                   leaf.last.u == f.last ? boundary_.after(leaf.last.element) : leaf.last.element};
    while (boundary_.after(others.last) != others.first && falls_on<true>(others.last))
      others.last = boundary_.after(others.last);
    while (boundary_.before(others.first) != others.last && falls_on<false>(others.first))
      others.first = boundary_.before(others.first);
    return others;
  }
  // Whether curvature falls along an element, at its far end and along the next one.
  template <bool IS_FORWARD> [[nodiscard]] bool falls_on(std::uint32_t e) const {
    const std::uint32_t next = IS_FORWARD ? boundary_.after(e) : boundary_.before(e);
    if (boundary_.element(e).is_corner || boundary_.element(next).is_corner) return false;
    if (IS_FORWARD ? is_convex_corner(e, next) : is_convex_corner(next, e)) return false;
    const auto end = [&](std::uint32_t i, bool is_far) {
      const Boundary_element& element = boundary_.element(i);
      return end_at({i, is_far == IS_FORWARD ? element.last : element.first});
    };
    const End near = end(e, false), joint = end(e, true), behind = end(next, false), far = end(next, true);
    const auto is_below = [](const End& a, const End& b) { return a.value < b.value && !are_same(a, b); };
    return is_below(joint, near) && (behind.value <= joint.value || are_same(behind, joint)) && is_below(far, behind);
  }
  [[nodiscard]] bool is_empty(const Axis_leaf& leaf) const {
    const All_but others = others_of(leaf);
    const Boundary_jet jet = boundary_(leaf.first);
    Disc_search<All_but> search(boundary_, others, jet.point, jet.normal(), leaf.radius);
    search.search();
    return !search.is_found();
  }

  const Axis_boundary& boundary_;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
