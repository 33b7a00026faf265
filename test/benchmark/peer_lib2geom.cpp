// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "peer.h"

#include <2geom/bezier-curve.h>
#include <2geom/path.h>

#include <memory>

namespace bounding_arcs_benchmark {
namespace {

Geom::Point point(const Point& p) { return {p.x, p.y}; }
template <class Points> Geom::CubicBezier cubic(const Points& p) {
  return {point(p[0]), point(p[1]), point(p[2]), point(p[3])};
}

}  // namespace

Peers lib2geom_peers(const Peer_cases& cases) {
  const auto paths = std::make_shared<std::vector<Geom::Path>>();
  for (const Chain& chain : cases.curves) {
    Geom::Path path(point(chain.front().control_points().front()));
    for (const auto& piece : chain) path.append(cubic(piece.control_points()));
    path.close();
    paths->push_back(path);
  }
  const std::string name = "lib2geom";
  return {{name, CLOSEST,
           [=, &cases](std::size_t i) {
             const auto& c = cases.closest[i];
             double distance = 0;
             static_cast<void>((*paths)[c.curve].nearestTime(point(c.point), &distance));
             return distance;
           }},
          {name, CUBICS,
           [&cases](std::size_t i) {
             const Geom::CubicBezier a = cubic(cases.cubics[i].a), b = cubic(cases.cubics[i].b);
             return static_cast<double>(a.intersect(b).size());
           }},
          {name, CURVES, [=, &cases](std::size_t i) {
             const auto& c = cases.crossing[i];
             return static_cast<double>((*paths)[c.a].intersect((*paths)[c.b]).size());
           }}};
}

}  // namespace bounding_arcs_benchmark
