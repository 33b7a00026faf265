// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The paper's subdivision as it stands there (its sections 3.1 and 4.2), as lean as it can be written: one curve point
// and tangent a split, centres as intersections of normals with bisectors, radii and the distance of centres, nodes
// kept.  No bounds, no checks, memory reused from run to run: what the batches are measured against.

#ifndef BOUNDING_ARCS_TEST_TEXTBOOK_RECURSION_H
#define BOUNDING_ARCS_TEST_TEXTBOOK_RECURSION_H

#include <CGAL/Bounding_arcs_2/spiral/Bezier_spiral_2.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace bounding_arcs_benchmark {

/// A cubic in powers of t.
struct Cubic {
  double x[4], y[4];

  explicit Cubic(const CGAL::Bounding_arcs::Bezier_curve_2<double>& curve) {
    const auto& p = curve.control_points();
    const auto fill = [&](double(&c)[4], const auto& of) {
      c[0] = of(0);
      c[1] = 3 * (of(1) - of(0));
      c[2] = 3 * (of(2) - 2 * of(1) + of(0));
      c[3] = of(3) - 3 * of(2) + 3 * of(1) - of(0);
    };
    fill(x, [&](std::size_t i) { return p[i].x; });
    fill(y, [&](std::size_t i) { return p[i].y; });
  }
};

class Textbook_recursion {
 public:
  struct Node {
    double t0, t1, x0, y0, r0, x1, y1, r1, thickness;  // both circles
    std::uint32_t left, right;
  };

  /// Forgets all nodes but keeps their memory, so that what follows pays for no page of it.
  void start(double eps) {
    eps_ = eps;
    leaves_ = 0;
    nodes_.clear();
  }
  void add(const Cubic& curve, double first, double last) { subdivide(curve, end(curve, first), end(curve, last)); }
  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
  [[nodiscard]] std::size_t leaves() const { return leaves_; }

 private:
  struct End {
    double t, x, y, tx, ty;
  };
  [[nodiscard]] static End end(const Cubic& c, double t) {
    return {t, c.x[0] + t * (c.x[1] + t * (c.x[2] + t * c.x[3])), c.y[0] + t * (c.y[1] + t * (c.y[2] + t * c.y[3])),
            c.x[1] + t * (2 * c.x[2] + t * 3 * c.x[3]), c.y[1] + t * (2 * c.y[2] + t * 3 * c.y[3])};
  }

  std::uint32_t subdivide(const Cubic& curve, const End& a, const End& b) {
    const double dx = b.x - a.x, dy = b.y - a.y, half_square = (dx * dx + dy * dy) / 2;
    const double s0 = half_square / (a.tx * dy - a.ty * dx), s1 = half_square / (b.tx * dy - b.ty * dx);
    const double x0 = a.x - s0 * a.ty, y0 = a.y + s0 * a.tx, x1 = b.x + s1 * b.ty, y1 = b.y - s1 * b.tx;
    const double r0 = std::sqrt((x0 - a.x) * (x0 - a.x) + (y0 - a.y) * (y0 - a.y));
    const double r1 = std::sqrt((x1 - b.x) * (x1 - b.x) + (y1 - b.y) * (y1 - b.y));
    const double gap = std::sqrt((x1 - x0) * (x1 - x0) + (y1 - y0) * (y1 - y0));
    const double thickness = r0 < r1 ? r0 + gap - r1 : r1 + gap - r0;
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({a.t, b.t, x0, y0, r0, x1, y1, r1, thickness, 0, 0});
    if (!(thickness > eps_)) {
      ++leaves_;
      return index;
    }
    const End middle = end(curve, (a.t + b.t) / 2);
    const std::uint32_t left = subdivide(curve, a, middle), right = subdivide(curve, middle, b);
    nodes_[index].left = left;
    nodes_[index].right = right;
    return index;
  }

  double eps_ = 0;
  std::size_t leaves_ = 0;
  std::vector<Node> nodes_;
};

}  // namespace bounding_arcs_benchmark

#endif
