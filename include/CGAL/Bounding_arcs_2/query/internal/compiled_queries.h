// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The queries that the library has compiled, in doubles.  What they answer is in the headers of query/, which turn it
// into points of a kernel.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_INTERNAL_COMPILED_QUERIES_H
#define CGAL_BOUNDING_ARCS_2_QUERY_INTERNAL_COMPILED_QUERIES_H

#include <CGAL/Bounding_arcs_2/query/kernel_points.h>
#include <CGAL/Bounding_arcs_2/spiral/Segment_place.h>
#include <CGAL/Bounding_arcs_2/tree/Drawing_hierarchy.h>

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
struct Measure_bounds;
struct Centroid_bounds;

/// Returns the nearest point of curves in hand; see query/closest_point.h.
[[nodiscard]] std::optional<Closest_point<Xy<double>>> closest_point(const Drawing_hierarchy& curves,
                                                                     const Asked_point& q);
/// Returns the same by way of a place near to the result.
[[nodiscard]] std::optional<Closest_point<Xy<double>>> closest_point(const Drawing_hierarchy& curves,
                                                                     const Asked_point& q, const Curve_place& near);

namespace internal {

[[nodiscard]] std::vector<Closest_point<Xy<double>>> closest_points(const Drawing_hierarchy& curves,
                                                                    const Asked_point& q, double eps);
[[nodiscard]] std::vector<Closest_point<Xy<double>>> k_nearest_curves(const Drawing_hierarchy& curves,
                                                                      const Asked_point& q, std::size_t k);

[[nodiscard]] std::optional<Drawing_distance<Xy<double>>> distance(const Drawing_hierarchy& a,
                                                                   const Drawing_hierarchy& b);
[[nodiscard]] std::optional<Drawing_distance<Xy<double>>> distance(const Drawing_hierarchy& a,
                                                                   const Drawing_hierarchy& b, double eps);

[[nodiscard]] std::optional<Drawing_distance<Xy<double>>> directed_hausdorff_distance(const Drawing_hierarchy& a,
                                                                                      const Drawing_hierarchy& b,
                                                                                      double eps);
[[nodiscard]] std::optional<Drawing_distance<Xy<double>>> hausdorff_distance(const Drawing_hierarchy& a,
                                                                             const Drawing_hierarchy& b, double eps);

[[nodiscard]] Intersections_2<Xy<double>> intersections(const Drawing_hierarchy& a, const Drawing_hierarchy& b);
[[nodiscard]] Intersections_2<Xy<double>> self_intersections(const Drawing_hierarchy& a);
[[nodiscard]] std::optional<bool> do_intersect(const Drawing_hierarchy& a, const Drawing_hierarchy& b);

[[nodiscard]] Measure_bounds length(const Drawing_hierarchy& curves, double eps);
[[nodiscard]] Measure_bounds area(const Drawing_hierarchy& curves, double eps);
[[nodiscard]] std::optional<Centroid_bounds> centroid(const Drawing_hierarchy& curves, double eps);

[[nodiscard]] Convex_hull<Xy<double>> convex_hull(const Drawing_hierarchy& curves, double eps);
[[nodiscard]] std::optional<Width_of_drawing<Xy<double>>> width(const Drawing_hierarchy& curves, double eps);
[[nodiscard]] std::optional<Diameter_of_drawing<Xy<double>>> diameter(const Drawing_hierarchy& curves, double eps);

[[nodiscard]] std::optional<Enclosing_circle<Xy<double>>> smallest_enclosing_circle(const Drawing_hierarchy& curves,
                                                                                    double eps);

[[nodiscard]] std::vector<Ray_hit<Xy<double>>> ray_hits(const Drawing_hierarchy& curves, const Asked_point& q,
                                                        const Asked_point& direction);

}  // namespace internal

}  // namespace CGAL::Bounding_arcs

#endif
