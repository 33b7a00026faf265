// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// On which sides of curves an axis has a region, for its check: by winding numbers of its own.

#ifndef BOUNDING_ARCS_LIBRARY_VERIFY_CURVE_SIDES_H
#define BOUNDING_ARCS_LIBRARY_VERIFY_CURVE_SIDES_H

#include <CGAL/Bounding_arcs_2/number/stable_norm.h>
#include <CGAL/Bounding_arcs_2/verify/verify_axis.h>
#include "Axis_checker_curves.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Bounding_arcs::verify {

struct Curve_sides {
  bool left, right;
};

[[nodiscard]] inline bool is_a_point(const Bezier_curve_2<double>& b) {
  const auto& p = b.control_points();
  return std::all_of(p.begin(), p.end(), [&](const Xy<double>& q) { return q == p.front(); });
}

/// What is filled next to the middle of the piece whose ends are farthest apart.
/// \param is_in tells of a winding number whether points with it are inside
template <class Is_in>
[[nodiscard]] Curve_sides filled_sides(const std::vector<Bezier_curve_2<double>>& pieces, const Curves_in_boxes& boxes,
                                       const Is_in& is_in) {
  const auto way = [](const Bezier_curve_2<double>& b) {
    return stable_norm(b.control_points().back() - b.control_points().front());
  };
  const auto longest = std::max_element(
      pieces.begin(), pieces.end(),
      [&](const Bezier_curve_2<double>& a, const Bezier_curve_2<double>& b) { return way(a) < way(b); });
  const Checked_point p = point_at(*longest, 0.5);
  const Xy<double> at{CGAL::to_double(p.point.x), CGAL::to_double(p.point.y)},
      tangent{CGAL::to_double(p.derivative.x), CGAL::to_double(p.derivative.y)};
  const double step = 0x1p-30 * boxes.size() / stable_norm(tangent);
  const auto is_inside = [&](double s) { return is_in(boxes.winding_number(at + s * perp(tangent))); };
  return {is_inside(step), is_inside(-step)};
}

/// The sides of each curve that discs touch from: in a frame both. Without one a curve with both sides filled bounds
/// nothing.
[[nodiscard]] inline std::vector<Curve_sides> sides_of_curves(const Drawing_2<double>& drawing,
                                                              const Axis_check_options& options) {
  const Curves_in_boxes boxes(drawing);
  const CGAL::Protect_FPU_rounding<true> protection;
  const std::size_t count = drawing.curves().size();
  std::vector<Curve_sides> result(count, {false, false});
  for (std::size_t i = 0; i < count; ++i) {
    const auto& pieces = drawing.curves()[i].beziers;
    const bool is_frame = options.is_framed && i + 1 == count;
    if (pieces.size() == 1 && is_a_point(pieces.front())) continue;
    if (is_frame) result[i] = filled_sides(pieces, boxes, [](int number) { return number != 0; });
    else if (options.is_framed) result[i] = {true, true};
    else {
      const Curve_sides filled =
          filled_sides(pieces, boxes, [&](int number) { return is_filled(options.rule, number); });
      if (!(filled.left && filled.right)) result[i] = filled;
    }
  }
  return result;
}

/// The curves that discs may touch. Points are among them.
[[nodiscard]] inline Drawing_2<double> with_a_side(const Drawing_2<double>& drawing,
                                                   const std::vector<Curve_sides>& sides) {
  Drawing_2<double> result;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const auto& pieces = drawing.curves()[i].beziers;
    const bool is_point = pieces.size() == 1 && is_a_point(pieces.front());
    if (is_point || sides[i].left || sides[i].right) result.add(pieces);
  }
  return result;
}

}  // namespace CGAL::Bounding_arcs::verify

#endif
