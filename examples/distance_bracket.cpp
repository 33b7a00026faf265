// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A query as a traversal: between which bounds lies the distance from a point to a curve? Each region node tells bounds
// of its distance by one arc; those that are too far are left out, and leaves tell the lower bound.

#include <CGAL/Bounding_arcs_2.h>
#include <CGAL/Bounding_arcs_2/region/region_bounds.h>
#include <CGAL/Bounding_arcs_2/tree/Region_reader.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cstdio>
#include <limits>

using namespace CGAL::Bounding_arcs;
using Kernel = CGAL::Circular_kernel_2<CGAL::Simple_cartesian<double>, CGAL::Algebraic_kernel_for_circles_2_2<double>>;
using Regions = Region_hierarchy_2<Bca_traits_2<Kernel>>;

int main() {
  const Bezier_curve_2<double> curve({{0, 0.6}, {6.4, 3}, {-2.4, 3.4}, {3, 0}});
  const Regions regions(Bounding_arc_tree_2(curve), 1e-7);
  Region_reader reader(regions);
  for (const Xy<double>& q : {Xy<double>{1.5, 1.8}, Xy<double>{0, 0}, Xy<double>{4, 2}}) {
    double lower = std::numeric_limits<double>::infinity(), upper = lower;
    std::size_t visited = 0;
    regions.traverse([&](const Regions::Handle& h) {
      ++visited;
      if (!h.is_region) return true;
      const Bracket d = distance_bounds(q, reader.region(h));
      upper = std::min(upper, d.upper);
      if (h.is_leaf) lower = std::min(lower, d.lower);
      return d.lower <= upper;
    });
    std::printf("distance from (%g, %g): %.5f, bracket %s, %s\n", q.x, q.y, (lower + upper) / 2,
                upper - lower <= 1.1e-7 ? "narrower than 1.1e-7" : "wide",
                10 * visited < regions.number_of_nodes() ? "a tenth of the nodes at most seen" : "many nodes seen");
  }
}
