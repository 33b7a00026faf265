// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What bounds the regions of an axis: parts of the curves of a drawing, which may cross.  An axis is made of these
// alone, and its places are those of the curves.

#ifndef BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_BOUNDING_PARTS_H
#define BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_BOUNDING_PARTS_H

#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>
#include "../tree/Segment_hierarchy.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// A segment in its direction or against it.
struct Directed_segment {
  std::uint32_t segment = 0;
  bool is_reversed = false;
  /// Sides of segments are numbered through.
  [[nodiscard]] std::uint32_t side() const { return 2 * segment + (is_reversed ? 1 : 0); }
};

/// A closed way along parts of curves, with a region on its left.
struct Bounding_ring {
  std::vector<Directed_segment> way;
  bool is_outer = true;  ///< the region is within it
};

}  // namespace CGAL::Bounding_arcs::internal

namespace CGAL::Bounding_arcs {

/// Parts of curves that bound regions, and the rings that they make.
struct Bounding_parts {
  Segment_hierarchy segments;                  ///< the parts, in the order of the curves
  std::vector<internal::Bounding_ring> rings;  ///< a wall has its two sides in them
  std::vector<std::uint32_t> left_out;         ///< curves that bound nothing
  double moved = 0;                            ///< how far ends of parts may be from those of the next ones in rings
  std::optional<Xy<double>> undecided;         ///< where doubles leave open how curves meet; then there is nothing else
  std::vector<std::uint32_t> joints{};  ///< a number for each end, 2 segment + (1 at its last one): the same in a joint

  /// Numbers joints: ends with one label are one, and where a ring goes on from a segment to the next both have one.
  /// \param labels by end; NO_LABEL of those without
  void number_joints(const std::vector<std::uint32_t>& labels);
  static constexpr std::uint32_t NO_LABEL = static_cast<std::uint32_t>(-1);
};

}  // namespace CGAL::Bounding_arcs

namespace CGAL::Bounding_arcs::internal {

[[nodiscard]] inline Xy<double> point_at(const Segment_hierarchy& curves, const Curve_place& p) {
  return curves.evaluator(curves.number_of_bezier(p.curve, p.bezier))(p.t).point;
}

/// How close walls are, in sizes, that meet: the axis is that of a drawing in which they do.
inline constexpr double CLOSE_WALLS = 0x1p-42;

/// \param close how close walls are that meet
/// \complexity that of all intersections, n log n otherwise
[[nodiscard]] Bounding_parts bounding_parts(const Segment_hierarchy& curves, const Medial_axis_2::Options& options,
                                            double close);

/// What bounds the regions of an axis of curves: what it was made of, or, of one that was read, that once more.
[[nodiscard]] std::shared_ptr<const Bounding_parts> bounds_of(const Medial_axis_2& axis,
                                                              const Segment_hierarchy& curves);

// Walls that are nearer to each other than a drawing is told: ends that miss each other, circles that touch but for
// rounding, arcs that run beside each other.  There the axis is that of a drawing in which they meet.
//
//   close walls -> cuts where they come near and part -> equal ends are one joint -> equal walls are one -> rings

/// Places on two segments that are to be one.
struct Wall_contact {
  std::uint32_t a, b;
  double s, t;  ///< parameters
};

/// Returns contacts of segments that are no farther from each other than a length, or hardly.
///
/// A stretch of one along which another is close has a contact at each of its ends, or, where both go on beyond it on
/// either side, one in its middle: they touch. Two that share a joint are close beside it, whatever the angle: that is
/// a corner. They are one only where one of them ends beside the other.
/// \complexity n log n in the number of segments, and some hundred steps a contact
[[nodiscard]] std::vector<Wall_contact> wall_contacts(const Bounding_parts& parts, double close);

/// How often what is filled winds round points beside a wall.
struct Side_windings {
  int left = 0, right = 0;
};

/// Joins walls that are closer than that to each other.
/// \param windings by segment
/// \param is_inside of a winding number
/// \param winding_at what winds round a point on no wall
/// \return the same parts where none are that close
[[nodiscard]] Bounding_parts with_close_walls_joined(Bounding_parts parts, const std::vector<Side_windings>& windings,
                                                     const std::function<bool(int)>& is_inside,
                                                     const std::function<int(const Xy<double>&)>& winding_at,
                                                     double close);

}  // namespace CGAL::Bounding_arcs::internal

#endif
