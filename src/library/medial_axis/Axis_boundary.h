// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The boundary of regions as what discs from inside touch: rings of elements, each run through with the region on its
// left.  An element is a spiral segment, or the corner between two where discs may touch from a range of directions (a
// reflex corner).
//
//   segment: u = t or, where the curve runs the other way, u = -t
//   corner:  u = the angle by which the tangent has turned clockwise
//
// An open curve is one ring, which runs along its left side, round its end, which is a corner of half a turn, back
// along its right side and round its start.  A point is a ring of one corner, of a whole turn.

#ifndef BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_AXIS_BOUNDARY_H
#define BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_AXIS_BOUNDARY_H

#include "../tree/Segment_hierarchy.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

struct Boundary_element {
  std::uint32_t segment;  ///< of a corner the one before it, or the point
  std::uint32_t ring;
  bool is_corner, is_reversed;
  double first, last;             ///< u; first < last
  Xy<double> point{}, tangent{};  ///< of a corner, at u = 0
};

/// A place on the boundary.
struct Boundary_place {
  std::uint32_t element = 0;
  double u = 0;
};

/// What discs need of a place: the region is to the left of the tangent.
struct Boundary_jet {
  Xy<double> point, tangent;
  double speed;  ///< |dC/du|, 0 at a corner
  double turn;   ///< by what angle the tangent turns for du, to the left
  [[nodiscard]] Xy<double> normal() const { return perp(tangent); }
};

struct Boundary_ring {
  std::uint32_t begin, end;  ///< elements, in order
  bool is_outer;             ///< runs counterclockwise: the region is within it
};

class Axis_boundary {
 public:
  static constexpr std::uint32_t NONE = static_cast<std::uint32_t>(-1);

  explicit Axis_boundary(const Segment_hierarchy& curves) : curves_(curves), of_segment_(curves.number_of_segments()) {
    for (std::uint32_t i = 0; i < curves.number_of_beziers(); ++i)
      size_ = (std::max)(size_, curves.evaluator(i).coordinate_size());
  }

  [[nodiscard]] const Segment_hierarchy& curves() const { return curves_; }
  [[nodiscard]] const std::vector<Boundary_element>& elements() const { return elements_; }
  [[nodiscard]] const Boundary_element& element(std::uint32_t i) const { return elements_[i]; }
  [[nodiscard]] const std::vector<Boundary_ring>& rings() const { return rings_; }
  /// The elements that a segment is, one for each side of it that has a region; of a point the corner.
  struct Sides {
    std::uint32_t of[2] = {NONE, NONE};
  };
  [[nodiscard]] const Sides& sides(std::uint32_t segment) const { return of_segment_[segment]; }
  /// What of a segment is on its other side; NONE where no region is, and of corners.
  [[nodiscard]] std::uint32_t back_of(std::uint32_t e) const {
    const Boundary_element& element = elements_[e];
    return element.is_corner ? NONE : of_segment_[element.segment].of[element.is_reversed ? 0 : 1];
  }
  /// The largest |coordinate|.
  [[nodiscard]] double size() const { return size_; }
  /// An upper bound of the radius of any disc within the curves.
  [[nodiscard]] double largest_radius() const {
    if (curves_.empty()) return 0;
    const CGAL::Bbox_2& box = curves_.boxes().box();
    return (box.xmax() - box.xmin()) + (box.ymax() - box.ymin());
  }
  /// Distances that differ by less are not told apart: some tens of roundings of coordinates.
  [[nodiscard]] double resolution() const { return 0x1p-46 * size_; }
  /// Points that are no farther apart may be one joint.
  [[nodiscard]] double joint_size() const { return 4 * resolution(); }

  [[nodiscard]] std::uint32_t after(std::uint32_t e) const {
    const Boundary_ring& r = rings_[elements_[e].ring];
    return e + 1 == r.end ? r.begin : e + 1;
  }
  [[nodiscard]] std::uint32_t before(std::uint32_t e) const {
    const Boundary_ring& r = rings_[elements_[e].ring];
    return e == r.begin ? r.end - 1 : e - 1;
  }

  [[nodiscard]] double parameter(const Boundary_place& p) const {
    return elements_[p.element].is_reversed ? -p.u : p.u;
  }
  /// The angle by which the tangent of a corner has turned when its normal points in a direction, next to the corner's
  /// range.
  [[nodiscard]] double angle_of(std::uint32_t corner, const Xy<double>& direction) const {
    const Boundary_element& e = elements_[corner];
    const double middle = 0.5 * (e.first + e.last), c = std::cos(middle), s = std::sin(middle);
    const Xy<double> tangent{c * e.tangent.x + s * e.tangent.y, c * e.tangent.y - s * e.tangent.x};
    return middle + std::atan2(dot(direction, tangent), cross(tangent, direction));
  }

  /// The place of a point of a segment on one of its elements.
  [[nodiscard]] Boundary_place place(std::uint32_t element, double t) const {
    return {element, elements_[element].is_reversed ? -t : t};
  }
  [[nodiscard]] Curve_place curve_place(const Boundary_place& p) const {
    const Boundary_element& e = elements_[p.element];
    const double t = e.is_corner ? (e.is_reversed ? curves_.piece(e.segment).first.t : curves_.piece(e.segment).last.t)
                                 : parameter(p);
    return curves_.place_at(e.segment, t);
  }

  [[nodiscard]] Boundary_jet operator()(const Boundary_place& p) const {
    const Boundary_element& e = elements_[p.element];
    if (e.is_corner) {
      const double c = std::cos(p.u), s = std::sin(p.u);
      return {e.point, {c * e.tangent.x + s * e.tangent.y, c * e.tangent.y - s * e.tangent.x}, 0, -1};
    }
    const double t = e.is_reversed ? -p.u : p.u, sign = e.is_reversed ? -1 : 1;
    const Curve_jet jet = curves_.evaluator(curves_.bezier_of(e.segment))(t);
    const auto end_tangent = [&](bool is_first) {
      const Spiral_piece_2 piece = curves_.piece(e.segment);
      return is_first ? piece.first.tangent : piece.last.tangent;
    };
    if (curves_.is_straight(e.segment)) {
      const Xy<double> d = end_tangent(true);
      return {jet.point, sign * d, std::fabs(dot(jet.first, d)), 0};
    }
    const double square = dot(jet.first, jet.first), speed = std::sqrt(square);
    const bool is_end = p.u == e.first || p.u == e.last;
    const Xy<double> d = is_end ? end_tangent((p.u == e.first) != e.is_reversed) : (1 / speed) * jet.first;
    return {jet.point, sign * d, speed, square > 0 ? sign * cross(jet.first, jet.second) / square : 0};
  }

  /// Curvature at an end of an element that is no corner, with what it may be wrong by. It is infinite at a cusp, and
  /// where rounding has made something of a cusp that turns within the piece by an unknown amount.
  struct Curvature {
    double value, error;
  };
  [[nodiscard]] Curvature curvature(const Boundary_place& p) const {
    const Boundary_element& e = elements_[p.element];
    if (curves_.is_straight(e.segment)) return {0, 0};
    const Spiral_piece_2 piece = curves_.piece(e.segment);
    const Spiral_sample& s = parameter(p) == piece.first.t ? piece.first : piece.last;
    const double bend = cross(piece.first.tangent, piece.last.tangent) * (e.is_reversed ? -1 : 1);
    const Curvature cusp{std::copysign(std::numeric_limits<double>::infinity(), bend), 0};
    if (!(s.most_curvature < std::numeric_limits<double>::max())) return cusp;
    const Boundary_jet jet = (*this)(p);
    const Curvature result{jet.turn / jet.speed, s.most_curvature - s.least_curvature};
    const double length = euclidean_norm(piece.last.point - piece.first.point);
    return result.error >= std::fabs(result.value) && result.error * length > 1 ? cusp : result;
  }

  void start_ring(bool is_outer) {
    const auto begin = static_cast<std::uint32_t>(elements_.size());
    rings_.push_back({begin, begin, is_outer});
  }
  void add(Boundary_element e) {
    e.ring = static_cast<std::uint32_t>(rings_.size() - 1);
    const auto i = static_cast<std::uint32_t>(elements_.size());
    if (!e.is_corner || rings_.back().begin == i) of_segment_[e.segment].of[e.is_reversed ? 1 : 0] = i;
    elements_.push_back(e);
    rings_.back().end = i + 1;
  }

 private:
  const Segment_hierarchy& curves_;
  std::vector<Boundary_element> elements_;
  std::vector<Boundary_ring> rings_;
  std::vector<Sides> of_segment_;
  double size_ = 0;
};

/// The disc that touches two places from inside, where it touches the second one with the tangent it has there; the
/// radius is that from both normals, p + r n = q + r m, and may be negative.
struct Touching_disc {
  Xy<double> center;
  double radius;
};
[[nodiscard]] inline Touching_disc disc_of(const Boundary_jet& p, const Boundary_jet& q) {
  const Xy<double> way = q.point - p.point, n = p.normal(), m = q.normal(), change = n - m;
  const double square = dot(change, change), r = square > 0 ? dot(way, change) / square : 0;
  return {0.5 * ((p.point + r * n) + (q.point + r * m)), r};
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
