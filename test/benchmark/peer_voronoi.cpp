// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Medial axes of polylines: Voronoi diagrams of their segments. Their answer is the radius of the largest disc inside;
// which of their edges are the curve's and which are those of kinks they are not asked.

#include "peer.h"

#include <CGAL/Segment_Delaunay_graph_2.h>
#include <CGAL/Segment_Delaunay_graph_filtered_traits_2.h>
#include <CGAL/Simple_cartesian.h>

#include <boost/polygon/segment_data.hpp>
#include <boost/polygon/voronoi.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

namespace bounding_arcs_benchmark {
namespace {

constexpr double ERROR = 1e-6;

double signed_area(const std::vector<Point>& closed) {
  double area = 0;
  for (std::size_t i = 0; i + 1 < closed.size(); ++i) area += cross(closed[i], closed[i + 1]) / 2;
  return area;
}
/// Of a part of a cubic: the curve is within 3/4 of its control points' distances from the line.
bool is_flat(const ba::Bezier_curve_2<double>& part) {
  const auto& p = part.control_points();
  const Point chord = p[3] - p[0];
  const double most = (std::max)(std::fabs(cross(chord, p[1] - p[0])), std::fabs(cross(chord, p[2] - p[0])));
  return 0.75 * most <= ERROR * std::hypot(chord.x, chord.y);
}
/// With chords as long as they may be, what they enclose on their left: a little more than half of `polyline`'s, whose
/// steps are those of a piece's largest second derivative.
std::vector<Point> sparse_polyline(const Chain& chain) {
  std::vector<Point> points{chain.front().control_points().front()};
  for (const auto& piece : chain)
    for (double t = 0; t < 1;) {
      double low = t, high = 1;  // flat up to low
      if (is_flat(piece.subcurve(t, 1))) low = 1;
      for (int k = 0; k < 16 && low < 1; ++k) {
        const double middle = (low + high) / 2;
        (is_flat(piece.subcurve(t, middle)) ? low : high) = middle;
      }
      t = low;
      points.push_back(piece.point(t));
    }
  if (signed_area(points) < 0) std::reverse(points.begin(), points.end());
  return points;
}

/// In integers of 2^-28; curves are within [-4, 4].
class Boost_diagram {
 public:
  using Integer_point = boost::polygon::point_data<std::int32_t>;
  using Segments = std::vector<boost::polygon::segment_data<std::int32_t>>;

  static Segments segments(const std::vector<Point>& line) {
    const auto integer = [](const Point& p) {
      return Integer_point(static_cast<std::int32_t>(std::lround(p.x / UNIT)),
                           static_cast<std::int32_t>(std::lround(p.y / UNIT)));
    };
    Segments result;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) result.emplace_back(integer(line[i]), integer(line[i + 1]));
    return result;
  }
  static double largest_radius(const Segments& segments) {
    boost::polygon::voronoi_diagram<double> diagram;
    boost::polygon::construct_voronoi(segments.begin(), segments.end(), &diagram);
    double largest = 0;
    for (const auto& v : diagram.vertices()) {
      const auto& s = segments[v.incident_edge()->cell()->source_index()];
      const Point a{double(s.low().x()), double(s.low().y())}, b{double(s.high().x()), double(s.high().y())};
      const Point way = b - a, to = Point{v.x(), v.y()} - a;
      if (!(cross(way, to) > 0)) continue;  // of an end of a segment, too: both of its segments have it on one side
      const double t = std::clamp(dot(to, way) / dot(way, way), 0.0, 1.0);
      const Point apart = to - t * way;
      largest = (std::max)(largest, dot(apart, apart));
    }
    return UNIT * std::sqrt(largest);
  }

 private:
  static constexpr double UNIT = 1.0 / (1 << 28);
};

class Cgal_graph {
 public:
  using Kernel = CGAL::Simple_cartesian<double>;
  using Traits = CGAL::Segment_Delaunay_graph_filtered_traits_without_intersections_2<Kernel>;
  using Graph = CGAL::Segment_Delaunay_graph_2<Traits>;
  struct Segments {
    std::vector<Kernel::Point_2> points;
    std::vector<std::pair<std::size_t, std::size_t>> ends;
  };

  static Segments segments(const std::vector<Point>& line) {
    Segments result;
    const std::size_t count = line.size() - 1;  // the first point is the last one
    for (std::size_t i = 0; i < count; ++i) {
      result.points.emplace_back(line[i].x, line[i].y);
      result.ends.emplace_back(i, (i + 1) % count);
    }
    return result;
  }
  static double largest_radius(const Segments& segments) {
    Graph graph;
    graph.insert_segments(segments.points.begin(), segments.points.end(), segments.ends.begin(), segments.ends.end());
    double largest = 0;
    for (auto face = graph.finite_faces_begin(); face != graph.finite_faces_end(); ++face) {
      const auto center = graph.primal(face);
      const auto line = segment_of(graph, face->vertex(0)).supporting_line();
      if (!line.has_on_positive_side(center)) continue;
      const auto site = face->vertex(0)->site();
      largest = (std::max)(largest, site.is_point() ? CGAL::squared_distance(center, site.point())
                                                    : CGAL::squared_distance(center, line));
    }
    return std::sqrt(largest);
  }

 private:
  /// The site, or one that ends in it, which is next to it.
  static Kernel::Segment_2 segment_of(const Graph& graph, Graph::Vertex_handle v) {
    if (v->site().is_segment()) return v->site().segment();
    auto next = graph.incident_vertices(v);
    const auto ends_here = [&](const Graph::Site_2& s) {
      return s.is_segment() && (s.source() == v->site().point() || s.target() == v->site().point());
    };
    while (graph.is_infinite(next) || !ends_here(next->site())) ++next;
    return next->site().segment();
  }
};

/// \tparam Diagram of `segments` of a polyline has a `largest_radius`
template <class Diagram> Peer peer(const Peer_cases& cases, const std::string& name) {
  const auto all = std::make_shared<std::vector<decltype(Diagram::segments({}))>>();
  for (std::size_t i = 0; i < cases.bundled; ++i) all->push_back(Diagram::segments(sparse_polyline(cases.curves[i])));
  return {name, AXIS, [=](std::size_t i) { return Diagram::largest_radius((*all)[i]); }};
}

}  // namespace

Peers voronoi_peers(const Peer_cases& cases) {
  return {peer<Boost_diagram>(cases, "Boost, polylines to 1e-6"), peer<Cgal_graph>(cases, "CGAL, polylines to 1e-6")};
}

}  // namespace bounding_arcs_benchmark
