// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parts of a region between maximal discs: cycles of boundary arcs and of discs that link the end of one arc with the
// start of the next.
//
//        .-- arc --.        Cut along the chords of a maximal disc, a region falls into parts, and the axis of each
//        part
//     disc         disc     depends on its own arcs only (Choi, Choi, Moon 1997; Aichholzer and others 2009).  A part
//        '-- arc --'        without curvature maxima has an axis that ends in its discs: two discs, one edge; three,
//                           one vertex.

#ifndef BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_AXIS_PARTS_H
#define BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_AXIS_PARTS_H

#include "Axis_boundary.h"
#include "Disc_search.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// A part of a ring, from one place on to another one.
struct Boundary_arc {
  Boundary_place from, to;
  bool is_ring = false;  ///< from and to are one place, and all of the ring is between
  std::uint32_t part = 0;
  std::uint32_t position = 0;  ///< in the part's cycle
  /// Whether it begins and ends in one element with all others between.
  [[nodiscard]] bool is_around() const { return from.element == to.element && (is_ring || to.u < from.u); }
};

enum class Axis_node_kind : std::uint8_t { LEAF, BRANCH, CUT };
/// A maximal disc.
struct Axis_node {
  Axis_node_kind kind;
  Touching_disc disc;
  std::vector<Boundary_place> touches;
};

struct Axis_part {
  std::vector<std::uint32_t> arcs, nodes;  ///< disc i links arc i with arc i + 1
};

class Axis_parts {
 public:
  explicit Axis_parts(const Axis_boundary& boundary) : boundary_(boundary), first_(boundary.elements().size(), NONE) {}

  std::vector<Axis_node> nodes;
  std::vector<Boundary_arc> arcs;
  std::vector<Axis_part> parts;

  [[nodiscard]] const Axis_boundary& boundary() const { return boundary_; }

  /// How many elements an arc runs through.
  [[nodiscard]] std::uint32_t length(const Boundary_arc& arc) const {
    const Boundary_ring& ring = boundary_.rings()[boundary_.element(arc.from.element).ring];
    const std::uint32_t n = ring.end - ring.begin;
    if (arc.from.element == arc.to.element) return arc.is_around() ? n + 1 : 1;
    return (arc.to.element + n - arc.from.element) % n + 1;
  }
  /// Calls visit(element, u0, u1) along an arc.
  template <class Visit> void for_each_element(const Boundary_arc& arc, const Visit& visit) const {
    const std::uint32_t count = length(arc);
    std::uint32_t e = arc.from.element;
    for (std::uint32_t k = 0; k < count; ++k, e = boundary_.after(e)) {
      const Boundary_element& element = boundary_.element(e);
      visit(e, k == 0 ? arc.from.u : element.first, k + 1 == count ? arc.to.u : element.last);
    }
  }

  /// Makes arcs known to searches. To be called once for each arc that is new.
  void add_fragments(std::uint32_t arc) {
    for_each_element(arcs[arc], [&](std::uint32_t e, double u0, double u1) {
      fragments_.push_back({arc, first_[e], u0, u1});
      first_[e] = static_cast<std::uint32_t>(fragments_.size() - 1);
    });
  }
  /// Cuts an arc in two; neither begins or ends in an element that it has only an end of, unless that is all of it.
  /// \return the number of what is behind the cut; what is before it keeps its number
  std::uint32_t split(std::uint32_t arc, const Boundary_place& at) {
    const auto behind = static_cast<std::uint32_t>(arcs.size());
    arcs.push_back(arcs[arc]);
    const std::uint32_t before = steps(arcs[arc], at), count = length(arcs[arc]);
    const bool is_at_start = before > 0 && at.u == boundary_.element(at.element).first,
               is_at_end = !is_at_start && before + 1 < count && at.u == boundary_.element(at.element).last;
    std::uint32_t k = 0;
    for_each_element(arcs[arc], [&](std::uint32_t e, double u0, double u1) {
      const std::uint32_t i = k++;
      if (i < before || (i == before && is_at_end)) return;
      std::uint32_t f = first_[e];
      while (fragments_[f].arc != arc || fragments_[f].u0 != u0 || fragments_[f].u1 != u1) f = fragments_[f].next;
      if (i > before || is_at_start) {
        fragments_[f].arc = behind;
        return;
      }
      fragments_[f].u1 = at.u;
      fragments_.push_back({behind, first_[e], at.u, u1});
      first_[e] = static_cast<std::uint32_t>(fragments_.size() - 1);
    });
    arcs[behind].is_ring = arcs[arc].is_ring && before == 0 && at.u == arcs[arc].from.u;
    arcs[arc].is_ring = false;
    arcs[arc].to = is_at_start ? end_before(at) : at;
    arcs[behind].from = is_at_end ? start_behind(at) : at;
    return behind;
  }
  /// Returns the place as the end of the element before or the start of the one behind, where it is between two.
  [[nodiscard]] Boundary_place end_before(const Boundary_place& p) const {
    if (p.u != boundary_.element(p.element).first) return p;
    const std::uint32_t e = boundary_.before(p.element);
    return {e, boundary_.element(e).last};
  }
  [[nodiscard]] Boundary_place start_behind(const Boundary_place& p) const {
    if (p.u != boundary_.element(p.element).last) return p;
    const std::uint32_t e = boundary_.after(p.element);
    return {e, boundary_.element(e).first};
  }
  /// Tells the arcs of a part where they are.
  void number(std::uint32_t part) {
    for (std::uint32_t i = 0; i < parts[part].arcs.size(); ++i) {
      arcs[parts[part].arcs[i]].part = part;
      arcs[parts[part].arcs[i]].position = i;
    }
  }
  /// How many elements an arc has before the one of a place on it.
  [[nodiscard]] std::uint32_t steps(const Boundary_arc& arc, const Boundary_place& at) const {
    const Boundary_ring& ring = boundary_.rings()[boundary_.element(arc.from.element).ring];
    const std::uint32_t n = ring.end - ring.begin, k = (at.element + n - arc.from.element) % n;
    return k == 0 && arc.is_around() && at.u < arc.from.u ? n : k;
  }
  /// Whether a place is on an arc.
  [[nodiscard]] bool is_on(const Boundary_arc& arc, const Boundary_place& p) const {
    const std::uint32_t k = steps(arc, p), count = length(arc);
    if (k >= count || boundary_.element(p.element).ring != boundary_.element(arc.from.element).ring) return false;
    return !(k == 0 && p.u < arc.from.u) && !(k + 1 == count && p.u > arc.to.u);
  }

  /// What discs that touch one arc of a part may touch: the other ones.
  struct Others {
    const Axis_parts& parts;
    std::uint32_t part, own;
    template <class Visit> void operator()(std::uint32_t e, const Visit& visit) const {
      for (std::uint32_t f = parts.first_[e]; f != NONE; f = parts.fragments_[f].next) {
        const Fragment& fragment = parts.fragments_[f];
        if (fragment.arc == own || (part != NONE && parts.arcs[fragment.arc].part != part)) continue;
        visit(fragment.u0, fragment.u1);
      }
    }
  };
  using Search = Disc_search<Others>;
  /// Searches among the elements of a part. Few elements are looked at one after the other: in the tree there would be
  /// others in a large disc, too. Where there are many, the search starts from where the disc among all parts touches,
  /// as that disc is no larger.
  void run(Search& search, const Others& others) const {
    constexpr std::uint32_t FEW = 32;
    constexpr std::size_t MANY = 1024;
    std::uint32_t count = 0;
    for (const std::uint32_t arc : parts[others.part].arcs) {
      if (arc != others.own) count += length(arcs[arc]);
      if (count > FEW) break;
    }
    if (count > FEW && boundary_.elements().size() > MANY) seed(search, others);
    if (count > FEW) return search.search();
    for (const std::uint32_t arc : parts[others.part].arcs)
      if (arc != others.own)
        for_each_element(arcs[arc], [&](std::uint32_t e, double u0, double u1) { search.look_at_part(e, u0, u1); });
    search.finish();
  }
  void seed(Search& search, const Others& others) const {
    const Others any{*this, NONE, others.own};
    Search all = search.among(any);
    all.search();
    if (!all.is_found()) return;
    if (arc_of(others.part, others.own, all.place()) != NONE) search.start_from(all.place());
  }
  /// The arc of a part, or of any, that has a place, other than `own`: one that goes on there rather than one that is
  /// just the point.
  [[nodiscard]] std::uint32_t arc_of(std::uint32_t part, std::uint32_t own, const Boundary_place& p) const {
    std::uint32_t found = NONE;
    for (std::uint32_t f = first_[p.element]; f != NONE; f = fragments_[f].next) {
      const Fragment& fragment = fragments_[f];
      if (fragment.arc == own || (part != NONE && arcs[fragment.arc].part != part)) continue;
      if (!(fragment.u0 <= p.u && p.u <= fragment.u1)) continue;
      if (found == NONE || fragment.u0 < fragment.u1) found = fragment.arc;
    }
    return found;
  }

  static constexpr std::uint32_t NONE = static_cast<std::uint32_t>(-1);

 private:
  struct Fragment {
    std::uint32_t arc, next;
    double u0, u1;
  };

  const Axis_boundary& boundary_;
  std::vector<Fragment> fragments_;
  std::vector<std::uint32_t> first_;  // of each element
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
