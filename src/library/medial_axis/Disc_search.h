// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The largest disc that touches the boundary at a place p from inside and has no boundary in it.
//
// All discs that touch at p, with the inner normal n, lie in each other.  Where q is in one, the largest that is left
// has the radius |q - p|^2 / (2 n.(q - p)).  So one disc is kept; boxes and fat arcs that are not in it can be left
// out, and of what is left the point nearest to its center makes it smaller: that is Newton's method for the radius at
// which a piece is touched.

#ifndef BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_DISC_SEARCH_H
#define BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_DISC_SEARCH_H

#include "../query/Closest_search.h"
#include "Axis_boundary.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// \tparam Ranges ranges(element, visit) calls visit(u0, u1) for each part of an element that counts
template <class Ranges> class Disc_search {
 public:
  /// \param at where discs touch
  /// \param most the radius to begin with
  Disc_search(const Axis_boundary& boundary, const Ranges& ranges, const Boundary_jet& at, double most)
      : boundary_(boundary), curves_(boundary.curves()), ranges_(ranges),
        at_(at), disc_{at.point + most * at.normal(), most}, resolution_(boundary.resolution()),
        noise_((std::max)(NOISE * resolution_, boundary.hidden_height())) {}

  /// Takes a place that counts into account before all others, so that less is in the disc.
  void start_from(const Boundary_place& place) { offer(place, boundary_(place).point); }
  void search() {
    for_each_near(curves_.boxes(), *this);
    finish();
  }
  // What boxes are asked for, see for_each_near: the disc shrinks towards p, so that distances from its first center
  // tell nothing of what counts later.
  [[nodiscard]] const Xy<double>& point() const { return disc_.center; }
  [[nodiscard]] double squared_reach() const { return inner() * inner(); }
  [[nodiscard]] bool goes_on(double) const { return true; }
  void look_at(std::uint32_t segment) {
    bool is_near = false;  // asked for once, of a segment that counts
    const auto near = [&] {
      return is_near = is_near || distance_bounds(disc_.center, curves_.region(segment)).lower < inner(segment);
    };
    boundary_.for_each_element_of(segment, [&](std::uint32_t e) {
      ranges_(e, [&](double u0, double u1) {
        if (near()) look_at(e, u0, u1);
      });
    });
  }
  /// Looks at one part of an element: where few count, one after the other, then `finish`.
  void look_at_part(std::uint32_t e, double u0, double u1) {
    const Boundary_element& element = boundary_.element(e);
    if (element.is_corner ||
        distance_bounds(disc_.center, curves_.region(element.segment)).lower < inner(element.segment))
      look_at(e, u0, u1);
  }
  void finish() {
    if (is_found_) choose_element();
  }
  /// A search from where this one is, in other ranges.
  [[nodiscard]] Disc_search among(const Ranges& ranges) const {
    return Disc_search(boundary_, ranges, at_, disc_.radius);
  }
  /// Whether anything was in the disc to begin with.
  [[nodiscard]] bool is_found() const { return is_found_; }
  [[nodiscard]] const Touching_disc& disc() const { return disc_; }
  /// What the disc touches.
  [[nodiscard]] const Boundary_place& place() const { return place_; }

  /// A point of the boundary that is not in the disc that is left. \return whether it was in it
  bool offer(const Boundary_place& place, const Xy<double>& q) {
    const Xy<double> way = q - at_.point;
    const double height = dot(way, at_.normal());
    const double square = dot(way, way), least = boundary_.joint_size();
    if (!(height > 0) || square <= least * least) return false;
    const double r = square / (2 * height);
    if (!(r < disc_.radius - limit() / 2) || !(height - square / (2 * disc_.radius) > noise_)) return false;
    disc_ = {at_.point + r * at_.normal(), r};
    place_ = place;
    return is_found_ = true;
  }

 private:
  // How deep in the disc a point is for certain, of the resolution. Beside p rounding puts points of a wall that turns
  // away into it, and so does what a wall is off by where it is seen without hidden turns.
  static constexpr double NOISE = 0x1p-4;

  [[nodiscard]] double limit() const { return (std::max)(resolution_ + 0x1p-47 * disc_.radius, noise_); }
  [[nodiscard]] double inner() const { return disc_.radius - limit(); }
  // What is nearer to the center than that is in the disc; fat arcs tell no more.
  [[nodiscard]] double inner(std::uint32_t segment) const {
    return disc_.radius - (std::max)(limit(), distance_resolution(curves_.error(segment), disc_.radius));
  }

  // What is farther than that may be in the disc by the errors of its fat arc alone, however short it is.
  [[nodiscard]] double inner_of_arcs(std::uint32_t segment) const {
    return disc_.radius - limit() - distance_resolution(curves_.error(segment), disc_.radius);
  }

  void look_at(std::uint32_t e, double u0, double u1) {
    const Boundary_element& element = boundary_.element(e);
    if (element.is_corner) {
      if (offer({e, u0}, element.point)) place_.u = std::clamp(angle_to_center(e), u0, u1);
      return;
    }
    if (u0 == element.first && u1 == element.last)
      return refine(e, curves_.piece(element.segment), curves_.region(element.segment));
    const Spiral_piece_2 piece = boundary_.piece(e, u0, u1);
    if (u0 < u1) refine(e, piece, curves_.region(piece));
    else offer_sample(e, piece.first);
  }
  // The disc touches a corner in the direction of its center, as far as the corner counts.
  [[nodiscard]] double angle_to_center(std::uint32_t e) const {
    return boundary_.angle_of(e, disc_.center - boundary_.element(e).point);
  }
  // One point may be of several elements: next to a corner, or as rounding has it, of the corner, and of both sides of
  // a curve that one which has the center on its left.
  void choose_element() {
    const Xy<double> at = boundary_(place_).point;
    const std::uint32_t e = place_.element, back = boundary_.back_of(e);
    double least = std::numeric_limits<double>::infinity();
    for (const std::uint32_t side : {e, back}) {
      if (side == Axis_boundary::NONE) continue;
      for (const std::uint32_t corner : {side, boundary_.after(side), boundary_.before(side)}) {
        const Boundary_element& element = boundary_.element(corner);
        if (!element.is_corner || euclidean_norm(at - element.point) > boundary_.joint_size()) continue;
        const double angle = angle_to_center(corner);
        ranges_(corner, [&](double u0, double u1) {
          const double u = std::clamp(angle, u0, u1);
          if (std::fabs(u - angle) < least) place_ = {corner, u}, least = std::fabs(u - angle);
        });
      }
    }
    if (std::isfinite(least) || back == Axis_boundary::NONE) return;
    if (!(dot(disc_.center - at, boundary_(place_).normal()) < 0)) return;
    const double u = -place_.u;
    ranges_(back, [&](double u0, double u1) {
      if (u0 <= u && u <= u1) place_ = {back, u};
    });
  }
  bool offer_sample(std::uint32_t e, const Spiral_sample& s) { return offer(boundary_.place(e, s.t), s.point); }

  void refine(std::uint32_t e, const Spiral_piece_2& piece, const Fat_arc_2& fat) {
    constexpr int MOST_ROUNDS = 40;  // each takes more than the resolution off
    for (int round = 0; round < MOST_ROUNDS; ++round) {
      if (!(distance_bounds(disc_.center, fat).lower < inner(piece.segment))) return;
      const Foot_convexity f = foot_convexity(disc_.center, piece, curves_.error(piece.segment));
      if (f.is_rising || f.is_falling) {  // an end is nearest, from this center
        if (!offer_sample(e, f.is_rising ? piece.first : piece.last)) return;
        continue;
      }
      constexpr double LEAST = 0x1p-6;
      if (!(f.least >= LEAST)) break;
      const Foot foot(curves_, disc_.center, piece, f.least, inner());
      if (foot.outcome == Foot::Outcome::TOO_FAR) return;
      if (foot.outcome != Foot::Outcome::FOUND) break;
      const Xy<double> q = curves_.evaluator(curves_.bezier_of(piece.segment))(foot.better_t).point;
      if (!offer(boundary_.place(e, foot.better_t), q)) return;
    }
    const auto parts = halves(curves_, piece);
    if (!parts) {
      offer_sample(e, piece.first);
      return;
    }
    // along the disc, where very many halves are near it: they would tell no more of what is less than can be told
    constexpr int MANY = 256;
    if (++halved_ > MANY && distance_bounds(disc_.center, fat).lower >= inner_of_arcs(piece.segment)) {
      bool is_in = false;
      for (const Spiral_sample* s : {&piece.first, &parts->first.last, &piece.last})
        if (euclidean_norm(s->point - disc_.center) < inner()) is_in = offer_sample(e, *s) || is_in;
      if (!is_in) return;
    }
    const Fat_arc_2 fat0 = curves_.region(parts->first), fat1 = curves_.region(parts->second);
    offer_sample(e, parts->first.last);
    const bool is_first_nearer = distance_bounds(disc_.center, fat0).lower < distance_bounds(disc_.center, fat1).lower;
    if (is_first_nearer) refine(e, parts->first, fat0);
    refine(e, parts->second, fat1);
    if (!is_first_nearer) refine(e, parts->first, fat0);
  }

  const Axis_boundary& boundary_;
  const Segment_hierarchy& curves_;
  const Ranges& ranges_;
  Boundary_jet at_;
  Touching_disc disc_;
  double resolution_, noise_;
  Boundary_place place_;
  int halved_ = 0;
  bool is_found_ = false;
};

// The disc that touches many points at once, as far as one does.
//
// Where discs differ by rounding only, any three of their touches make another disc. Where touches are close to each
// other, the center errs by the rounding over the square of their angle.  All touches together tell the disc better:
// least squares of |center - point| - radius, by Gauss and Newton.

/// The length by which a disc misses the worst of some points.
[[nodiscard]] inline double most_gap(const Touching_disc& disc, const std::vector<Xy<double>>& points) {
  double most = 0;
  for (const Xy<double>& p : points) most = (std::max)(most, disc.gap(p));
  return most;
}

/// \param good a disc that misses no point by more is kept as it is
/// \return the disc that was given where none is better
[[nodiscard]] inline Touching_disc fitted(const Touching_disc& disc, const std::vector<Xy<double>>& points,
                                          double good) {
  constexpr int MOST_STEPS = 4;
  Touching_disc best = disc;
  double gap = most_gap(disc, points);
  const double count = static_cast<double>(points.size());
  for (int step = 0; step < MOST_STEPS && gap > good; ++step) {
    std::vector<Xy<double>> direction;
    std::vector<double> distance;
    Xy<double> mean{0, 0};
    double mean_distance = 0;
    for (const Xy<double>& p : points) {
      const Xy<double> way = best.center - p;
      distance.push_back(euclidean_norm(way));
      if (!(distance.back() > 0)) return best;
      direction.push_back((1 / distance.back()) * way);
      mean = mean + (1 / count) * direction.back();
      mean_distance += (distance.back() - best.radius) / count;
    }
    // without the radius, which is the mean distance: direction.change = -distance, both less their means
    double xx = 0, xy = 0, yy = 0;
    Xy<double> right{0, 0};
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Xy<double> d = direction[i] - mean;
      const double f = distance[i] - best.radius - mean_distance;
      xx += d.x * d.x, xy += d.x * d.y, yy += d.y * d.y;
      right = right - f * d;
    }
    const double determinant = xx * yy - xy * xy;
    if (!(determinant > 0)) return best;
    const Xy<double> change{(right.x * yy - right.y * xy) / determinant, (right.y * xx - right.x * xy) / determinant};
    const Touching_disc next{best.center + change, best.radius + mean_distance + dot(mean, change)};
    const double next_gap = most_gap(next, points);
    if (!(next_gap < gap)) return best;
    best = next, gap = next_gap;
  }
  return best;
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
