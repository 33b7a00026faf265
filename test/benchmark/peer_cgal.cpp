// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "peer.h"

#include <CGAL/AABB_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <list>
#include <memory>

namespace bounding_arcs_benchmark {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Segments = std::vector<Kernel::Segment_3>;
using Primitive = CGAL::AABB_segment_primitive<Kernel, Segments::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

/// At height 0, as trees are of space only.
struct Polyline {
  Segments segments;
  Tree tree;

  Polyline(const Chain& chain, double error) {
    const std::vector<Point> points = polyline(chain, error);
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      segments.emplace_back(Kernel::Point_3(points[i].x, points[i].y, 0),
                            Kernel::Point_3(points[i + 1].x, points[i + 1].y, 0));
    tree.rebuild(segments.cbegin(), segments.cend());
    tree.accelerate_distance_queries();
    static_cast<void>(tree.squared_distance(Kernel::Point_3(0, 0, 0)));  // it is made when it is first asked
  }
};

Peer closest_good_to(const Peer_cases& cases, double error, const std::string& name) {
  const auto lines = std::make_shared<std::list<Polyline>>();  // trees stay where they are
  std::vector<const Tree*> trees;
  for (const Chain& chain : cases.curves) trees.push_back(&lines->emplace_back(chain, error).tree);
  return {name, CLOSEST, [=, &cases](std::size_t i) {
            const auto& c = cases.closest[i];
            static_cast<void>(lines);
            return std::sqrt(trees[c.curve]->squared_distance(Kernel::Point_3(c.point.x, c.point.y, 0)));
          }};
}

}  // namespace

Peers cgal_peers(const Peer_cases& cases) {
  return {closest_good_to(cases, 1e-4, "CGAL, polylines to 1e-4"),
          closest_good_to(cases, 1e-6, "CGAL, polylines to 1e-6")};
}

}  // namespace bounding_arcs_benchmark
