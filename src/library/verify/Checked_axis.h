// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What all steps of a check of an axis know and what they have found so far.

#ifndef BOUNDING_ARCS_LIBRARY_VERIFY_CHECKED_AXIS_H
#define BOUNDING_ARCS_LIBRARY_VERIFY_CHECKED_AXIS_H

#include <CGAL/Bounding_arcs_2/curve/Unit.h>
#include <CGAL/Bounding_arcs_2/number/stable_norm.h>
#include <CGAL/Bounding_arcs_2/verify/verify_axis.h>
#include "Axis_checker_curves.h"
#include "Axis_tiles.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::verify {

[[nodiscard]] inline double distance(const Xy<double>& p, const Xy<double>& q) { return stable_norm(p - q); }
/// By how much a point is beside a circle, at most.
[[nodiscard]] inline double miss_of(const Checked_point& p, const Xy<double>& center, double radius) {
  return most_of(length(checked(center) - p.point) - Checked_number(radius));
}

class Checked_axis {
 public:
  static constexpr double MOST = 0x1p-40;  ///< of the size

  const Drawing_2<double>& curves;
  const Medial_axis_2& axis;
  const Axis_verification::Options& options;
  std::vector<Curve_sides> sides;
  Curves_in_boxes boxes;        ///< of what discs may touch; in a frame that is all, as they are numbered
  double size, moved_by, room;  ///< lengths below the latter are nothing
  Axis_verification result;

  /// Curves and axis have a size near 1.
  Checked_axis(const Drawing_2<double>& of_curves, const Medial_axis_2& of_axis,
               const Axis_verification::Options& with_options)
      : curves(of_curves), axis(of_axis), options(with_options), sides(sides_of_curves(curves, options)),
        boxes(with_a_side(curves, sides)), size(coordinate_size(curves)),
        moved_by(axis.moved > 0 ? (std::min)(axis.moved, MOST * size) : 0), room(MOST * size + moved_by) {}

  void find(Axis_verification::Fault fault, std::string place, double amount = 0) {
    constexpr std::size_t MOST_FINDINGS = 100;
    if (++result.faults <= MOST_FINDINGS) result.findings.push_back({fault, std::move(place), amount});
  }
  [[nodiscard]] const Bezier_curve_2<double>& piece(const Curve_place& p) const { return piece_at(curves, p); }
  [[nodiscard]] Xy<double> point(const Curve_place& p) const { return middle_at(curves, p); }
  /// What is moved by less is told with the bound.
  [[nodiscard]] double small() const {
    constexpr double SHARE = 1.0 / 16;  // of eps
    return (std::max)(room, SHARE * axis.eps);
  }
};

}  // namespace CGAL::Bounding_arcs::verify

#endif
