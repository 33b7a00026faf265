// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "peer.h"

#include <boost/geometry.hpp>
#include <boost/geometry/algorithms/discrete_hausdorff_distance.hpp>
#include <boost/geometry/geometries/linestring.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/segment.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <memory>

namespace bounding_arcs_benchmark {
namespace {

namespace bg = boost::geometry;
using Boost_point = bg::model::d2::point_xy<double>;
using Segment = bg::model::segment<Boost_point>;
using Line = bg::model::linestring<Boost_point>;
using Tree = bg::index::rtree<Segment, bg::index::rstar<8>>;

struct Polyline {
  Line line;
  Tree tree;

  Polyline(const Chain& chain, double error) {
    for (const Point& p : polyline(chain, error)) line.push_back({p.x, p.y});
    std::vector<Segment> segments;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) segments.emplace_back(line[i], line[i + 1]);
    tree = Tree(segments);
  }
  [[nodiscard]] double distance(const Point& p) const {
    const Boost_point q(p.x, p.y);
    Segment nearest;
    tree.query(bg::index::nearest(q, 1), &nearest);
    return bg::distance(q, nearest);
  }
};

Peers peers_good_to(const Peer_cases& cases, double error, const std::string& name, std::size_t most_hausdorff) {
  const auto lines = std::make_shared<std::vector<Polyline>>();
  for (const Chain& chain : cases.curves) lines->emplace_back(chain, error);
  return {{name, CLOSEST,
           [=, &cases](std::size_t i) { return (*lines)[cases.closest[i].curve].distance(cases.closest[i].point); }},
          {name, DISTANCE,
           [=, &cases](std::size_t i) {
             return bg::distance((*lines)[cases.apart[i].a].line, (*lines)[cases.apart[i].b].line);
           }},
          {name, HAUSDORFF,
           [=, &cases](std::size_t i) {
             const Line &a = (*lines)[cases.crossing[i].a].line, &b = (*lines)[cases.crossing[i].b].line;
             return (std::max)(bg::discrete_hausdorff_distance(a, b), bg::discrete_hausdorff_distance(b, a));
           },
           most_hausdorff}};
}

}  // namespace

Peers boost_peers(const Peer_cases& cases) {
  constexpr std::size_t ALL = std::numeric_limits<std::size_t>::max(), FEW = 4;
  Peers peers = peers_good_to(cases, 1e-4, "Boost, polylines to 1e-4", ALL);
  for (Peer& p : peers_good_to(cases, 1e-6, "Boost, polylines to 1e-6", FEW)) peers.push_back(std::move(p));
  return peers;
}

}  // namespace bounding_arcs_benchmark
