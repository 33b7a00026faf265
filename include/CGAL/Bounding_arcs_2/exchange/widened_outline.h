// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A region in doubles moved outward: an outline of arcs and segments that the exact curve does not leave.
//
//        ____________________        Both sides are moved along their normals by s, with the bulges that they have,
//       |   _____________    |       and lengthened along their tangents by s; segments join their ends. Where two
//       |  (    region    )  | s     arcs of a side meet, the moved ones meet on the bisector of their normals.
//       |___________________ |
//
// Let w be the widening, e an ulp of the largest coordinate, s = 2 (w + 8 e). Moved arcs are concentric to the old ones
// but for two things. A joint with normals at an angle 2 x lies s tan x along the tangent from where its arcs would
// end; an arc with half its turning angle phi is turned by that, and comes nearer by at most s tan x sin phi. As a
// spiral turns by at most 90 degrees, x <= 45 degrees - phi, and tan x sin phi < 0.18. Points are rounded by 2 e, which
// moves arcs by at most 6 e. What is left is 0.82 s - 6 e > w + 8 e. The distance of an end of the region from the
// segment that joins the sides beside it is at least s, less 2 e. No point is farther from the region than a corner,
// sqrt(2) s < 2 s. Arcs of radius s or less could not be moved inward: see the code.

#ifndef CGAL_BOUNDING_ARCS_2_EXCHANGE_WIDENED_OUTLINE_H
#define CGAL_BOUNDING_ARCS_2_EXCHANGE_WIDENED_OUTLINE_H

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/number/number_types.h>
#include <CGAL/Bounding_arcs_2/number/stable_norm.h>
#include <CGAL/Bounding_arcs_2/region/Arc_region_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

// One side of a region as arcs, and moved along its normals.

namespace CGAL::Bounding_arcs::internal {

using Arc_side = std::vector<Arc_2>;

[[nodiscard]] inline Arc_side arcs_of(const Arc_region_2& region, const Arc_region_2::Side& side) {
  if (side.size == 1) return {{region.from, region.to, side.bulges[0]}};
  return {{region.from, side.joint, side.bulges[0]}, {side.joint, region.to, side.bulges[1]}};
}

/// A side moved to its left by s, or with s < 0 to its right, and lengthened at both ends.
[[nodiscard]] inline Arc_side moved(const Arc_side& side, double s) {
  Arc_side result;
  const Arc_2 &first = side.front(), &last = side.back();
  Xy<double> at = first.from + s * normal(first, 0);
  result.push_back({at - std::fabs(s) * tangent(first, 0), at, 0});
  for (std::size_t i = 0; i < side.size(); ++i) {
    const Xy<double> n = normal(side[i], 1), m = i + 1 < side.size() ? normal(side[i + 1], 0) : n;
    const Xy<double> to = side[i].to + (s / (1 + dot(n, m))) * (n + m);
    result.push_back({at, to, side[i].bulge});
    at = to;
  }
  result.push_back({at, at + std::fabs(s) * tangent(last, 1), 0});
  return result;
}

[[nodiscard]] inline double shortest_chord(const Arc_side& side) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const Arc_2& arc : side) shortest = (std::min)(shortest, euclidean_norm(arc.to - arc.from));
  return shortest;
}

}  // namespace CGAL::Bounding_arcs::internal

namespace CGAL::Bounding_arcs {

/// A closed chain of arcs around a region.
struct Widened_outline {
  std::vector<Arc_2> arcs;  ///< closed, counterclockwise
  double reach;             ///< no point of it is farther from the region
};

namespace internal {
/// A box around the sides and all points within s of it.
[[nodiscard]] inline Widened_outline box_around(const std::vector<std::vector<Arc_2>>& sides, double s) {
  CGAL::Bbox_2 all;
  for (const std::vector<Arc_2>& side : sides)
    for (const Arc_2& arc : side) all += box(arc);
  const double x0 = all.xmin() - s, y0 = all.ymin() - s, x1 = all.xmax() + s, y1 = all.ymax() + s;
  const Xy<double> corners[] = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
  Widened_outline outline{{}, stable_norm(Xy<double>{x1 - x0, y1 - y0})};
  for (int i = 0; i < 4; ++i) outline.arcs.push_back({corners[i], corners[(i + 1) % 4], 0});
  return outline;
}
}  // namespace internal

/// An outline around the region and all points within its widening of it, so around the exact curve.
/// \return beside it how far it reaches: 4 widenings and 32 ulp of the coordinates. It is 18 times as much where a side
///   has two arcs and one is no longer than 4 times that. Around a region no longer than 4 times its reach it is a
///   box's diagonal
/// \pre the region turns by at most 90 degrees, as those of spirals do
/// \throws std::invalid_argument if the region's widening is not known
/// \guarantee certified
[[nodiscard]] inline Widened_outline widened_outline(const Arc_region_2& region) {
  if (!std::isfinite(region.widening))
    throw std::invalid_argument(expected("region", "a known widening", region.widening));
  constexpr double ROUNDING = 8, ROOM = 2, SHORT = 8;
  std::vector<internal::Arc_side> sides = {internal::arcs_of(region, region.inner),
                                           internal::arcs_of(region, region.outer)};
  double size = 0, turn = 0;
  for (const internal::Arc_side& side : sides)
    for (const Arc_2& arc : side) {
      for (const double x : {arc.from.x, arc.from.y, arc.to.x, arc.to.y}) size = (std::max)(size, std::fabs(x));
      turn += arc.bulge;
    }
  double s = ROOM * (region.widening + ROUNDING * ulp_of(size));
  // An arc that short is left out: the other one of its side leads to the end, at most SHORT s beside where it was.
  for (internal::Arc_side& side : sides)
    if (side.size() == 2 && internal::shortest_chord(side) <= SHORT * s) {
      const auto length = [](const Arc_2& arc) { return euclidean_norm(arc.to - arc.from); };
      side = {{region.from, region.to, side[length(side[0]) < length(side[1]) ? 1 : 0].bulge}};
      s *= 2 + 2 * SHORT;
    }
  if (euclidean_norm(region.to - region.from) <= SHORT * s) return internal::box_around(sides, s);
  const int left = turn < 0 ? 1 : 0;  // the inner side is on the left of what turns left
  Widened_outline outline{internal::moved(sides[static_cast<std::size_t>(1 - left)], -s), 2 * s};
  const internal::Arc_side back = internal::moved(sides[static_cast<std::size_t>(left)], s);
  const Xy<double> start = outline.arcs.front().from;
  outline.arcs.push_back({outline.arcs.back().to, back.back().to, 0});
  for (auto arc = back.rbegin(); arc != back.rend(); ++arc) outline.arcs.push_back({arc->to, arc->from, -arc->bulge});
  outline.arcs.push_back({back.front().from, start, 0});
  return outline;
}

}  // namespace CGAL::Bounding_arcs

#endif
