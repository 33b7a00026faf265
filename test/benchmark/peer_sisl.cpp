// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "peer.h"

#include <sisl.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>

namespace bounding_arcs_benchmark {
namespace {

constexpr int CUBIC_ORDER = 4, B_SPLINE = 1, DIMENSION = 2, COPIED = 1;
constexpr double RESOLUTION = 1e-9;  // of points; what computes parameters takes them to rounding

struct Free_curve {
  void operator()(SISLCurve* c) const { freeCurve(c); }
};
using Curve = std::unique_ptr<SISLCurve, Free_curve>;

Curve curve(std::vector<double> knots, const std::vector<Point>& points) {
  std::vector<double> coordinates;
  for (const Point& p : points) coordinates.insert(coordinates.end(), {p.x, p.y});
  return Curve(newCurve(static_cast<int>(points.size()), CUBIC_ORDER, knots.data(), coordinates.data(), B_SPLINE,
                        DIMENSION, COPIED));
}
Curve cubic(const Cubic_points& p) {
  double knots[] = {0, 0, 0, 0, 1, 1, 1, 1};
  double coordinates[] = {p[0].x, p[0].y, p[1].x, p[1].y, p[2].x, p[2].y, p[3].x, p[3].y};
  return Curve(newCurve(CUBIC_ORDER, CUBIC_ORDER, knots, coordinates, B_SPLINE, DIMENSION, COPIED));
}
Curve b_spline(const Chain& chain) {
  const int n = static_cast<int>(chain.size());
  std::vector<double> knots(3, 0);
  for (int i = 0; i <= n; ++i) knots.push_back(i);
  knots.insert(knots.end(), 3, n);
  return curve(std::move(knots), b_spline_points(chain));
}

Point point_at(SISLCurve* c, double t) {
  int knot = 0, status = 0;
  double p[DIMENSION];
  s1221(c, 0, t, &knot, p, &status);
  return {p[0], p[1]};
}

/// What SISL returns of one question and leaves to its caller.
struct Found {
  int points = 0, curves = 0, status = 0;
  double *a = nullptr, *b = nullptr;
  SISLIntcurve** parts = nullptr;

  Found() = default;
  Found(const Found&) = delete;
  Found& operator=(const Found&) = delete;
  ~Found() {
    std::free(a);
    std::free(b);
    if (parts != nullptr) freeIntcrvlist(parts, curves);
  }
  [[nodiscard]] double count() const { return status < 0 ? NO_ANSWER : points + curves; }
};

double intersections(SISLCurve* a, SISLCurve* b) {
  Found found;
  s1857(a, b, 0, RESOLUTION, &found.points, &found.a, &found.b, &found.curves, &found.parts, &found.status);
  return found.count();
}

double closest(SISLCurve* c, const Point& q) {
  double p[] = {q.x, q.y};
  Found found;
  s1953(c, p, DIMENSION, 0, RESOLUTION, &found.points, &found.a, &found.curves, &found.parts, &found.status);
  if (found.status < 0 || found.points == 0) return NO_ANSWER;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < found.points; ++i) {
    const Point d = point_at(c, found.a[i]) - q;
    least = (std::min)(least, std::hypot(d.x, d.y));
  }
  return least;
}

double closest_fast(SISLCurve* c, const Point& q) {
  double p[] = {q.x, q.y}, t = 0, distance = 0;
  int status = 0;
  s1957(c, p, DIMENSION, 0, RESOLUTION, &t, &distance, &status);
  return status < 0 ? NO_ANSWER : distance;
}

double distance(SISLCurve* a, SISLCurve* b) {
  Found found;
  s1955(a, b, 0, RESOLUTION, &found.points, &found.a, &found.b, &found.curves, &found.parts, &found.status);
  if (found.status < 0 || found.points == 0) return NO_ANSWER;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < found.points; ++i) {
    const Point d = point_at(a, found.a[i]) - point_at(b, found.b[i]);
    least = (std::min)(least, std::hypot(d.x, d.y));
  }
  return least;
}

}  // namespace

Peers sisl_peers(const Peer_cases& cases) {
  const auto curves = std::make_shared<std::vector<Curve>>();
  for (const Chain& chain : cases.curves) curves->push_back(b_spline(chain));
  const auto at = [curves](std::size_t i) { return (*curves)[i].get(); };
  return {
      {"SISL", CLOSEST,
       [=, &cases](std::size_t i) { return closest(at(cases.closest[i].curve), cases.closest[i].point); }},
      {"SISL, fast call", CLOSEST,
       [=, &cases](std::size_t i) { return closest_fast(at(cases.closest[i].curve), cases.closest[i].point); }},
      {"SISL", CUBICS,
       [&cases](std::size_t i) {
         const Curve a = cubic(cases.cubics[i].a), b = cubic(cases.cubics[i].b);
         return intersections(a.get(), b.get());
       }},
      {"SISL", CURVES,
       [=, &cases](std::size_t i) { return intersections(at(cases.crossing[i].a), at(cases.crossing[i].b)); }},
      {"SISL", DISTANCE, [=, &cases](std::size_t i) { return distance(at(cases.apart[i].a), at(cases.apart[i].b)); }}};
}

}  // namespace bounding_arcs_benchmark
