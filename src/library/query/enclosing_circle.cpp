// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of query/enclosing_circle.h.

#include "Farthest_bound.h"
#include "Hull_samples.h"
#include "query_units.h"

#include <CGAL/Bounding_arcs_2/query/enclosing_circle.h>
#include "../tree/Segment_hierarchy.h"
#include "Work_limit.h"

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
  /// \param is_fine whether bounds of farthest points shall be worth more time
  Circle_search(const Segment_hierarchy& curves, const Hull_samples& samples, double tolerance, bool is_fine)
      : curves_(curves), is_fine_(is_fine), pieces_(samples.pieces()), error_(samples.error()),
        limit_(most_pieces(curves.number_of_segments())) {
    points_ = samples.polygon();
    inner_height_ = error_;  // what was left out is inside the polygon but for that
    do {
      enclose();
    } while (refine(tolerance));
  }

  [[nodiscard]] const Xy<double>& center() const { return center_; }
  [[nodiscard]] double lower() const { return lower_; }
  [[nodiscard]] double upper() const { return upper_; }
  /// Whether pieces were left as they were, as there were too many.
  [[nodiscard]] bool is_limited() const { return limit_.is_reached(); }

 private:
  // Seen from the first point, so that coordinates far from the origin lose nothing.
  void enclose() {
    using Kernel = CGAL::Simple_cartesian<double>;
    using Traits = CGAL::Min_sphere_of_points_d_traits_2<Kernel, double>;
    std::vector<Kernel::Point_2> points;
    const Xy<double> o = points_.front();
    for (const Xy<double>& p : points_) points.emplace_back(p.x - o.x, p.y - o.y);
    CGAL::Min_sphere_of_spheres_d<Traits> sphere(points.begin(), points.end());
    const auto* c = sphere.center_cartesian_begin();
    center_ = o + Xy<double>{c[0], c[1]};
    std::vector<Xy<double>> support;
    for (auto i = sphere.support_begin(); i != sphere.support_end(); ++i)
      support.push_back(o + Xy<double>{(*i).x(), (*i).y()});
    lower_ = (std::max)(lower_, radius_of(support));
    farthest_ = 0;
    for (const Xy<double>& p : points_) farthest_ = (std::max)(farthest_, euclidean_norm(p - center_));
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
    return (std::max)(0.0, std::sqrt((std::max)(0.0, least)) * ROUNDED_DOWN<2> - error_);
  }
  [[nodiscard]] static double turn(const std::vector<Xy<double>>& p) {
    return cross(Xy<double>(p[1] - p[0]), Xy<double>(p[2] - p[0])) < 0 ? -1 : 1;
  }

  // \return whether there is something to do better
  bool refine(double tolerance) {
    upper_ = farthest_ * ROUNDED_UP<8> + 2 * inner_height_;
    std::vector<Spiral_piece_2> next;
    bool is_changed = false;
    for (const Spiral_piece_2& p : pieces_) {
      const double most = farthest(p);
      const double least_height = 64 * curves_.error(p.segment);
      const bool is_fine = most <= lower_ + tolerance || height_of(curves_.region(p)) <= least_height;
      const auto middle = is_fine || !limit_.spend() ? std::optional<Spiral_halves_2>() : halves(curves_, p);
      if (!middle) {
        upper_ = (std::max)(upper_, most);
        next.push_back(p);
        continue;
      }
      is_changed = true;
      next.push_back(middle->first);
      next.push_back(middle->second);
      const Xy<double>& q = middle->first.last.point;
      if (euclidean_norm(q - center_) > lower_) points_.push_back(q);
    }
    pieces_ = std::move(next);
    if (is_changed) points_ = convex_polygon(points_);
    return is_changed;
  }
  // Distances from a point are convex along the chord, and the piece is no farther from it than its height.
  [[nodiscard]] double farthest(const Spiral_piece_2& p) const {
    const Fat_arc_2 fat = curves_.region(p);
    const double d = (std::max)(euclidean_norm(fat.arc.from - center_), euclidean_norm(fat.arc.to - center_));
    const double by_height = (d + height_of(fat)) * ROUNDED_UP<8>;
    return is_fine_ ? (std::min)(by_height, farthest_along(p)) : by_height;
  }
  // The squared distance from one point along a piece, of second order: that of an arc about the center is its own.
  [[nodiscard]] double farthest_along(const Spiral_piece_2& p) const {
    const double error = curves_.error(p.segment);
    const Bent_piece bent(p.first, p.last, error);
    if (!bent.is_known) return std::numeric_limits<double>::infinity();
    const Raised_line square = from_point(bent, p.first.point - center_, p.last.point - center_);
    return std::sqrt((std::max)(square.first, square.last)) * ROUNDED_UP<16> + 2 * error;
  }

  const Segment_hierarchy& curves_;
  bool is_fine_;
  std::vector<Spiral_piece_2> pieces_;
  Convex_polygon points_;
  Xy<double> center_;
  double error_, inner_height_ = 0, farthest_ = 0, lower_ = 0, upper_ = 0;
  Work_limit limit_;
};

std::optional<Enclosing_circle<>> smallest_enclosing_circle(const Bounding_arc_tree_2& curves, double tolerance) {
  check_tolerance(tolerance);
  if (curves.empty()) return std::nullopt;
  constexpr double ROUGH = 0x1p-7;  // of the extent: what is well inside is looked at no more
  const Unit& unit = curves.unit();
  const Segment_hierarchy& in_unit = curves.in_unit();
  const double asked = unit.tolerance_in(tolerance), rough = ROUGH * extent_of(in_unit);
  const Circle_search search(in_unit, Hull_samples(in_unit, rough), asked / 2, is_fine(in_unit, asked));
  const Measure_bounds radius{search.lower(), search.upper(),
                              status_of(search.upper() - search.lower(), asked, search.is_limited())};
  return Enclosing_circle<>{unit.out(search.center()), unit.bounds_out(radius)};
}

}  // namespace CGAL::Bounding_arcs::internal
