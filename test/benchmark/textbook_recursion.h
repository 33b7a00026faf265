// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The paper's subdivision as it stands there (its sections 3.1 to 3.3 and 4.2), as lean as it can be written: one curve
// point, tangent and, where it is needed, osculating circle a split, centers as intersections, radii and distances of
// centers, nodes with their arcs kept.  No bounds, no checks, memory reused from run to run: what the batches are
// measured against.

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

struct Circle {
  double x, y, r;
};

inline double distance(double x0, double y0, double x1, double y1) {
  return std::sqrt((x1 - x0) * (x1 - x0) + (y1 - y0) * (y1 - y0));
}

/// Section 3.1: both circles.
struct Textbook_bca_node {
  static constexpr const char* NAME = "bca";
  struct End {
    double t, x, y, tx, ty;
  };
  [[nodiscard]] static End end(const Cubic& c, double t) {
    return {t, c.x[0] + t * (c.x[1] + t * (c.x[2] + t * c.x[3])), c.y[0] + t * (c.y[1] + t * (c.y[2] + t * c.y[3])),
            c.x[1] + t * (2 * c.x[2] + t * 3 * c.x[3]), c.y[1] + t * (2 * c.y[2] + t * 3 * c.y[3])};
  }

  Textbook_bca_node(const End& a, const End& b) {
    const double dx = b.x - a.x, dy = b.y - a.y, half_square = (dx * dx + dy * dy) / 2;
    const double s0 = half_square / (a.tx * dy - a.ty * dx), s1 = half_square / (b.tx * dy - b.ty * dx);
    start = {a.x - s0 * a.ty, a.y + s0 * a.tx, 0};
    stop = {b.x + s1 * b.ty, b.y - s1 * b.tx, 0};
    start.r = distance(start.x, start.y, a.x, a.y);
    stop.r = distance(stop.x, stop.y, b.x, b.y);
    const double gap = distance(start.x, start.y, stop.x, stop.y);
    thickness = start.r < stop.r ? start.r + gap - stop.r : stop.r + gap - start.r;
  }

  Circle start, stop;
  double thickness;
};

/// What sections 3.2 and 3.3 start from.
struct Osculating_end {
  double t, x, y, ux, uy;  // unit tangent
  double r;                // signed radius of curvature, positive to the left
};
/// Lines are left to the chord, as in the paper: of radii that large nothing is left after their differences.
[[nodiscard]] inline bool is_straight(const Osculating_end& a, const Osculating_end& b) {
  constexpr double FLAT = 1e7;
  return std::fabs(a.r) > FLAT && std::fabs(b.r) > FLAT;
}
[[nodiscard]] inline Osculating_end osculating_end(const Cubic& c, double t) {
  const double tx = c.x[1] + t * (2 * c.x[2] + t * 3 * c.x[3]), ty = c.y[1] + t * (2 * c.y[2] + t * 3 * c.y[3]);
  const double sx = 2 * c.x[2] + t * 6 * c.x[3], sy = 2 * c.y[2] + t * 6 * c.y[3];
  const double square = tx * tx + ty * ty, length = std::sqrt(square), inverse = 1 / length;
  return {t,
          c.x[0] + t * (c.x[1] + t * (c.x[2] + t * c.x[3])),
          c.y[0] + t * (c.y[1] + t * (c.y[2] + t * c.y[3])),
          tx * inverse,
          ty * inverse,
          square * length / (tx * sy - ty * sx)};
}

/// Section 3.2: both osculating circles and both joints.
struct Textbook_sfa_node {
  static constexpr const char* NAME = "sfa";
  using End = Osculating_end;
  [[nodiscard]] static End end(const Cubic& c, double t) { return osculating_end(c, t); }

  Textbook_sfa_node(const End& a, const End& b) {
    const bool tight_first = std::fabs(a.r) < std::fabs(b.r);
    const End &p = tight_first ? a : b, &q = tight_first ? b : a;  // tight and flat
    const double side = p.r > 0 ? 1 : -1, r = std::fabs(p.r), flat_r = std::fabs(q.r);
    tight = {p.x - p.r * p.uy, p.y + p.r * p.ux, r};
    flat = {q.x - q.r * q.uy, q.y + q.r * q.ux, flat_r};
    const double vx = tight.x - q.x, vy = tight.y - q.y, square = vx * vx + vy * vy, l = std::sqrt(square - r * r);
    const double along = l * l / square, across = (tight_first ? side : -side) * l * r / square;
    jx = q.x + along * vx - across * vy;
    jy = q.y + along * vy + across * vx;
    const double w = (p.x - flat.x) * p.ux + (p.y - flat.y) * p.uy, ex = p.x - w * p.ux, ey = p.y - w * p.uy;
    const double height = distance(flat.x, flat.y, ex, ey), run = std::sqrt(flat_r * flat_r - height * height);
    const double forward = tight_first ? run : -run;
    ix = ex + forward * p.ux;
    iy = ey + forward * p.uy;
    thickness = distance(ix, iy, tight.x, tight.y) - r;
    const double line = 1 / distance(jx, jy, q.x, q.y), lx = (q.x - jx) * line, ly = (q.y - jy) * line;
    const double start = side * (lx * (ix - flat.x) + ly * (iy - flat.y)) * (tight_first ? 1 : -1);
    const double deviation = flat_r - std::fabs(lx * (flat.y - jy) - ly * (flat.x - jx));
    if (start < 0 && thickness < deviation) thickness = deviation;
    if (is_straight(a, b)) thickness = 0;
  }

  Circle tight, flat;
  double jx, jy, ix, iy;
  double thickness;
};

/// Section 3.3: all four circles and both joints.
struct Textbook_bilens_node {
  static constexpr const char* NAME = "bilens";
  using End = Osculating_end;
  [[nodiscard]] static End end(const Cubic& c, double t) { return osculating_end(c, t); }

  Textbook_bilens_node(const End& a, const End& b) {
    const bool tight_first = std::fabs(a.r) < std::fabs(b.r);
    const End &p = tight_first ? a : b, &q = tight_first ? b : a;
    tight = {p.x - p.r * p.uy, p.y + p.r * p.ux, std::fabs(p.r)};
    flat = {q.x - q.r * q.uy, q.y + q.r * q.ux, std::fabs(q.r)};
    // z' and c': as far along the other end's normal
    const double zx = q.x - p.r * q.uy, zy = q.y + p.r * q.ux, cx = p.x - q.r * p.uy, cy = p.y + q.r * p.ux;
    // the points of the normals at equal distance from z and z', c and c'
    inner = on_normal(q, tight, zx, zy);
    outer = on_normal(p, flat, cx, cy);
    inner.r = distance(inner.x, inner.y, q.x, q.y);
    outer.r = distance(outer.x, outer.y, p.x, p.y);
    const double to_tight = inner.r / distance(tight.x, tight.y, inner.x, inner.y);
    jx = inner.x + to_tight * (tight.x - inner.x);
    jy = inner.y + to_tight * (tight.y - inner.y);
    const double to_outer = flat.r / distance(outer.x, outer.y, flat.x, flat.y);
    ix = flat.x + to_outer * (outer.x - flat.x);
    iy = flat.y + to_outer * (outer.y - flat.y);
    thickness = is_straight(a, b) ? 0 : outer.r + distance(inner.x, inner.y, outer.x, outer.y) - inner.r;
  }

  Circle tight, flat, inner, outer;
  double jx, jy, ix, iy;
  double thickness;

 private:
  [[nodiscard]] static Circle on_normal(const End& e, const Circle& z, double zx, double zy) {
    const double mx = (z.x + zx) / 2 - e.x, my = (z.y + zy) / 2 - e.y, dx = zx - z.x, dy = zy - z.y;
    const double s = (mx * dx + my * dy) / (e.ux * dy - e.uy * dx);
    return {e.x - s * e.uy, e.y + s * e.ux, 0};
  }
};

template <class Region> class Textbook_recursion {
 public:
  struct Node : Region {
    double t0, t1;
    std::uint32_t left, right;
  };

  /// Forgets all nodes but keeps their memory, so that what follows pays for no page of it.
  void start(double eps) {
    eps_ = eps;
    leaves_ = 0;
    nodes_.clear();
  }
  void add(const Cubic& curve, double first, double last) {
    subdivide(curve, Region::end(curve, first), Region::end(curve, last));
  }
  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
  [[nodiscard]] std::size_t leaves() const { return leaves_; }

 private:
  using End = typename Region::End;

  std::uint32_t subdivide(const Cubic& curve, const End& a, const End& b) {
    const Region region(a, b);
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({region, a.t, b.t, 0, 0});
    constexpr double LEAST_STEP = 0x1p-20;  // next to an inflection rounding may have taken the thickness
    if (!(region.thickness > eps_) || b.t - a.t < LEAST_STEP) {
      ++leaves_;
      return index;
    }
    const End middle = Region::end(curve, (a.t + b.t) / 2);
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
