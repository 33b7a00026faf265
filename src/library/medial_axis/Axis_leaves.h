// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the axis of a ring ends: at convex corners, and at maxima of curvature whose osculating disc is empty.
//
// Curvature is monotone along a spiral segment, so its maxima are among the segments' ends.  Values that are the same
// within what they may be wrong by are one: a circular arc of largest curvature is one leaf, whose disc touches all of
// it.

#ifndef BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_AXIS_LEAVES_H
#define BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_AXIS_LEAVES_H

#include "Axis_boundary.h"
#include "Disc_search.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// A disc that touches the boundary from one place on up to another one.
struct Axis_leaf {
  Boundary_place first, last;
  Touching_disc disc;
};

struct Ring_leaves {
  std::vector<Axis_leaf> leaves;
  bool is_circle = false;  ///< the ring has one curvature, that of its disc
  Axis_leaf circle{};
  double moved = 0;  ///< by how much joints were rounded off, or points are off the circle
};

class Leaf_finder {
 public:
  explicit Leaf_finder(const Axis_boundary& boundary) : boundary_(boundary) {}

  [[nodiscard]] Ring_leaves leaves(std::uint32_t ring) {
    const std::vector<End> ends = ends_of(boundary_.rings()[ring]);
    constexpr double ROUNDING = 8;  // times the resolution
    Ring_leaves result;
    if (is_circle_within(ROUNDING, ends, result)) return result;
    add_all_maxima(ends, result);
    // arcs that have a center each, next to each other, and so no empty disc
    const bool is_circle = result.leaves.empty() && is_circle_within(MOST, ends, result);
    if (!is_circle && result.leaves.size() < 2) {  // both of a slot may have its sides in their discs by a rounding
      room_ = ROUNDING * boundary_.resolution();
      result = {};
      add_all_maxima(ends, result);
      room_ = 0;
    }
    const Boundary_ring& of = boundary_.rings()[ring];
    for (std::uint32_t e = of.begin; e < of.end; ++e)
      if (boundary_.element(e).is_before_tip() && is_smooth_joint(e))
        result.moved = (std::max)(result.moved, tip_height());
    if (!is_circle && result.leaves.empty()) add_maxima_of_ring(ends, result.leaves);
    return result;
  }

 private:
  struct End {
    Boundary_place place;
    double value, error;
    bool is_corner = false;
    std::optional<Axis_leaf> leaf{};  // of a corner that is rounded
  };
  [[nodiscard]] static bool are_within(const End& a, const End& b, double share) {
    return a.value == b.value || (std::isfinite(a.value) && std::isfinite(b.value) &&
                                  std::fabs(a.value - b.value) <=
                                      a.error + b.error + share * (std::max)(std::fabs(a.value), std::fabs(b.value)));
  }
  static constexpr double MOST = 64;  // times the resolution: points are no farther off a circle
  // Rounded control points of a spline make joints differ by less, of the curvature.
  static constexpr double ALIKE = 0x1p-32;
  [[nodiscard]] static bool are_alike(const End& a, const End& b) { return are_within(a, b, ALIKE); }
  [[nodiscard]] static bool are_same(const End& a, const End& b) {
    return !a.is_corner && !b.is_corner && are_within(a, b, a.place.element == b.place.element ? 0 : ALIKE);
  }

  // Whether a ring has one curvature, and leaves the disc that it has then by so many times the resolution at most.
  [[nodiscard]] bool is_circle_within(double most, const std::vector<End>& ends, Ring_leaves& result) const {
    const End *best = nullptr, *last = nullptr;
    for (const End& e : ends) {
      if (e.leaf || is_dent(e)) continue;
      if (!std::isfinite(e.value) || (last != nullptr && !are_alike(*last, e))) return false;
      if (best == nullptr || e.error < best->error) best = &e;
      last = &e;
    }
    if (best == nullptr || !(best->value > 0) || !are_alike(*last, ends.front())) return false;
    const Axis_leaf circle = osculating(*best, ends.front(), *last);
    const double gap = most_gap(circle.disc, points_between(ends.front().place, ends.back().place));
    if (!(gap <= most * boundary_.resolution())) return false;
    result.is_circle = true;
    result.circle = circle;
    result.moved = gap > boundary_.resolution() ? gap : 0;
    return true;
  }
  // A corner of nearly no angle.
  [[nodiscard]] bool is_dent(const End& e) const {
    const Boundary_element& element = boundary_.element(e.place.element);
    return element.is_corner && element.last - element.first < Boundary_element::ROUNDED_TURN;
  }

  // Ends with one value, from one on up to another: numbers modulo that of all ends.
  struct Run {
    std::size_t first, last;
  };
  void add_all_maxima(const std::vector<End>& ends, Ring_leaves& result) const {
    const std::size_t n = ends.size();
    std::size_t start = 0;  // of a group of ends with one value
    while (start < n && are_same(ends[(start + n - 1) % n], ends[start])) ++start;
    for (std::size_t i = start; start < n && i < start + n;) {
      std::size_t last = i;
      while (last + 1 < start + n && are_same(ends[last % n], ends[(last + 1) % n])) ++last;
      if (ends[i % n].leaf) result.moved = tip_height();
      add_maxima(ends, {i, last}, result.leaves);
      i = last + 1;
    }
  }
  // A short element may have any curvature but for rounding, so a run may have more than one curvature: that of arcs
  // before and behind the flat end of a slot that is a little wider than they are, or of an arc and a line that it
  // turns into a little beyond its end. Then parts of the run with a known curvature are looked at by themselves.
  void add_maxima(const std::vector<End>& ends, const Run& run, std::vector<Axis_leaf>& leaves) const {
    const auto end = [&](std::size_t k) -> const End& { return ends[k % ends.size()]; };
    const std::vector<Run> parts = known_parts(ends, run);
    const End& best = best_of(ends, run);
    const bool is_maximum = best.value > best.error && is_less(end(run.first + ends.size() - 1), end(run.first)) &&
                            is_less(end(run.last + 1), end(run.last));
    if (is_maximum && (parts.size() < 2 || are_on_circle(best, end(run.first), end(run.last))))
      return add(best, end(run.first), end(run.last), leaves);
    for (const Run& part : parts) {
      const auto from = maximal_end(ends, part, part.first, ends.size() - 1),
                 to = maximal_end(ends, part, part.last, 1);
      if (from && to) add(best_of(ends, part), end(*from), end(*to), leaves);
    }
  }
  // Where all ends have one value: those of a square that is nearly a circle.
  void add_maxima_of_ring(const std::vector<End>& ends, std::vector<Axis_leaf>& leaves) const {
    const double sure = surely_least(ends, {0, ends.size() - 1});
    const auto unknown = std::find_if_not(ends.begin(), ends.end(), [&](const End& e) { return is_known(e, sure); });
    if (unknown == ends.end()) return;
    const auto first = static_cast<std::size_t>(unknown - ends.begin());
    add_maxima(ends, {first, first + ends.size() - 1}, leaves);
  }
  // The curvature falls behind a part, or before it: where what is known next is less, or, where that is the same again
  // about another center, where an element between is.
  // \param step to the next end, modulo the number of ends
  // \return the last end on the part's circle that way; nothing where curvature does not fall
  [[nodiscard]] std::optional<std::size_t> maximal_end(const std::vector<End>& ends, const Run& part, std::size_t last,
                                                       std::size_t step) const {
    const auto end = [&](std::size_t k) -> const End& { return ends[k % ends.size()]; };
    const End& best = best_of(ends, part);
    if (!(best.value > best.error)) return std::nullopt;
    std::size_t next = last + step;
    for (std::size_t count = 0; count < ends.size() && !is_known(end(next), best.value - best.error); ++count)
      next += step;
    if (are_alike(end(next), end(last)))
      return is_less(end(last + step), end(last)) ? std::optional(last) : std::nullopt;
    if (!is_less(end(next), end(last))) return std::nullopt;
    const std::size_t before = next + (ends.size() - step);  // unknown, or the last one
    const bool is_forward = step == 1;
    const End &from = is_forward ? end(part.first) : end(before), &to = is_forward ? end(before) : end(part.last);
    return before % ends.size() == last % ends.size() || are_on_circle(best, from, to) ? before : last;
  }
  [[nodiscard]] static const End& best_of(const std::vector<End>& ends, const Run& run) {
    std::size_t best = run.first;
    for (std::size_t k = run.first; k <= run.last; ++k)
      if (ends[k % ends.size()].error < ends[best % ends.size()].error) best = k;
    return ends[best % ends.size()];
  }
  // A curvature that some end of a run has at least.
  [[nodiscard]] static double surely_least(const std::vector<End>& ends, const Run& run) {
    double least = -std::numeric_limits<double>::infinity();
    for (std::size_t k = run.first; k <= run.last; ++k)
      least = (std::max)(least, ends[k % ends.size()].value - ends[k % ends.size()].error);
    return least;
  }
  [[nodiscard]] static bool is_known(const End& e, double beside) { return e.error < 0.5 * beside; }
  [[nodiscard]] static std::vector<Run> known_parts(const std::vector<End>& ends, const Run& run) {
    const double sure = surely_least(ends, run);
    std::vector<Run> parts;
    for (std::size_t k = run.first; k <= run.last; ++k) {
      if (!is_known(ends[k % ends.size()], sure)) continue;
      if (parts.empty() || parts.back().last + 1 != k) parts.push_back({k, k});
      parts.back().last = k;
    }
    return parts;
  }
  // Whether all points between two ends are on the circle that a leaf there has.
  [[nodiscard]] bool are_on_circle(const End& best, const End& from, const End& to) const {
    return most_gap(osculating(best, from, to).disc, points_between(from.place, to.place)) <=
           MOST * boundary_.resolution();
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
      if (e.is_corner) {
        ends.push_back({{i, e.first}, -INFINITE, 0});
        continue;
      }
      const double bend = least_bend(e);
      for (const double u : {e.first, e.last}) {
        ends.push_back(end_at({i, u}));
        if (std::isfinite(ends.back().value)) ends.back().error += bend;
      }
      const auto rounded = rounded_joint(i);
      if (rounded || (e.is_before_tip() && !is_smooth_joint(i)))
        ends.push_back({{i, e.last}, INFINITE, 0, true, rounded});
    }
    return ends;
  }

  // Joints that turn by little, as those of drawings with six decimals do.  Let an element of curvature k turn by the
  // angle a into another one of curvature k - d.  To the second order a disc of curvature k + x touches both sides, at
  // distances s and t from the joint, and leaves a tip of the height h beyond it.  With v^2 = x and w^2 = x + d,
  //
  //   h = a^2 / (2 (v + w)^2),   s = a / (v (v + w)),   t = a / (w (v + w)).
  //
  // With h as small as coordinates tell, that disc is the leaf of a joint that is rounded off so.  Where x = 0 would
  // leave less, or touches would be as far as elements are long, the joint is smooth.

  /// How high what is rounded off is.
  [[nodiscard]] double tip_height() const { return 4 * boundary_.resolution(); }
  /// The elements of one Bezier piece from a joint on, or backwards from it.
  [[nodiscard]] std::vector<std::uint32_t> run(std::uint32_t e, bool is_forward) const {
    const Segment_hierarchy& curves = boundary_.curves();
    std::vector<std::uint32_t> elements;
    const Boundary_ring& ring = boundary_.rings()[boundary_.element(e).ring];
    const auto bezier = [&](std::uint32_t i) { return curves.bezier_of(boundary_.element(i).segment); };
    for (std::uint32_t i = e;
         elements.size() < ring.end - ring.begin && !boundary_.element(i).is_corner && bezier(i) == bezier(e);) {
      elements.push_back(i);
      i = is_forward ? boundary_.after(i) : boundary_.before(i);
    }
    return elements;
  }
  [[nodiscard]] double length(std::uint32_t e) const { return boundary_.length(boundary_.element(e).segment); }
  [[nodiscard]] double reach(std::uint32_t e, bool is_forward) const {
    double sum = 0;
    for (const std::uint32_t i : run(e, is_forward)) sum += length(i);
    return sum;
  }
  struct Joint {
    double turn, before, behind;  // curvatures
    [[nodiscard]] double difference() const { return std::fabs(before - behind); }
  };
  [[nodiscard]] Joint joint_at_end_of(std::uint32_t e) const {
    const std::uint32_t next = boundary_.after(e);
    return {boundary_.element(e).turn, boundary_.curvature({e, boundary_.element(e).last}).value,
            boundary_.curvature({next, boundary_.element(next).first}).value};
  }
  /// x of the disc that leaves such a tip.
  [[nodiscard]] double excess(const Joint& joint) const {
    const double w = joint.turn / std::sqrt(2 * tip_height()), root = (w - joint.difference() / w) / 2;
    return root > 0 ? root * root : 0;
  }
  /// Whether the disc of the larger curvature at a joint that turns by little leaves no higher tip beyond it.
  [[nodiscard]] bool is_smooth_joint(std::uint32_t e) const {
    constexpr double LITTLE = 0x1p-10;
    if (!(boundary_.element(e).turn < LITTLE)) return false;
    const Joint joint = joint_at_end_of(e);
    return joint.difference() > 0 && std::isfinite(joint.difference()) && excess(joint) == 0;
  }
  /// Whether an element turns into the next one to the left, by little and by more than nothing.
  [[nodiscard]] bool is_bent(std::uint32_t e) const {
    const double turn = boundary_.element(e).turn;
    const std::uint32_t next = boundary_.after(e);
    if (!(turn > 0 && turn < Boundary_element::ROUNDED_TURN) || boundary_.is_smooth(turn, boundary_.largest_radius()) ||
        boundary_.is_smooth(turn, (std::min)(reach(e, false), reach(next, true))))
      return false;
    const Joint joint = joint_at_end_of(e);
    return std::isfinite(joint.difference()) && excess(joint) > 0;
  }
  /// The leaf of a joint at the end of an element, if that turns to the left by little and there is one.
  [[nodiscard]] std::optional<Axis_leaf> rounded_joint(std::uint32_t e) const {
    if (!is_bent(e)) return std::nullopt;
    const std::uint32_t next = boundary_.after(e);
    const Joint joint = joint_at_end_of(e);
    const bool is_own_before = joint.before >= joint.behind;
    const double v = std::sqrt(excess(joint)), w = std::sqrt(excess(joint) + joint.difference()),
                 s = joint.turn / (v * (v + w));
    const Boundary_place p = place_from_joint(is_own_before ? e : next, !is_own_before, s);
    const std::vector<std::uint32_t> beyond = run(is_own_before ? next : e, is_own_before);
    const auto others = [&](std::uint32_t i, const auto& visit) {
      if (std::find(beyond.begin(), beyond.end(), i) != beyond.end())
        visit(boundary_.element(i).first, boundary_.element(i).last);
    };
    Disc_search search(boundary_, others, boundary_(p), boundary_.largest_radius());
    for (const std::uint32_t i : beyond) search.look_at_part(i, boundary_.element(i).first, boundary_.element(i).last);
    search.finish();
    const Boundary_place q = search.place();
    const Xy<double> at = boundary_({e, boundary_.element(e).last}).point;
    // what is beyond is nearer, in another disc; the height of a tip is some resolutions, so that s is not told well
    constexpr double FAR = 4;
    if (!search.is_found() || !(euclidean_norm(boundary_(q).point - at) <= FAR * s)) return std::nullopt;
    const Axis_leaf leaf{is_own_before ? p : q, is_own_before ? q : p, search.disc()};
    double most = 0;  // curvature of the elements with both touches, and of those between
    for (std::uint32_t i = leaf.first.element;; i = boundary_.after(i)) {
      for (const double u : {boundary_.element(i).first, boundary_.element(i).last})
        most = (std::max)(most, boundary_.curvature({i, u}).value);
      if (i == leaf.last.element) break;
    }
    // where they bend more elsewhere the joint is no leaf, or nothing beside that
    return most * leaf.disc.radius <= 1 && is_empty(leaf) ? std::optional(leaf) : std::nullopt;
  }
  /// The place on a Bezier piece at a distance from a joint; in the middle of its last element at most.
  [[nodiscard]] Boundary_place place_from_joint(std::uint32_t e, bool is_forward, double distance) const {
    const std::vector<std::uint32_t> elements = run(e, is_forward);
    std::size_t k = 0;
    for (; k + 1 < elements.size() && length(elements[k]) < distance; ++k) distance -= length(elements[k]);
    const Boundary_element& element = boundary_.element(elements[k]);
    const double start = is_forward ? element.first : element.last,
                 step =
                     (std::min)(distance / boundary_({elements[k], start}).speed, (element.last - element.first) / 2);
    return {elements[k], is_forward ? start + step : start - step};
  }

  // An arc of length l that is more curved than what is beside it by k is l^2 k / 8 higher: this tells of heights that
  // are nothing.
  [[nodiscard]] double least_bend(const Boundary_element& e) const {
    const Spiral_piece_2 p = boundary_.curves().piece(e.segment);
    const Xy<double> chord = p.last.point - p.first.point;
    return 8 * boundary_.resolution() / dot(chord, chord);
  }
  // The disc that has the curvature of all ends from one to another, and touches all that is between them: a circle's
  // points tell its center better than its curvature does.
  [[nodiscard]] Axis_leaf osculating(const End& best, const End& from, const End& to) const {
    const Boundary_jet jet = boundary_(best.place);
    const double r = std::isfinite(best.value) ? 1 / best.value : 0;
    Touching_disc disc{jet.point + r * jet.normal(), r};
    constexpr double GOOD = 0x1p-4;    // of the resolution: of points next to each other there is no better disc
    constexpr double ALIKE = 0x1p-10;  // radii: between ends that are one within their errors, all may be a line
    if (r > 0 && r < boundary_.largest_radius()) {
      const Touching_disc fit = fitted(disc, points_between(from.place, to.place), GOOD * boundary_.resolution());
      if (std::fabs(fit.radius - r) <= r * (std::max)(ALIKE, best.error / best.value)) disc = fit;
    }
    return {from.place, to.place, disc};
  }
  [[nodiscard]] std::vector<Xy<double>> points_between(const Boundary_place& from, const Boundary_place& to) const {
    std::vector<Xy<double>> points{boundary_(from).point};
    const Boundary_element& first = boundary_.element(from.element);
    // an end of an element alone, or all elements up to the one that has the other end: those of the ring, where that
    // is before the first one
    const bool is_behind = from.u == first.last, is_before = to.u == boundary_.element(to.element).first;
    std::uint32_t e = is_behind ? boundary_.after(from.element) : from.element;
    const std::uint32_t end = is_before ? to.element : boundary_.after(to.element);
    for (bool is_ring = !is_behind && !is_before && e == end; is_ring || e != end; is_ring = false) {
      const Boundary_element& element = boundary_.element(e);
      points.push_back(boundary_({e, 0.5 * (element.first + element.last)}).point);
      points.push_back(boundary_({e, element.last}).point);
      e = boundary_.after(e);
    }
    return points;
  }

  void add(const End& best, const End& from, const End& to, std::vector<Axis_leaf>& leaves) const {
    if (from.is_corner) {
      const std::uint32_t next = boundary_.after(from.place.element);
      const Boundary_place behind{next, boundary_.element(next).first};
      leaves.push_back(from.leaf ? *from.leaf : Axis_leaf{from.place, behind, {boundary_(from.place).point, 0}});
      return;
    }
    const Axis_leaf leaf = osculating(best, from, to);
    if (leaf.disc.radius == 0 || (leaf.disc.radius < boundary_.largest_radius() && is_empty(leaf)))
      leaves.push_back(leaf);
  }

  // What falls off from the largest curvature stays outside of the disc (Kneser), however many elements it runs
  // through; anything else might be in it.
  struct All_but {
    const Axis_boundary& boundary;
    std::uint32_t first, last;  // elements, in order around the ring
    template <class Visit> void operator()(std::uint32_t e, const Visit& visit) const {
      const Boundary_element& element = boundary.element(e);
      // the other side of a part is where this one is
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
    const std::uint32_t before = IS_FORWARD ? e : next;
    if (boundary_.element(before).turn > 0 && (boundary_.element(before).is_before_tip() || is_bent(before)))
      return false;
    const auto end = [&](std::uint32_t i, bool is_far) {
      const Boundary_element& element = boundary_.element(i);
      return end_at({i, is_far == IS_FORWARD ? element.last : element.first});
    };
    const End near = end(e, false), joint = end(e, true), behind = end(next, false), far = end(next, true);
    const auto is_below = [](const End& a, const End& b) { return a.value < b.value && !are_same(a, b); };
    return is_below(joint, near) && (behind.value <= joint.value || are_same(behind, joint)) && is_below(far, behind);
  }
  // Seen from either end of what it touches: from one of them rounding may put the other, where a corner is, into it.
  [[nodiscard]] bool is_empty(const Axis_leaf& leaf) const {
    const All_but others = others_of(leaf);
    const auto is_empty_from = [&](const Boundary_place& p) {
      Disc_search search(boundary_, others, boundary_(p), leaf.disc.radius - room_);
      search.search();
      return !search.is_found();
    };
    const bool is_one = leaf.first.element == leaf.last.element && leaf.first.u == leaf.last.u;
    return is_empty_from(leaf.first) || (!is_one && is_empty_from(leaf.last));
  }

  const Axis_boundary& boundary_;
  double room_ = 0;  // by how much less than a leaf's disc is to be empty
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
