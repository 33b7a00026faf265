// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where curves are cut: at common points and ends of overlaps, each of which has a place on either curve, and at the
// ends of open curves.
//
// Places that are an ulp apart are one cut, or as many as asked for.  Cuts that any place joins are at one vertex.
// Exact arithmetic tells whether all places of a cut are the same.

#ifndef CGAL_BOUNDING_ARCS_2_BOOLEAN_INTERNAL_CUT_PLACES_H
#define CGAL_BOUNDING_ARCS_2_BOOLEAN_INTERNAL_CUT_PLACES_H

#include <CGAL/Bounding_arcs_2/boolean/internal/Meeting_place.h>
#include <CGAL/Bounding_arcs_2/query/Curve_joints.h>
#include <CGAL/Bounding_arcs_2/query/Intersections_2.h>
#include <CGAL/Bounding_arcs_2/tree/Segment_hierarchy.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// Where a curve is cut.
struct Curve_cut {
  Joint_place place;
  std::uint32_t vertex;
  double moved = 0;  ///< how far in the parameter the point may be from the place, where that is a joint
  [[nodiscard]] double t() const { return place.t.middle(); }
};

/// What is at most so long is some ulp, by the size of coordinates.
inline constexpr double SHORT_LOOP = 0x1p-46;

/// \return a bound of how far a part of a Bezier piece is from its start: its chord, and how far it may be from that
[[nodiscard]] inline double most_extent(const Bezier_evaluator& curve, double from, double to) {
  const double width = to - from;
  return euclidean_norm(curve(to).point - curve(from).point) + width * width / 8 * curve.second_bound();
}

class Cut_places {
 public:
  /// \param nearest places no farther from each other on a curve are one cut, in the parameter
  Cut_places(const Segment_hierarchy& curves, const Intersections_2<>& common, double nearest = NEAREST_CUTS)
      : curves_(curves), joints_(curves), nearest_(nearest) {
    for (const Intersection_2<>& p : common.points) add_pair(p.a, p.b, false);
    for (const Overlap_2& o : common.overlaps) {
      add_pair(o.a_from, o.b_from, true);
      add_pair(o.a_to, o.b_to, true);
    }
    for (std::uint32_t c = 0; c < curves.drawing().curves().size(); ++c) add_ends(c);
    sets_ = Sets(entries_.size());
    for (std::uint32_t i = 0; i < entries_.size(); ++i) sets_.make_set(i);
    for (std::uint32_t i = 0; i < entries_.size(); i += 2) sets_.union_set(i, i + 1);
    sort();
    move_to_joints(nearest_, false);
    do join_near_ones();  // what moves to a joint meets what is there
    while (move_to_joints(SHORT_LOOP, true));
    make_cuts();
  }

  /// In the order of the curves.
  [[nodiscard]] std::vector<Curve_cut>& cuts() { return cuts_; }
  [[nodiscard]] std::uint32_t number_of_vertices() const { return vertices_; }
  /// Cuts at common points, on both curves in turn, then at the ends of overlaps: a_from, b_from, a_to, b_to.
  [[nodiscard]] std::vector<std::uint32_t>& cut_of_place() { return cut_of_place_; }
  /// Whether places of one cut are the same point, not different ones that doubles hardly tell apart.
  [[nodiscard]] bool is_resolved() const { return is_resolved_; }

 private:
  using Sets = boost::disjoint_sets_with_storage<>;

  struct Entry {
    Meeting_place at;
    Joint_place cut;  // the place, or the joint that it is next to
    std::uint32_t number;
  };

  [[nodiscard]] Joint_place place(const Curve_range& r) const {
    return joints_.place(curves_.number_of_bezier(r.curve, r.bezier), r.t);
  }
  void add_pair(const Curve_range& a, const Curve_range& b, bool is_overlap_end) {
    const Joint_place p = place(a), q = place(b);
    entries_.push_back({{p, q, is_overlap_end}, p, static_cast<std::uint32_t>(entries_.size())});
    entries_.push_back({{q, p, is_overlap_end}, q, static_cast<std::uint32_t>(entries_.size())});
  }
  void add_ends(std::uint32_t curve) {
    const auto& drawn = curves_.drawing().curves()[curve];
    if (drawn.is_closed || drawn.beziers.empty()) return;
    const Curve_range first{curve, 0, {0, 0}},
        last{curve, static_cast<std::uint32_t>(drawn.beziers.size() - 1), {1, 1}};
    for (const Curve_range& end : {first, last}) add_pair(end, end, true);
  }
  [[nodiscard]] Joint_place at_joint(const Joint_place& p, double room) const {
    if (p.t.upper <= room) return joints_.place(p.bezier, {0, 0});
    return p.t.lower >= 1 - room ? joints_.place(p.bezier, {1, 1}) : p;
  }
  [[nodiscard]] std::size_t set(const Entry& e) { return sets_.find_set(static_cast<std::size_t>(e.number)); }
  void sort() {
    std::sort(entries_.begin(), entries_.end(), [](const Entry& p, const Entry& q) { return p.cut < q.cut; });
  }
  // \param cut made of the entries before
  [[nodiscard]] static bool is_near(const Joint_place& cut, const Entry& e, double room) {
    return cut.bezier == e.cut.bezier && e.cut.t.lower - cut.t.upper <= room;
  }

  // Whether the curve between them is as short as some ulp: beside a tip it is so over many parameters. Such cuts of
  // one vertex are one: doubles may tell them apart on one of its curves, not on another.
  [[nodiscard]] bool is_short_loop(const Joint_place& cut, const Entry& e) const {
    if (is_near(cut, e, SHORT_LOOP)) return true;
    if (cut.bezier != e.cut.bezier) return false;
    const Bezier_evaluator& curve = curves_.evaluator(cut.bezier);
    return most_extent(curve, cut.t.lower, e.cut.t.upper) <= SHORT_LOOP * curve.coordinate_size();
  }

  void join_near_ones() {
    for (std::size_t i = 1, first = 0; i < entries_.size(); ++i) {
      Joint_place& cut = entries_[first].cut;
      if (is_near(cut, entries_[i], nearest_)) {
        sets_.union_set(set(entries_[first]), set(entries_[i]));
        cut.t.upper = (std::max)(cut.t.upper, entries_[i].cut.t.upper);
      } else first = i;
    }
  }
  // Places next to a joint go there where a cut is at it or on its other side, too, with all places that are nearer;
  // where cuts are joined that are farther apart, they go in any case.
  // \param by_set whether these must be at one vertex
  // \return whether any did
  bool move_to_joints(double room, bool by_set) {
    enum Side { BEFORE, AT, BEHIND };
    struct Near {
      std::uint32_t joint;
      std::size_t set;
      Side side;
      std::size_t entry;
      double distance;
    };
    std::vector<Near> near;
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      const Joint_place& cut = entries_[i].cut;
      const Joint_place joint = at_joint(cut, room);
      if (!joint.is_start()) continue;
      const Side side = cut.is_start() ? AT : (cut.bezier == joint.bezier && cut.t.upper <= room ? BEHIND : BEFORE);
      const double distance = side == AT ? 0 : (side == BEHIND ? cut.t.upper : 1 - cut.t.lower);
      near.push_back({joint.bezier, by_set ? set(entries_[i]) : 0, side, i, distance});
    }
    const auto key = [](const Near& n) { return std::tuple(n.joint, n.set, n.side, n.entry); };
    std::sort(near.begin(), near.end(), [&key](const Near& p, const Near& q) { return key(p) < key(q); });
    bool is_moved = false;
    for (std::size_t i = 0, end = 0; i < near.size(); i = end) {
      double reach[] = {-1, -1, -1};  // of what goes to the joint, by side
      while (end < near.size() && near[end].joint == near[i].joint) {
        const std::size_t first = end;
        while (end < near.size() && near[end].joint == near[i].joint && near[end].set == near[first].set) ++end;
        if (near[first].side == near[end - 1].side && nearest_ == NEAREST_CUTS) continue;
        for (std::size_t k = first; k < end; ++k)
          reach[near[k].side] = (std::max)(reach[near[k].side], near[k].distance);
      }
      for (std::size_t k = i; k < end; ++k) {
        if (near[k].side == AT || near[k].distance > reach[near[k].side]) continue;
        entries_[near[k].entry].cut = {near[k].joint, {0, 0}};
        is_moved = true;
      }
    }
    sort();
    return is_moved;
  }
  void make_cuts() {
    cut_of_place_.resize(entries_.size());
    std::vector<std::size_t> set_of_cut;
    std::size_t first = 0;  // of the last cut
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      const Entry& e = entries_[i];
      if (i > 0 && (is_near(cuts_.back().place, e, nearest_) ||
                    (set_of_cut.back() == set(e) && is_short_loop(cuts_.back().place, e)))) {
        is_resolved_ = is_resolved_ && is_same(entries_[first], e);
        cuts_.back().place.t.upper = (std::max)(cuts_.back().place.t.upper, e.cut.t.upper);
      } else {
        first = i;
        cuts_.push_back({e.cut, 0});
        set_of_cut.push_back(set(e));
      }
      if (e.cut.is_start() && !e.at.place.is_start()) cuts_.back().moved = SHORT_LOOP;
      cut_of_place_[e.number] = static_cast<std::uint32_t>(cuts_.size() - 1);
    }
    constexpr std::uint32_t NONE = (std::numeric_limits<std::uint32_t>::max)();
    std::vector<std::uint32_t> number_of_set(entries_.size(), NONE);
    for (std::size_t c = 0; c < cuts_.size(); ++c) {
      std::uint32_t& number = number_of_set[set_of_cut[c]];
      if (number == NONE) number = vertices_++;
      cuts_[c].vertex = number;
    }
  }

  // Both places of one meeting are the same at the tip of a curve that runs back over itself.
  [[nodiscard]] bool is_same(const Entry& p, const Entry& q) const {
    if (!p.at.place.touches(q.at.place)) return false;
    return (p.number ^ 1U) == q.number ? p.at.is_overlap_end : are_same(curves_, curves_, p.at, q.at);
  }

  const Segment_hierarchy& curves_;
  Curve_joints joints_;
  double nearest_;
  std::vector<Entry> entries_;
  Sets sets_{0};  // of entries, by number: the vertices
  std::vector<Curve_cut> cuts_;
  std::vector<std::uint32_t> cut_of_place_;
  std::uint32_t vertices_ = 0;
  bool is_resolved_ = true;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
