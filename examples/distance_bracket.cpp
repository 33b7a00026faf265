// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A query as a traversal: between which bounds lies the distance from a point to a curve?
// The curve below a region node is within the node's thickness of the inner boundary, and the boundary of the curve.

#include <CGAL/Bounding_arcs_2.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

using namespace CGAL::Bounding_arcs;
using Kernel = CGAL::Circular_kernel_2<CGAL::Simple_cartesian<double>, CGAL::Algebraic_kernel_for_circles_2_2<double>>;
using Tree = Bounding_arc_tree_2<Bca_traits_2<Kernel>, Bezier_spiral_2<double>>;
using Point = Xy<double>;

double length(const Point& v) { return std::hypot(v.x, v.y); }

double distance(const Point& q, const CGAL::Bbox_2& b) {
  return length({std::max({b.xmin() - q.x, 0.0, q.x - b.xmax()}), std::max({b.ymin() - q.y, 0.0, q.y - b.ymax()})});
}

// To an arc of at most half a circle, or a segment; needs no centre, so flat arcs lose no digits.
double distance(const Point& q, const Boundary_piece_2<double>& piece) {
  const Contact_circle_2<double>& circle = piece.support;
  const auto normal = [&](const Point& p) { return circle.normal - circle.curvature * (p - circle.point); };
  const bool beside =
      dot(perp(normal(piece.from)), q - piece.from) <= 0 && dot(perp(normal(piece.to)), q - piece.to) >= 0;
  return beside ? std::fabs(circle.side(q)) / (length(circle.normal) + length(normal(q)))
                : std::min(length(q - piece.from), length(q - piece.to));
}

int main() {
  const Bezier_curve_2<double> curve({{0, 0.6}, {6.4, 3}, {-2.4, 3.4}, {3, 0}});
  const Tree tree(spiral_segments(curve), 1e-7);
  for (const Point& q : {Point{1.5, 1.8}, Point{0, 0}, Point{4, 2}}) {
    double lower = std::numeric_limits<double>::infinity(), upper = lower;
    std::size_t visited = 0;
    tree.traverse([&](const Tree::Handle& h) {
      ++visited;
      if (distance(q, tree.box(h)) > upper) return false;
      if (!h.is_region) return true;
      const auto boundary = tree.traits().construct_region_boundary_2_object()(tree.region(h));
      const double d = distance(q, boundary.inner[0]), thickness = tree.thickness(h);
      upper = std::min(upper, d + thickness);
      if (tree.is_leaf(h)) lower = std::min(lower, d - thickness);
      return d - thickness <= upper;
    });
    std::printf("distance from (%g, %g): %.5f, bracket %s, %s\n", q.x, q.y, (lower + upper) / 2,
                upper - lower <= 2.1e-7 ? "narrower than 2.1e-7" : "wide",
                10 * visited < tree.number_of_nodes() ? "a tenth of the nodes at most seen" : "many nodes seen");
  }
}
