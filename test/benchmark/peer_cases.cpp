// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "peer.h"

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>
#include <set>
#include <stdexcept>
#include <utility>

namespace bounding_arcs_benchmark {
namespace {

std::vector<Chain> bundled_curves() {
  std::set<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(BOUNDING_ARCS_DATA))
    if (entry.path().extension() == ".json") files.insert(entry.path());
  std::vector<Chain> curves;
  for (const auto& file : files)
    for (const auto& record : ba::read_curve_file(file.string()).curves)
      curves.push_back(record.bezier_pieces<double>());
  return curves;
}

/// Of the control points.
CGAL::Bbox_2 box_of(const Chain& chain) {
  CGAL::Bbox_2 box;
  for (const auto& piece : chain)
    for (const Point& p : piece.control_points()) box += CGAL::Bbox_2(p.x, p.y, p.x, p.y);
  return box;
}

Chain moved(const Chain& chain, const Point& by) {
  Chain result;
  for (const auto& piece : chain) {
    std::vector<Point> points;
    for (const Point& p : piece.control_points()) points.push_back(p + by);
    result.emplace_back(std::move(points));
  }
  return result;
}

}  // namespace

Peer_cases make_cases(std::size_t pairs) {
  Peer_cases cases;
  cases.curves = bundled_curves();
  const std::size_t bundled = cases.bundled = cases.curves.size();
  std::mt19937 random(14);
  std::uniform_real_distribution<double> unit(0, 1);
  constexpr std::size_t POINTS_OF_A_CURVE = 1250;
  for (std::size_t k = 0; k < POINTS_OF_A_CURVE; ++k)
    for (std::size_t i = 0; i < bundled; ++i) {  // in turn, as each row asks the first ones only for the time
      const CGAL::Bbox_2 box = box_of(cases.curves[i]);
      const auto in = [&](double low, double high) {  // and a quarter of the box around it
        return low + (1.5 * unit(random) - 0.25) * (high - low);
      };
      const double x = in(box.xmin(), box.xmax()), y = in(box.ymin(), box.ymax());
      cases.closest.push_back({i, {x, y}});
    }
  const auto cubic = [&] {
    Cubic_points points;
    for (Point& p : points) {
      p.x = unit(random);
      p.y = unit(random);
    }
    return points;
  };
  for (std::size_t k = 0; k < pairs; ++k) {
    const Cubic_points a = cubic();
    cases.cubics.push_back({a, cubic()});
  }
  constexpr double GAP = 0.1;  // of the boxes of control points; a curve is some 2 wide
  for (std::size_t i = 0; i < bundled; ++i)
    for (std::size_t j = i + 1; j < bundled; ++j) {
      cases.crossing.push_back({i, j});
      const double by = box_of(cases.curves[i]).xmax() + GAP - box_of(cases.curves[j]).xmin();
      cases.apart.push_back({i, cases.curves.size()});
      cases.curves.push_back(moved(cases.curves[j], {by, 0}));
    }
  return cases;
}

// The control point f(k - 1, k, k + 1) is 2 f(k - 1, k, k) - f(k - 1, k - 1, k), both of piece k - 1.
std::vector<Point> b_spline_points(const Chain& chain) {
  const auto point = [&chain](std::size_t piece, std::size_t k) { return chain[piece].control_points()[k]; };
  const std::size_t n = chain.size();
  std::vector<Point> points{point(0, 0), point(0, 1)};
  for (std::size_t k = 1; k < n; ++k) {
    points.push_back(2.0 * point(k - 1, 2) - point(k - 1, 1));
    const Point other = 2.0 * point(k, 1) - point(k, 2);  // the same of the next piece
    constexpr double ROUNDING = 1e-12;                    // of coordinates about 1
    if (std::hypot(other.x - points.back().x, other.y - points.back().y) > ROUNDING)
      throw std::logic_error("a bundled curve is not twice continuously differentiable");
  }
  points.push_back(point(n - 1, 2));
  points.push_back(point(n - 1, 3));
  return points;
}

// A chord over parameters h wide is within h^2/8 max|C''|, and |C''| <= 6 max|second differences|.
std::vector<Point> polyline(const Chain& chain, double error) {
  std::vector<Point> points{chain.front().control_points().front()};
  for (const auto& piece : chain) {
    const auto& p = piece.control_points();
    double second = 0;
    for (std::size_t k = 0; k < 2; ++k) {
      const Point d = (p[k + 2] - p[k + 1]) - (p[k + 1] - p[k]);
      second = (std::max)(second, 6 * std::hypot(d.x, d.y));
    }
    const double count = (std::max)(1.0, std::ceil(std::sqrt(second / (8 * error))));
    for (double k = 1; k <= count; ++k) points.push_back(piece.point(k / count));
  }
  return points;
}

}  // namespace bounding_arcs_benchmark
