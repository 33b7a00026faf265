// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of query/enclosing_circle.h.

#include "Farthest_bound.h"
#include "Hull_pieces.h"
#include "query_units.h"

#include <CGAL/Bounding_arcs_2/query/enclosing_circle.h>

#include <CGAL/Min_sphere_of_points_d_traits_2.h>
#include <CGAL/Min_sphere_of_spheres_d.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

// The smallest circle about a drawing, by circles about samples.
//
// Whatever a center c is, points p_i and weights l_i >= 0 with the sum 1 have
//   sum l_i |p_i - c|^2 - |sum l_i p_i - c|^2  =  min over z of sum l_i |p_i - z|^2  <=  r^2,
// r the least radius: a lower bound that does not hang on how exactly a circle was found.  An upper one is the farthest
// that a piece may be from c.  Pieces that may be farther than r allows are halved, which is few of them, and samples
// outside the circle added.

class Circle_search {
 public:
  Circle_search(const Segment_hierarchy& curves, double tolerance) : hull_(curves) {
    constexpr double ROUGH = 0x1p-7;  // of the extent: what is well inside is looked at no more
    hull_.lower(ROUGH * extent_of(curves));
    const auto is_outside = [this](const Xy<double>& q) { return euclidean_norm(q - center_) > lower_; };
    do {
      enclose();
      bound(tolerance);
    } while (hull_.halve_marked(is_outside));
  }

  [[nodiscard]] const Xy<double>& center() const { return center_; }
  [[nodiscard]] double lower() const { return lower_; }
  [[nodiscard]] double upper() const { return upper_; }
  /// Whether pieces were left as they were, as there were too many.
  [[nodiscard]] bool is_limited() const { return hull_.is_limited(); }

 private:
  // Seen from the first point, so that coordinates far from the origin lose nothing.
  void enclose() {
    using Kernel = CGAL::Simple_cartesian<double>;
    using Traits = CGAL::Min_sphere_of_points_d_traits_2<Kernel, double>;
    std::vector<Kernel::Point_2> points;
    const Xy<double> o = hull_.polygon().front();
    for (const Xy<double>& p : hull_.polygon()) points.emplace_back(p.x - o.x, p.y - o.y);
    CGAL::Min_sphere_of_spheres_d<Traits> sphere(points.begin(), points.end());
    const auto* c = sphere.center_cartesian_begin();
    center_ = o + Xy<double>{c[0], c[1]};
    std::vector<Xy<double>> support;
    for (auto i = sphere.support_begin(); i != sphere.support_end(); ++i)
      support.push_back(o + Xy<double>{(*i).x(), (*i).y()});
    lower_ = (std::max)(lower_, radius_of(support));
    farthest_ = 0;
    for (const Xy<double>& p : hull_.polygon()) farthest_ = (std::max)(farthest_, euclidean_norm(p - center_));
  }

  // The bound above, with the center's barycentric coordinates for weights.
  [[nodiscard]] double radius_of(const std::vector<Xy<double>>& p) const {
    std::array<double, 3> l{1, 0, 0};
    if (p.size() == 2) l = {0.5, 0.5, 0};
    if (p.size() == 3) {
      const Xy<double> a = p[0] - center_, b = p[1] - center_, c = p[2] - center_;
      l = {(std::max)(0.0, cross(b, c) * turn(p)), (std::max)(0.0, cross(c, a) * turn(p)),
           (std::max)(0.0, cross(a, b) * turn(p))};
    }
    const double sum = l[0] + l[1] + l[2];
    if (p.empty() || p.size() > 3 || !(sum > 0)) return 0;
    double square = 0, size = 0;
    Xy<double> mean;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const Xy<double> way = p[i] - center_;
      square += l[i] / sum * dot(way, way);
      mean = mean + (l[i] / sum) * way;
      size = (std::max)(size, euclidean_norm(way));
    }
    // weights with the sum 1 + 6 u, differences, squares and sums: 32 u size^2; samples are within the error of curves
    const double least = square - dot(mean, mean) - 32 * HALF_ULP * size * size;
    return (std::max)(0.0, std::sqrt((std::max)(0.0, least)) * ROUNDED_DOWN<2> - hull_.error());
  }
  [[nodiscard]] static double turn(const std::vector<Xy<double>>& p) {
    return cross(Xy<double>(p[1] - p[0]), Xy<double>(p[2] - p[0])) < 0 ? -1 : 1;
  }

  void bound(double tolerance) {
    upper_ = farthest_ * ROUNDED_UP<8> + 2 * hull_.error();  // what was left out is inside the polygon but for that
    for (Hull_pieces::Part& p : hull_.parts()) {
      const double most = farthest(p);
      p.is_marked = most > lower_ + tolerance;
      upper_ = (std::max)(upper_, most);
    }
  }
  // Distances from a point are convex along the chord, and the piece is no farther from it than its height.  The
  // squared distance along a piece is of second order: that of an arc about the center is its own.
  [[nodiscard]] double farthest(const Hull_pieces::Part& p) const {
    const Xy<double> first = p.piece.first.point - center_, last = p.piece.last.point - center_;
    const double by_height = ((std::max)(euclidean_norm(first), euclidean_norm(last)) + p.height) * ROUNDED_UP<8>;
    const double error = hull_.curves().error(p.piece.segment);
    const Bent_piece bent(p.piece.first, p.piece.last, error);
    if (!bent.is_known) return by_height;
    const Raised_line square = from_point(bent, first, last);
    return (std::min)(by_height, std::sqrt((std::max)(square.first, square.last)) * ROUNDED_UP<16> + 2 * error);
  }

  Hull_pieces hull_;
  Xy<double> center_;
  double farthest_ = 0, lower_ = 0, upper_ = 0;
};

std::optional<Enclosing_circle<>> smallest_enclosing_circle(const Bounding_arc_tree_2& curves, double tolerance) {
  check_tolerance(tolerance);
  if (curves.empty()) return std::nullopt;
  const Unit& unit = curves.unit();
  const double asked = unit.tolerance_in(tolerance);
  const Circle_search search(curves.in_unit(), asked / 2);
  const Measure_bounds radius = measured(search.lower(), search.upper(), asked, search.is_limited());
  return Enclosing_circle<>{unit.out(search.center()), unit.bounds_out(radius)};
}

}  // namespace CGAL::Bounding_arcs::internal
