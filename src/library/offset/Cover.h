// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether a point is nearer to the sources than the distance of an offset.
//
// Where all joins and caps are round that is the distance to arcs.  Else what an offset takes is the union of the
// normals of all arcs, as far as their centers, and of the shapes of joins and caps: only feet inside arcs count, and
// only on sides that are offset.

#ifndef BOUNDING_ARCS_LIBRARY_OFFSET_COVER_H
#define BOUNDING_ARCS_LIBRARY_OFFSET_COVER_H

#include "Raw_offset.h"
#include "Source_arcs.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

[[nodiscard]] inline double squared_box_distance(const Xy<double>& q, const CGAL::Bbox_2& b) {
  const double dx = (std::max)((std::max)(b.xmin() - q.x, q.x - b.xmax()), 0.0),
               dy = (std::max)((std::max)(b.ymin() - q.y, q.y - b.ymax()), 0.0);
  return dx * dx + dy * dy;
}
/// How far inside a shape q is; negative outside.
[[nodiscard]] inline double depth_in(const Raw_shape& shape, const Xy<double>& q) {
  double least = HUGE_VAL;
  for (std::size_t i = 0; i < shape.size; ++i) {
    const Xy<double>&p = shape.corners[i], side = shape.corners[(i + 1) % shape.size] - p;
    const double length = euclidean_norm(side);
    if (i == 1 && shape.radius > 0) least = (std::min)(least, shape.radius - euclidean_norm(q - shape.corners[0]));
    else if (length > 0) least = (std::min)(least, -cross(side, q - p) / length);
  }
  return least;
}

/// Which sides of a curve are offset.
struct Offset_sides {
  bool left, right;
};

class Cover {
 public:
  /// \param sides of the curves of the sources that are offset
  Cover(const Source_arcs& sources, double distance, const std::vector<Offset_sides>& sides,
        const std::vector<Raw_shape>& shapes, bool is_round)
      : sources_(sources), sides_(sides), shapes_(shapes), is_round_(is_round), distance_(distance) {
    if (is_round) return;
    std::vector<CGAL::Bbox_2> boxes;
    for (const Raw_shape& s : shapes) {
      CGAL::Bbox_2 box;
      for (std::size_t i = 0; i < s.size; ++i) {
        const Xy<double>& p = s.corners[i];
        box += CGAL::Bbox_2(p.x - s.radius, p.y - s.radius, p.x + s.radius, p.y + s.radius);
      }
      boxes.push_back(box);
    }
    tree_ = Box_tree(boxes);
  }

  [[nodiscard]] double distance() const { return distance_; }
  /// Whether q is covered, by more than a depth.
  [[nodiscard]] bool covers(const Xy<double>& q, double depth) const {
    const double reach = distance_ - depth;
    if (reach <= 0) return false;
    return any_near(sources_.blocks().tree(), q, reach * reach,
                    [&](std::uint32_t b) { return in_block(b, q, depth); }) ||
           (!is_round_ && any_near(tree_, q, 0, [&](std::uint32_t s) { return depth_in(shapes_[s], q) > depth; }));
  }

 private:
  // Whether one of the items has what is asked for whose boxes are no farther than the root of a square.
  template <class Has>
  [[nodiscard]] static bool any_near(const Box_tree& tree, const Xy<double>& q, double square, const Has& has) {
    const auto is_near = [&](const Box_tree::Node& node, std::size_t k) {
      return squared_distance(q, node, k) <= square;
    };
    return !for_each_item(tree, is_near,
                          [&](const Box_tree::Node& node, std::size_t k) { return !has(node.child[k]); });
  }
  [[nodiscard]] bool in_block(std::uint32_t number, const Xy<double>& q, double depth) const {
    const Arc_block& block = sources_.blocks().block(number);
    const double reach = distance_ - depth, most = reach * reach;
    const Offset_sides& sides = sides_[block.chain];
    for (std::uint32_t i = block.begin; i < block.end; ++i) {
      const Arc_2& arc = sources_.arcs[i].arc;
      if (squared_box_distance(q, box_about(arc)) >= most) continue;
      if (!is_round_ && !is_between_normals(q, arc, depth)) continue;
      const double away = signed_distance(q, arc);
      if (std::fabs(away) < reach && (is_round_ || (away > 0 ? sides.left : sides.right))) return true;
    }
    return false;
  }

  // By more than a depth: straight caps are on the normals of ends.
  [[nodiscard]] static bool is_between_normals(const Xy<double>& q, const Arc_2& arc, double depth) {
    const End_normals n = end_normals(arc);
    const Xy<double> t0{n.n0.y, -n.n0.x}, t1{n.n1.y, -n.n1.x};
    return dot(t0, q - arc.from) > depth && dot(t1, q - arc.to) < -depth;
  }

  const Source_arcs& sources_;
  const std::vector<Offset_sides>& sides_;
  const std::vector<Raw_shape>& shapes_;
  bool is_round_;
  double distance_;
  Box_tree tree_;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
