// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a region in hand tells of the exact curve in it: box, tangents, distances from points and from other curves.
// All enclose the truth, with the region's widening and their own rounding.
//
// Other regions.  A disc that meets both sides holds a path within the region from one to the other, which meets the
// curve: the side nearer the chord and the chord bound a convex set, and so do the other side and the chord.  So the
// curve is no farther than the farther side, and for points outside the region no nearer than the nearer one.

#ifndef CGAL_BOUNDING_ARCS_2_REGION_REGION_BOUNDS_H
#define CGAL_BOUNDING_ARCS_2_REGION_REGION_BOUNDS_H

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>
#include <CGAL/Bounding_arcs_2/region/Arc_region_2.h>
#include <CGAL/Bounding_arcs_2/region/Fat_arc_2.h>
#include <CGAL/Bounding_arcs_2/region/box_between.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace CGAL::Bounding_arcs {

/// Arc i of a side.
[[nodiscard]] inline Arc_2 arc_of(const Arc_region_2& region, const Arc_region_2::Side& side, std::size_t i) {
  return {i == 0 ? region.from : side.joint, i + 1 == side.size ? region.to : side.joint, side.bulges[i]};
}

namespace internal {
/// 1 where the region turns left, -1 to the right: its outer side lies on the other side of the chord.
[[nodiscard]] inline double turn_of(const Arc_region_2& region) {
  const bool is_right = region.outer.size == 1
                            ? region.outer.bulges[0] < 0
                            : cross(Xy<double>(region.to - region.from), region.outer.joint - region.from) > 0;
  return is_right ? -1 : 1;
}
/// Whether both sides are one arc each.
[[nodiscard]] inline bool is_fat_arc(const Arc_region_2& region) {
  return region.inner.size == 1 && region.outer.size == 1;
}
}  // namespace internal

/// The fat arc of a BCA. \pre is_fat_arc(region)
/// \guarantee the chord errs by 3 u of itself, difference, products and sum by u each: 8 u of the radius
[[nodiscard]] inline Fat_arc_2 fat_arc(const Arc_region_2& region) {
  CGAL_precondition(internal::is_fat_arc(region));
  const double b0 = region.inner.bulges[0], b1 = region.outer.bulges[0];
  const double radius = 0.25 * euclidean_norm(region.to - region.from) * std::fabs(b1 - b0) + region.widening;
  return {{region.from, region.to, 0.5 * (b0 + b1)}, radius * ROUNDED_UP<8>};
}

/// An upper bound of the thickness of the region in these numbers. \pre is_fat_arc(region)
/// \guarantee at most 8 ulp above L/2 |b0 - b1|: chord 3 u, difference, product and the last one u each, twice for both
///   ways
[[nodiscard]] inline double thickness(const Arc_region_2& region) {
  CGAL_precondition(internal::is_fat_arc(region));
  constexpr double UP = ROUNDED_UP<8>;
  const double change = std::fabs(region.outer.bulges[0] - region.inner.bulges[0]);
  return UP * (0.5 * euclidean_norm(region.to - region.from) * change);
}

/// A box that holds the exact curve: spirals are monotone in x and y.
[[nodiscard]] inline CGAL::Bbox_2 box(const Arc_region_2& region) {
  return internal::box_between(region.from, region.to, region.widening);
}

/// Signed distance from a point to a side: that of its nearer arc.
[[nodiscard]] inline double signed_distance(const Xy<double>& q, const Arc_region_2& region,
                                            const Arc_region_2::Side& side) {
  const double first = signed_distance(q, arc_of(region, side, 0));
  if (side.size == 1) return first;
  const double second = signed_distance(q, arc_of(region, side, 1));
  return std::fabs(second) < std::fabs(first) ? second : first;
}

/// A rectangle over the chord that holds the region: a spiral's region is between the normals of the chord at its ends,
/// and between the chord and its outer side.
struct Region_rectangle {
  Xy<double> corner, along, across;  ///< corner, corner + along, corner + across, corner + along + across
};
/// The rectangle over a region's chord.
[[nodiscard]] inline Region_rectangle rectangle(const Arc_region_2& region) {
  const Xy<double> along = region.to - region.from;
  if (region.outer.size == 1) return {region.from, along, (-0.5 * region.outer.bulges[0]) * perp(along)};
  // the joint's height, and the larger height of an arc over its chord, in parts of the chord
  const double square = dot(along, along), joint = cross(along, region.outer.joint - region.from) / square;
  double height = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    const Arc_2 arc = arc_of(region, region.outer, i);
    height = (std::max)(height, std::fabs(arc.bulge) * euclidean_norm(arc.to - arc.from));
  }
  return {region.from, along, (joint + std::copysign(0.5 * height / std::sqrt(square), joint)) * perp(along)};
}

/// Whether a point is at most so far from a rectangle in the directions of both its sides. \pre along is not 0
[[nodiscard]] inline bool is_near(const Xy<double>& q, const Region_rectangle& r, double room) {
  const Xy<double> v = q - r.corner;
  const double length = euclidean_norm(r.along), x = dot(r.along, v) / length, y = cross(r.along, v) / length,
               height = cross(r.along, r.across) / length;
  return x >= -room && x <= length + room && y >= (std::min)(0.0, height) - room && y <= (std::max)(0.0, height) + room;
}

/// Bounds of the distance from a point to the exact curve.
/// \guarantee certified; of fat arcs thickness(region) and twice the widening apart, and some ulp of the distance and
///   the chord
[[nodiscard]] inline Bracket distance_bounds(const Xy<double>& q, const Arc_region_2& region) {
  const Xy<double> ends = region.to - region.from;
  const double chord = euclidean_norm(ends);
  if (internal::is_fat_arc(region)) return distance_bounds(q, fat_arc(region));
  const double turn = internal::turn_of(region);
  const double inner = turn * signed_distance(q, region, region.inner),
               outer = turn * signed_distance(q, region, region.outer);
  const double nearer = (std::min)(std::fabs(inner), std::fabs(outer)),
               farther = (std::max)(std::fabs(inner), std::fabs(outer));
  const double room = internal::distance_room(farther, chord, region.widening);
  // right of the inner side and left of the outer one, which tells nothing of points beyond the ends
  const bool may_be_inside = inner <= room && outer >= -room && is_near(q, rectangle(region), room);
  return {may_be_inside ? 0 : (std::max)(0.0, nearer - room), farther + room};
}

/// Bounds of the distance between the exact curves in two regions: rectangles apart in the direction of a side, and
/// ends of one seen from the other.
/// \guarantee certified; the lower one of two BCAs falls short by their thicknesses, of others by about the height of a
///   region over its chord
[[nodiscard]] inline Bracket distance_bounds(const Arc_region_2& a, const Arc_region_2& b) {
  const Region_rectangle r = rectangle(a), s = rectangle(b);
  const Xy<double> between = s.corner - r.corner;
  const double size =
      euclidean_norm(between) + 2 * (euclidean_norm(r.along) + euclidean_norm(s.along)) + a.widening + b.widening;
  double gap = 0, of_arcs = 0;
  for (const Xy<double>& chord : {r.along, s.along})
    for (const Xy<double>& direction : {chord, perp(chord)}) {
      const auto low = [&](const Region_rectangle& x) {
        return (std::min)(0.0, dot(direction, x.along)) + (std::min)(0.0, dot(direction, x.across));
      };
      const auto high = [&](const Region_rectangle& x) {
        return (std::max)(0.0, dot(direction, x.along)) + (std::max)(0.0, dot(direction, x.across));
      };
      const double way = dot(direction, between), length = euclidean_norm(chord);
      if (length > 0) gap = (std::max)({gap, (way + low(s) - high(r)) / length, (low(r) - high(s) - way) / length});
    }
  if (internal::is_fat_arc(a) && internal::is_fat_arc(b)) of_arcs = least_distance(fat_arc(a), fat_arc(b));
  constexpr double ROUNDINGS = 24 * HALF_ULP;  // of a sum of five products of vectors no longer than size
  double upper = std::numeric_limits<double>::infinity();
  for (const Xy<double>& end : {a.from, a.to}) upper = (std::min)(upper, distance_bounds(end, b).upper + a.widening);
  for (const Xy<double>& end : {b.from, b.to}) upper = (std::min)(upper, distance_bounds(end, a).upper + b.widening);
  return {(std::max)({0.0, of_arcs, gap - (a.widening + b.widening + ROUNDINGS * size)}), upper * ROUNDED_UP<2>};
}

/// Whether the exact curves in two regions for certain have no point in common; false may mean that it is not known.
[[nodiscard]] inline bool are_apart(const Arc_region_2& a, const Arc_region_2& b) {
  return distance_bounds(a, b).lower > 0;
}

/// Directions, not of unit length, between which all tangents of a piece are: `first` turned towards `last`, by less
/// than half a turn.
struct Tangent_cone_2 {
  Xy<double> first, last;
  double turn = 1;  ///< 1 where that is to the left, -1 to the right
};
/// The directions of the curve in a region: from that in which the outer side begins to that in which it ends, as it
/// turns by no less than the curve. An end moves by the widening w at most, and with it the chord turns by 2 w / L, and
/// a bulge by as much, which counts twice in an angle: 8 w / L make up for them and for rounding, 16 u.
/// \return nothing where the widening leaves all directions open
[[nodiscard]] inline std::optional<Tangent_cone_2> tangent_cone(const Arc_region_2& region) {
  const Arc_region_2::Side& outer = region.outer;
  const Arc_2 start = arc_of(region, outer, 0), end = arc_of(region, outer, outer.size - 1);
  const auto room = [&](const Arc_2& arc) {
    return 8 * region.widening / euclidean_norm(arc.to - arc.from) + 16 * HALF_ULP;
  };
  const double turn = internal::turn_of(region), open = (std::max)(room(start), room(end));
  constexpr double MOST_OPEN = 0.25;
  if (!(open <= MOST_OPEN)) return std::nullopt;
  const double room_sine = 1.1 * open;  // the tangent of an angle up to MOST_OPEN is no larger
  const auto direction = [](const Arc_2& arc, double sign) {
    const Xy<double> chord = arc.to - arc.from;
    return (1 - arc.bulge * arc.bulge) * chord + (sign * 2 * arc.bulge) * perp(chord);
  };
  const Xy<double> first = direction(start, -1), last = direction(end, 1);
  return Tangent_cone_2{first - (turn * room_sine) * perp(first), last + (turn * room_sine) * perp(last), turn};
}

}  // namespace CGAL::Bounding_arcs

#endif
