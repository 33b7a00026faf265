// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Regions as polygons of CGAL's Boolean set operations, exactly. A closed curve runs within its regions, so the polygon
// of their outer arcs together with all regions holds what the curve encloses, and the same polygon without the
// regions is held by it: the curve's area lies between those of the two, and neither is farther off than eps times the
// curve's length.

#include <CGAL/Bounding_arcs_2.h>
#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>
#include <CGAL/Bounding_arcs_2/exchange/general_polygon.h>

#include <CGAL/General_polygon_set_2.h>

#include <cstdio>
#include <vector>

using namespace CGAL::Bounding_arcs;
using FT = CGAL::Exact_rational;
using Kernel = CGAL::Circular_kernel_2<CGAL::Simple_cartesian<FT>, CGAL::Algebraic_kernel_for_circles_2_2<FT>>;
using Polygon_set = CGAL::General_polygon_set_2<CGAL::Gps_circle_segment_traits_2<CGAL::Epeck>>;

double area_of(const Polygon_set& set, bool upper) {
  std::vector<Arc_polygon_with_holes_2<>> parts;
  set.polygons_with_holes(std::back_inserter(parts));
  double sum = 0;
  for (const auto& part : parts) sum += upper ? polygon_area(part).upper : polygon_area(part).lower;
  return sum;
}

int main() {
  const char* const file = BOUNDING_ARCS_EXAMPLE_DATA "/a_wrench.json";
  const Drawing_2<FT> curves = drawing<FT>(read_curve_file(file).curves);
  for (const double eps : {1e-1, 1e-2, 1e-3}) {
    const Bounding_arc_tree_2 tree(curves);
    const Region_hierarchy_2<Bca_traits_2<Kernel>> hierarchy(tree, eps);
    const double enclosed = area(tree, 0).lower, around = length(tree, 1e-9).upper;
    std::vector<Arc_polygon_2<>> regions;
    std::vector<Boundary_piece_2<CGAL::Epeck::FT>> outer;
    hierarchy.for_each_leaf([&](const Node_handle& leaf) {
      const auto boundary = hierarchy.traits().construct_region_boundary_2_object()(hierarchy.region(leaf));
      outer.push_back(boundary.outer[0].over<CGAL::Epeck::FT>());
      if (auto polygon = general_polygon(boundary)) regions.push_back(std::move(*polygon));
    });
    Polygon_set all, inside(general_polygon(outer));
    all.join(regions.begin(), regions.end());
    Polygon_set outside = inside;
    outside.join(all);
    inside.difference(all);
    const double low = area_of(inside, false), high = area_of(outside, true);
    std::printf("eps %g: %zu regions, area in [%.9f, %.9f], %s\n", eps, regions.size(), low, high,
                enclosed - eps * around <= low && low <= enclosed && enclosed <= high && high <= enclosed + eps * around
                    ? "as it must be"
                    : "WRONG");
  }
}
