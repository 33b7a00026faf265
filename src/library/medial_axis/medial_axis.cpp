// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of medial_axis/medial_axis.h.
//
//   curves -> parts that bound regions -> boundary of segments and corners -> parts between discs -> vertices and edges

#include <CGAL/Bounding_arcs_2/curve/Unit.h>
#include <CGAL/Bounding_arcs_2/medial_axis/framed.h>
#include <CGAL/Bounding_arcs_2/medial_axis/internal/axis_search.h>
#include <CGAL/Bounding_arcs_2/medial_axis/internal/axis_units.h>
#include <CGAL/Bounding_arcs_2/medial_axis/medial_axis.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/query/point_location.h>
#include "../tree/Segment_hierarchy.h"
#include "Axis_builder.h"
#include "Bounding_parts.h"
#include "check_discs.h"
#include "make_axis_boundary.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <random>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

namespace {

[[nodiscard]] Medial_axis_2 axis_of(const Bounding_parts& parts, const Axis_job& job) {
  const Axis_boundary boundary = axis_boundary(parts);
  constexpr double LEAST = 0x1p-36;  // of the size: a finer polyline would be of roundings, and endless
  const double eps = (std::max)(job.eps, LEAST * boundary.size());
  const auto made = [&](bool is_joining) {
    Medial_axis_2 axis = Axis_builder(boundary, eps, is_joining, job.loop).build();
    axis.eps = eps;
    check_discs(parts.segments, boundary, job.loop, axis);
    return axis;
  };
  Medial_axis_2 axis = made(false);
  const auto is_good = [](const Medial_axis_2& a) { return a.status == Medial_axis_status::COMPLETE; };
  constexpr double ROOM = 8;  // times the resolution: vertices miss what they touch by less
  const double miss = most_miss(parts.segments, axis);
  if (is_good(axis) && miss <= ROOM * boundary.resolution() + parts.moved) return axis;
  // nearly equal discs were told apart by rounding
  Medial_axis_2 joined = made(true);
  const bool is_better = is_good(joined) && (!is_good(axis) || most_miss(parts.segments, joined) < miss);
  return is_better ? joined : axis;
}

/// The axis, with what it was made of.
/// \param close how close walls are that meet
[[nodiscard]] Medial_axis_2 bounded_axis(const Segment_hierarchy& curves, const Axis_job& job, double close) {
  const auto bounds = std::make_shared<const Bounding_parts>(bounding_parts(curves, job, close));
  Medial_axis_2 axis = axis_of(*bounds, job);
  axis.moved = bounds->moved;
  if (bounds->undecided) {
    axis.status = Medial_axis_status::UNRESOLVED;
    axis.unresolved = {*bounds->undecided};
  }
  axis.left_out = bounds->left_out;
  axis.options = job;
  axis.bounds = bounds;
  return axis;
}

/// How curves are moved, in sizes.
struct Move {
  double by, close;       // the latter is how close walls are that meet
  bool are_bent = false;  // inner control points have ways of their own
};

/// Each curve elsewhere, in a direction of its own.
[[nodiscard]] Segment_hierarchy moved_curves(const Segment_hierarchy& curves, const Move& move, double size,
                                             std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto way = [&] {
    const auto share = [&] { return 2 * (static_cast<double>(random()) / std::mt19937::max()) - 1; };
    const double x = move.by * size * share();
    return Xy<double>{x, move.by * size * share()};
  };
  Drawing_2<double> drawing;
  for (const auto& curve : curves.drawing().curves()) {
    const Xy<double> of_curve = way();
    std::vector<Bezier_curve_2<double>> beziers;
    for (const auto& b : curve.beziers) {
      std::vector<Xy<double>> points = b.control_points();
      for (std::size_t i = 0; i < points.size(); ++i)
        points[i] = points[i] + (move.are_bent && i > 0 && i + 1 < points.size() ? way() : of_curve);
      beziers.emplace_back(std::move(points), b.weights());
    }
    drawing.add(std::move(beziers), curve.name);
  }
  return {std::make_shared<const Drawing_2<double>>(std::move(drawing)), curves.decisions()};
}

/// Where rounding left discs open, the axis is that of curves that are moved by less than is told of it: what met at
/// one place by chance, or by symmetry, meets there no more. Small moves keep close walls joined, larger ones part
/// them.
[[nodiscard]] Medial_axis_2 resolved_axis(const Segment_hierarchy& curves, const Axis_job& job) {
  constexpr Move MOVES[] = {
      {0x1p-43, CLOSE_WALLS}, {0x1p-42, 0x1p-43}, {0x1p-42, CLOSE_WALLS}, {0x1p-42, CLOSE_WALLS, true}};
  constexpr std::size_t KINDS = sizeof(MOVES) / sizeof(*MOVES), FEW = 4, MANY = 64, SEGMENTS = 1 << 14;  // of all tries
  const std::size_t tries =
      std::clamp(SEGMENTS / (std::max)(std::size_t{1}, std::size_t{curves.number_of_segments()}), FEW, MANY);
  const auto is_good = [](const Medial_axis_2& a) { return a.status == Medial_axis_status::COMPLETE; };
  const double size = coordinate_size(curves.drawing());
  Medial_axis_2 axis = bounded_axis(curves, job, CLOSE_WALLS * size);
  for (std::uint32_t seed = 0; seed < tries && !is_good(axis) && !axis.bounds->undecided; ++seed) {
    const Move& move = MOVES[seed % KINDS];
    Medial_axis_2 moved = bounded_axis(moved_curves(curves, move, size, seed), job, move.close * size);
    constexpr double MOST = 0x1p-40, OF_SQUARE = 1.5;  // half its diagonal, with what rounding adds
    moved.moved += OF_SQUARE * move.by * size;
    if (is_good(moved) && moved.moved <= MOST * size) axis = std::move(moved);
  }
  return axis;
}

}  // namespace

Medial_axis_2 medial_axis(const Bounding_arc_tree_2& curves, const Axis_job& job) {
  check_above_zero("eps", job.eps);
  if (job.is_framed) check_frame(curves.drawing());
  else check_closed(curves.drawing());
  Axis_job in_unit = job;
  in_unit.eps = curves.unit().tolerance_in(job.eps);
  Medial_axis_2 axis = out(curves.unit(), resolved_axis(curves.in_unit(), in_unit));
  axis.options = job;
  return axis;
}

}  // namespace CGAL::Bounding_arcs::internal
