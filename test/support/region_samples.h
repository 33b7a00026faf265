// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points on a region's boundary and distances to it, in long double and without centers.
//
//        ___ to         a piece turns by 2 angle; the chord from `from` to the point at a fraction s of the turning
//     _/   .            makes the angle s * angle with the tangent, and has length |chord| sin(s angle) / sin(angle)
//   from -> tangent

#ifndef BOUNDING_ARCS_TEST_REGION_SAMPLES_H
#define BOUNDING_ARCS_TEST_REGION_SAMPLES_H

#include <CGAL/Bounding_arcs_2/region/Contact_circle_2.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace bounding_arcs_test {

using Real = long double;
using Vector = CGAL::Bounding_arcs::Xy<Real>;

inline Real length(const Vector& v) { return std::hypot(v.x, v.y); }
inline Vector widened(const CGAL::Bounding_arcs::Xy<double>& p) { return {Real(p.x), Real(p.y)}; }

/// A boundary piece in long double with a normal of length 1.
struct Sampled_piece {
  Vector from, to, point, normal;
  Real curvature;

  explicit Sampled_piece(const CGAL::Bounding_arcs::Boundary_piece_2<double>& p)
      : from(widened(p.from)), to(widened(p.to)), point(widened(p.support.point)) {
    const Vector n = widened(p.support.normal);
    normal = (1 / length(n)) * n;
    curvature = Real(p.support.curvature) / length(n);
  }

  /// The left unit normal at a point of the support.
  [[nodiscard]] Vector normal_at(const Vector& q) const {
    const Vector n = normal - curvature * (q - point);
    return (1 / length(n)) * n;
  }
  /// The unit tangent at a point of the support.
  [[nodiscard]] Vector tangent_at(const Vector& q) const { return -perp(normal_at(q)); }
  /// Half the turning, positive to the left.
  [[nodiscard]] Real angle() const {
    const Vector t = tangent_at(from);
    return std::atan2(cross(t, Vector(to - from)), dot(t, Vector(to - from)));
  }
  [[nodiscard]] Vector at(Real s) const {
    const Real a = angle(), c = length(to - from);
    const Real stretch = std::fabs(a) < 1e-12L ? s : std::sin(s * a) / std::sin(a);
    const Vector t = tangent_at(from);
    return from + (c * stretch) * (std::cos(s * a) * t + std::sin(s * a) * perp(t));
  }
  /// The signed distance from the support, positive to the left.
  [[nodiscard]] Real signed_distance(const Vector& q) const {
    const Vector v = q - point;
    const Real side = 2 * dot(normal, v) - curvature * dot(v, v);
    return side / (1 + std::sqrt(std::max(Real(0), 1 - curvature * side)));
  }
  [[nodiscard]] Real distance(const Vector& q) const {
    const Real at_ends = std::min(length(q - from), length(q - to));
    const Vector n = normal_at(from), v = q - from;
    const Real along = dot(Vector(-perp(n)), v);
    const Real turned = std::atan2(curvature * along, 1 - curvature * dot(n, v));
    const Real c = length(to - from);
    const Real fraction = std::fabs(curvature) * c < 1e-12L ? along / c : turned / (2 * angle());
    return fraction >= 0 && fraction <= 1 ? std::min(at_ends, std::fabs(signed_distance(q))) : at_ends;
  }
};

inline std::vector<Sampled_piece> sampled(const CGAL::Bounding_arcs::Boundary_chain_2<double>& chain) {
  std::vector<Sampled_piece> pieces;
  for (const auto& piece : chain) pieces.emplace_back(piece);
  return pieces;
}

inline std::vector<Vector> samples(const std::vector<Sampled_piece>& chain, int per_piece) {
  std::vector<Vector> points;
  for (const Sampled_piece& piece : chain)
    for (int i = 0; i <= per_piece; ++i) points.push_back(piece.at(Real(i) / per_piece));
  return points;
}

/// The largest distance from a sample of one chain to the other chain.
inline Real one_sided_distance(const std::vector<Sampled_piece>& from, const std::vector<Sampled_piece>& to) {
  Real largest = 0;
  for (const Vector& q : samples(from, 64)) {
    Real least = std::numeric_limits<Real>::infinity();
    for (const Sampled_piece& piece : to) least = std::min(least, piece.distance(q));
    largest = std::max(largest, least);
  }
  return largest;
}

}  // namespace bounding_arcs_test

#endif
