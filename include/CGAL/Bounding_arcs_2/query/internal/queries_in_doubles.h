// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The queries whose answers have points, in doubles. The headers of query/ answer in points of any kernel.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_INTERNAL_QUERIES_IN_DOUBLES_H
#define CGAL_BOUNDING_ARCS_2_QUERY_INTERNAL_QUERIES_IN_DOUBLES_H

#include <CGAL/Bounding_arcs_2/number/Xy.h>
#include <CGAL/Bounding_arcs_2/query/kernel_points.h>
#include <CGAL/Bounding_arcs_2/spiral/Segment_place.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Bounding_arcs {

template <class Point> struct Closest_point;
template <class Point> struct Drawing_distance;
template <class Point> struct Intersections_2;
template <class Point> struct Convex_hull;
template <class Vector> struct Width_of_drawing;
template <class Point> struct Diameter_of_drawing;
template <class Point> struct Enclosing_circle;
template <class Point> struct Ray_hit;

namespace internal {

/// Returns the nearest point of curves in hand; see query/closest_point.h.
[[nodiscard]] std::optional<Closest_point<Xy<double>>> closest_point(const Bounding_arc_tree_2& curves,
                                                                     const Asked_point& q);
/// Returns the same by way of a place near to the result.
[[nodiscard]] std::optional<Closest_point<Xy<double>>> closest_point(const Bounding_arc_tree_2& curves,
                                                                     const Asked_point& q, const Curve_place& near);

[[nodiscard]] std::vector<Closest_point<Xy<double>>> closest_points(const Bounding_arc_tree_2& curves,
                                                                    const Asked_point& q, double eps);
[[nodiscard]] std::vector<Closest_point<Xy<double>>> k_nearest_curves(const Bounding_arc_tree_2& curves,
                                                                      const Asked_point& q, std::size_t k);

[[nodiscard]] std::optional<Drawing_distance<Xy<double>>> distance(const Bounding_arc_tree_2& a,
                                                                   const Bounding_arc_tree_2& b);
[[nodiscard]] std::optional<Drawing_distance<Xy<double>>> distance(const Bounding_arc_tree_2& a,
                                                                   const Bounding_arc_tree_2& b, double eps);

[[nodiscard]] std::optional<Drawing_distance<Xy<double>>> directed_hausdorff_distance(const Bounding_arc_tree_2& a,
                                                                                      const Bounding_arc_tree_2& b,
                                                                                      double eps);
[[nodiscard]] std::optional<Drawing_distance<Xy<double>>> hausdorff_distance(const Bounding_arc_tree_2& a,
                                                                             const Bounding_arc_tree_2& b, double eps);

[[nodiscard]] Intersections_2<Xy<double>> intersections(const Bounding_arc_tree_2& a, const Bounding_arc_tree_2& b);
[[nodiscard]] Intersections_2<Xy<double>> self_intersections(const Bounding_arc_tree_2& a);

[[nodiscard]] Convex_hull<Xy<double>> convex_hull(const Bounding_arc_tree_2& curves, double eps);
[[nodiscard]] std::optional<Width_of_drawing<Xy<double>>> width(const Bounding_arc_tree_2& curves, double eps);
[[nodiscard]] std::optional<Diameter_of_drawing<Xy<double>>> diameter(const Bounding_arc_tree_2& curves, double eps);

[[nodiscard]] std::optional<Enclosing_circle<Xy<double>>> smallest_enclosing_circle(const Bounding_arc_tree_2& curves,
                                                                                    double eps);

[[nodiscard]] std::vector<Ray_hit<Xy<double>>> ray_hits(const Bounding_arc_tree_2& curves, const Asked_point& q,
                                                        const Asked_point& direction);

}  // namespace internal

}  // namespace CGAL::Bounding_arcs

#endif
