// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The usual way to turn curves into arcs: biarcs of equal tangent lengths over parameter intervals that are bisected
// until some samples are near enough.  No certainty; what chains of arcs are measured against.

#ifndef BOUNDING_ARCS_TEST_PLAIN_BIARCS_H
#define BOUNDING_ARCS_TEST_PLAIN_BIARCS_H

#include "textbook_recursion.h"

#include <cmath>
#include <cstddef>

namespace bounding_arcs_benchmark {

class Plain_biarcs {
 public:
  explicit Plain_biarcs(double eps) : eps_(eps) {}
  void add(const Cubic& curve, double t0, double t1, int depth = 0) {
    constexpr int DEEPEST = 40;
    if (depth >= DEEPEST || is_near(curve, t0, t1)) {
      arcs_ += 2;
      return;
    }
    add(curve, t0, (t0 + t1) / 2, depth + 1);
    add(curve, (t0 + t1) / 2, t1, depth + 1);
  }
  [[nodiscard]] std::size_t arcs() const { return arcs_; }

 private:
  struct Vector {
    double x, y;
    friend Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y}; }
    friend Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y}; }
    friend Vector operator*(double s, const Vector& a) { return {s * a.x, s * a.y}; }
    friend double operator*(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y; }
  };
  [[nodiscard]] static Vector point(const Cubic& c, double t) {
    return {c.x[0] + t * (c.x[1] + t * (c.x[2] + t * c.x[3])), c.y[0] + t * (c.y[1] + t * (c.y[2] + t * c.y[3]))};
  }
  [[nodiscard]] static Vector tangent(const Cubic& c, double t) {
    const Vector v{c.x[1] + t * (2 * c.x[2] + t * 3 * c.x[3]), c.y[1] + t * (2 * c.y[2] + t * 3 * c.y[3])};
    return 1 / std::sqrt(v * v) * v;
  }
  /// How far q is from the circle that touches `direction` at p and passes the joint.
  [[nodiscard]] static double distance(const Vector& q, const Vector& p, const Vector& direction, const Vector& joint) {
    const Vector normal{-direction.y, direction.x}, to_joint = joint - p, to_q = q - p;
    const double k = 2 * (normal * to_joint) / (to_joint * to_joint), side = k * (to_q * to_q) - 2 * (normal * to_q);
    return std::fabs(side / (1 + std::sqrt(std::fabs(1 + k * side))));
  }

  [[nodiscard]] bool is_near(const Cubic& c, double t0, double t1) const {
    constexpr int SAMPLES = 8;
    const Vector p0 = point(c, t0), p1 = point(c, t1), u0 = tangent(c, t0), u1 = tangent(c, t1), v = p1 - p0,
                 u = u0 + u1;
    const double turn = 2 * (1 - u0 * u1), vu = v * u;
    const double length = turn > 1e-12 ? (std::sqrt(vu * vu + turn * (v * v)) - vu) / turn : (v * v) / (2 * vu);
    const Vector joint = 0.5 * (p0 + p1 + length * (u0 - u1));
    for (int i = 1; i < SAMPLES; ++i) {
      const Vector q = point(c, t0 + (t1 - t0) * i / SAMPLES);
      const bool first = (q - joint) * v < 0;
      if (distance(q, first ? p0 : p1, first ? u0 : u1, joint) > eps_) return false;
    }
    return true;
  }

  double eps_;
  std::size_t arcs_ = 0;
};

}  // namespace bounding_arcs_benchmark

#endif
