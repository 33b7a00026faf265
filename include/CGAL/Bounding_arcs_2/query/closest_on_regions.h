// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The nearest point of curves of one's own, of which there are regions but no tree of Bezier pieces.
//
//   boxes over segments -> pieces of segments, halved again and again: those nearest by their regions come first
//
// A piece is enclosed in bounding circular arcs, whatever regions are kept: they tell how near it may be.  Its ends are
// points of the curve, and tell how near it is for certain.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_CLOSEST_ON_REGIONS_H
#define CGAL_BOUNDING_ARCS_2_QUERY_CLOSEST_ON_REGIONS_H

#include <CGAL/Bounding_arcs_2/query/Query_point.h>
#include <CGAL/Bounding_arcs_2/query/kernel_points.h>
#include <CGAL/Bounding_arcs_2/region/region_bounds.h>
#include <CGAL/Bounding_arcs_2/tree/Region_hierarchy_2.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <queue>
#include <type_traits>
#include <vector>

namespace CGAL::Bounding_arcs {

/// A point of a spiral segment and its distance from the point that was asked about.
template <class Point> struct Closest_point<Point>::On_segment {
  Bracket distance;           ///< of the exact curves, as exact as the segments' errors tell
  Point point;                ///< on the curve but for rounding
  std::uint32_t segment = 0;  ///< its number in spirals()
  double t = 0;               ///< its parameter there
  Query_status status = Query_status::COMPLETE;
};

/// Returns the nearest point of the curves that regions are of, one of them where there are several. It is for curves
/// of one's own, which no Bounding_arc_tree_2 takes; that one's closest_point() is faster and tells more.
/// \code
/// const Region_hierarchy_2<Bca_traits_2<Kernel>, Jet_spiral_2<Clothoid>> regions({spiral}, 1e-3);
/// const auto found = closest_point(regions, {1, 1}, 1e-9);
/// \endcode
/// \tparam Point of any kernel
/// \param eps how far the bounds of the distance may be apart, positive. It is not bound to that of the regions
/// \return nothing if there are no segments. RESOLUTION_REACHED where the errors of the segments leave more than eps
/// \guarantee certified, as far as the segments are spirals and their errors hold
/// \complexity some halvings for each digit. Where many points are nearly as near, as of an arc about its center, a
///   piece of each is looked at
/// \throws std::invalid_argument for a point that is no number, and an eps that is not positive
template <class Traits, class Spiral, class Point = Default_kernel::Point_2>
[[nodiscard]] std::optional<typename Closest_point<Point>::On_segment> closest_point(
    const Region_hierarchy_2<Traits, Spiral>& regions, const Point& q, double eps) {
  static_assert(std::is_same_v<typename Traits::FT, double>, "closest_point takes regions over double");
  const Asked_point asked(q);
  internal::check_point(asked.point);
  check_above_zero("eps", eps);
  if (regions.spirals().empty()) return std::nullopt;

  struct Candidate {
    double lower;                    // no point of it is nearer
    std::optional<Node_handle> box;  // else a piece:
    std::uint32_t segment;
    double t0, t1;
    [[nodiscard]] bool operator<(const Candidate& other) const { return lower > other.lower; }  // the nearest on top
  };
  std::priority_queue<Candidate> open;
  Closest_point<>::On_segment best;
  best.distance.upper = std::numeric_limits<double>::infinity();
  double settled = best.distance.upper;  // lower bound of the pieces that cannot be halved
  const auto add_point = [&](const Xy<double>& p, double widening, std::uint32_t segment, double t) {
    const double upper = (euclidean_norm(p - asked.point) + widening + asked.error) * ROUNDED_UP<8>;
    if (upper < best.distance.upper) best = {{0, upper}, p, segment, t};
  };
  const auto add_piece = [&](std::uint32_t segment, double t0, double t1) {
    const Arc_region_2 region = regions.bounding_arcs(segment, t0, t1);
    add_point(region.from, region.widening, segment, t0);
    add_point(region.to, region.widening, segment, t1);
    const double lower = (std::max)(0.0, (distance_bounds(asked.point, region).lower - asked.error) * ROUNDED_DOWN<2>);
    const double middle = t0 + (t1 - t0) / 2;
    const bool is_last = !(t0 < middle && middle < t1) || euclidean_norm(region.to - region.from) <= region.widening;
    if (is_last) settled = (std::min)(settled, lower);
    else if (lower < best.distance.upper) open.push({lower, std::nullopt, segment, t0, t1});
  };
  const auto add_node = [&](const Node_handle& h) {
    if (h.is_region)
      return add_piece(h.spiral, regions.spirals()[h.spiral].first(), regions.spirals()[h.spiral].last());
    const CGAL::Bbox_2 box = regions.box(h);
    const double x = (std::max)({box.xmin() - asked.point.x, asked.point.x - box.xmax(), 0.0}),
                 y = (std::max)({box.ymin() - asked.point.y, asked.point.y - box.ymax(), 0.0});
    const double lower = (euclidean_norm(Xy<double>{x, y}) - asked.error) * ROUNDED_DOWN<8>;
    open.push({(std::max)(0.0, lower), h, 0, 0, 0});
  };
  add_node(regions.root());
  // of an endless eps, too, for which the difference is no number at first
  while (!open.empty() && !(open.top().lower >= best.distance.upper - eps)) {
    const Candidate c = open.top();
    open.pop();
    if (c.box) {
      regions.for_each_child(*c.box, add_node);
      continue;
    }
    const double middle = c.t0 + (c.t1 - c.t0) / 2;
    add_piece(c.segment, c.t0, middle);
    add_piece(c.segment, middle, c.t1);
  }
  best.distance.lower = (std::min)({settled, open.empty() ? settled : open.top().lower, best.distance.upper});
  if (best.distance.width() > eps) best.status = Query_status::RESOLUTION_REACHED;
  return typename Closest_point<Point>::On_segment{best.distance, internal::answered<Point>(best.point), best.segment,
                                                   best.t, best.status};
}

}  // namespace CGAL::Bounding_arcs

#endif
