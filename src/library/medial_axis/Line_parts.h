// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The parts of the boundary that the feet of two discs run along, for proofs.

#ifndef BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_LINE_PARTS_H
#define BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_LINE_PARTS_H

#include "Axis_lines.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace CGAL::Bounding_arcs::internal {

/// A part of the boundary in its direction: a fat arc, or a point, and samples at both ends.
struct Line_part {
  bool is_point = false, is_left = false;
  std::uint32_t segment = 0;
  Fat_arc_2 fat{};
  Spiral_sample begin, end;
  double error = 0;  ///< of its points
  [[nodiscard]] const Spiral_sample& at(bool is_first) const { return is_first != is_left ? begin : end; }
};

/// What an arc's circle is from a place on the arc's left: the distance, its gradient, and the curvature of the circle
/// about the arc's center through the place.
struct Arc_sight {
  double distance;
  Xy<double> gradient;
  double curvature;
};
/// \param arc a point where both ends are equal
[[nodiscard]] inline Arc_sight sight(const Xy<double>& q, const Arc_2& arc) {
  if (arc.from == arc.to) {
    const Xy<double> way = q - arc.from;
    const double d = euclidean_norm(way);
    return {d, (1 / d) * way, -1 / d};
  }
  const double b = arc.bulge;
  const Arc_view v = view(q, arc);
  return {2 * v.side / ((1 + b * b) * v.chord + v.apart), (-1 / v.apart) * v.w, 4 * b / v.apart};
}

class Line_parts {
 public:
  Line_parts(const Segment_hierarchy& curves, double size) : curves_(curves), size_(size) {
    for (std::uint32_t i = 0; i < curves.number_of_segments(); ++i) error_ = (std::max)(error_, curves.error(i));
  }
  static constexpr double UNBOUNDED = std::numeric_limits<double>::infinity();

  [[nodiscard]] double size() const { return size_; }
  /// The error of any point.
  [[nodiscard]] double error() const { return error_; }

  [[nodiscard]] Line_part part(const Foot_run& run, bool is_left) const {
    Line_part p;
    p.is_left = is_left, p.is_point = run.is_point, p.segment = run.segment;
    if (run.is_point) {
      p.begin.point = p.end.point = p.fat.arc.from = p.fat.arc.to = run.point;
      p.fat.radius = 8 * HALF_ULP * size_;
      return p;
    }
    const bool is_growing = run.is_growing() != is_left;
    const double begin = is_left ? run.to : run.from, end = is_left ? run.from : run.to;
    p.error = curves_.error(run.segment);
    p.begin = sample(run.segment, begin), p.end = sample(run.segment, end);
    p.fat = curves_.region(is_growing ? Spiral_piece_2{run.segment, p.begin, p.end}
                                      : Spiral_piece_2{run.segment, p.end, p.begin});
    if (!is_growing) {
      p.fat.arc = reversed(p.fat.arc);
      p.begin.tangent = -p.begin.tangent, p.end.tangent = -p.end.tangent;
    }
    // a piece that is hardly longer than the error
    if (p.fat.radius >= euclidean_norm(p.fat.arc.to - p.fat.arc.from)) {
      p.is_point = true;
      p.fat.arc.from = p.fat.arc.to = 0.5 * (p.begin.point + p.end.point);
    }
    return p;
  }
  [[nodiscard]] Spiral_sample sample(std::uint32_t segment, double t) const {
    const Spiral_piece_2 piece = curves_.piece(segment);
    return t == piece.first.t ? piece.first : (t == piece.last.t ? piece.last : curves_.sample(segment, t));
  }

 private:
  const Segment_hierarchy& curves_;
  double size_, error_ = 0;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
