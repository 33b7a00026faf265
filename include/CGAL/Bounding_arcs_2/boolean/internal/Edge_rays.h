// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rays from points of edges to the right, which tell how often curves run round both sides of an edge.
//
//        left of it  ^  right of it         A curve that rises through the point counts 1 on its left, 0 on its right;
//   ---- . . . . . . q . . . . | . . >      one that falls 0 and -1.  Where it is level, the ray runs just below it:
//                    |         |            what is below the point counts.
//
// Edges that run together count once, by the representative of their class.
//
// All curves are closed.  A curve with all that it meets, through any number of vertices, is a group.  No loop of a
// group's edges runs round a point outside the group's box.  So a ray ends with the last box that its point is in, and
// only these groups count: a ray from one of many islands is short.
//
// The point is computed, so that the exact one is within an error of it.  What this leaves open is asked again from the
// exact point of the curve in exact arithmetic.

#ifndef CGAL_BOUNDING_ARCS_2_BOOLEAN_INTERNAL_EDGE_RAYS_H
#define CGAL_BOUNDING_ARCS_2_BOOLEAN_INTERNAL_EDGE_RAYS_H

#include <CGAL/Bounding_arcs_2/boolean/internal/Edge_pieces.h>
#include <CGAL/Bounding_arcs_2/query/Winding_search.h>
#include <CGAL/Bounding_arcs_2/query/kernel_points.h>
#include <CGAL/Bounding_arcs_2/tree/Box_tree.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/number_utils.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// How a class of edges counts on a ray, as its representative runs.
struct Ray_hit_of_edge {
  std::uint32_t edge;  ///< the representative
  int number;          ///< crossings upwards less those downwards, to the right of the point
};
/// What a ray from a point of an edge meets.
struct Edge_ray {
  std::vector<Ray_hit_of_edge> hits;     ///< not of the edge through the point, but where it is level
  std::vector<Ray_hit_of_edge> passing;  ///< edges through the point that rise or fall there: the edge itself alone
  int rise = 0;                          ///< of the edge itself: 1 upwards, -1 downwards, 0 level
  int level = 0;                         ///< where it is level, 1 to the right, -1 to the left
};

class Edge_rays {
 public:
  /// \pre all curves are closed
  explicit Edge_rays(const Edge_pieces& pieces) : pieces_(pieces), curves_(pieces.curves()) { find_groups(); }

  /// \pre the edge is the representative of its class
  /// \return nothing where it stays open
  [[nodiscard]] const std::optional<Edge_ray>& from(std::uint32_t edge) {
    const auto known = known_.find(edge);
    return known != known_.end() ? known->second : known_.emplace(edge, asked(edge)).first->second;
  }
  /// Whether it has been asked for.
  [[nodiscard]] bool knows(std::uint32_t edge) const { return known_.count(edge) != 0; }

 private:
  [[nodiscard]] std::optional<Edge_ray> asked(std::uint32_t edge) const {
    const Edge_piece own = pieces_.widest_of(edge);
    const double t = own.piece.first.t + (own.piece.last.t - own.piece.first.t) / 2;
    if (auto quick = in_doubles(own, t)) return quick;
    if (curves_.decisions() == Decisions::DOUBLE || !(own.piece.first.t < t && t < own.piece.last.t)) return {};
    return exactly(own, t);
  }
  [[nodiscard]] std::optional<Edge_ray> in_doubles(const Edge_piece& own, double t) const {
    const Spiral_sample sample = curves_.sample(own.piece.segment, t);
    Asked_point q(sample.point);
    q.error = own.error;
    Edge_ray ray;
    constexpr double CLEAR = 4;  // times the error: ends above and below the exact point's height
    const double before = q.point.y - own.piece.first.point.y, after = own.piece.last.point.y - q.point.y;
    if (before > CLEAR * own.error && after > CLEAR * own.error) ray.rise = 1;
    else if (before < -CLEAR * own.error && after < -CLEAR * own.error) ray.rise = -1;
    else if (!is_level(own, q.point.y)) return std::nullopt;
    else ray.level = own.piece.last.point.x > own.piece.first.point.x ? 1 : -1;
    if (ray.rise != 0) ray.passing.push_back({own.edge, ray.rise});
    Winding_search search(curves_, q, Decisions::DOUBLE);
    add_hits(search, q, &own, ray);
    if (search.is_undecided()) return std::nullopt;
    return ray;
  }
  // All of it is at one height, which the computed points have, too; those of a rational piece may be an ulp off.
  [[nodiscard]] bool is_level(const Edge_piece& own, double y) const {
    const auto& points = curves_.bezier(curves_.bezier_of(own.piece.segment)).control_points();
    return curves_.rounding(curves_.bezier_of(own.piece.segment)) == 0 &&
           std::all_of(points.begin(), points.end(), [&](const Xy<double>& p) { return p.y == y; }) &&
           own.piece.first.point.y == y && own.piece.last.point.y == y;
  }

  [[nodiscard]] std::optional<Edge_ray> exactly(const Edge_piece& own, double t) const {
    const auto curve = curves_.exact_bezier(curves_.bezier_of(own.piece.segment));
    const auto point = curve.point(Exact_rational(t));
    const Exact_point way =
        curve.point(Exact_rational(own.piece.last.t)) - curve.point(Exact_rational(own.piece.first.t));
    Edge_ray ray;
    ray.rise = static_cast<int>(CGAL::sign(way.y));
    if (ray.rise == 0) ray.level = static_cast<int>(CGAL::sign(way.x));
    const Asked_point q(point);
    Winding_search search(curves_, q, Decisions::EXACT);
    add_hits(search, q, nullptr, ray);
    return ray;
  }

  void find_groups() {
    const Cut_curves& cut = pieces_.cut();
    const std::size_t curves = curves_.drawing().curves().size();
    boost::disjoint_sets_with_storage<> sets(curves);
    const auto curve_of = [&](std::uint32_t c) { return cut.edges()[cut.edge_after(cut.cuts_by_vertex()[c])].curve; };
    for (std::uint32_t v = 0; v < cut.number_of_vertices(); ++v)
      for (std::uint32_t c = cut.first_at(v) + 1; c < cut.first_at(v + 1); ++c)
        sets.union_set(curve_of(c), curve_of(c - 1));
    std::vector<std::size_t> number(curves, curves);  // of the groups, by representative
    for (std::size_t curve = 0; curve < curves; ++curve) {
      std::size_t& group = number[sets.find_set(curve)];
      if (group == curves) {
        group = group_boxes_.size();
        group_boxes_.emplace_back();
      }
      group_.push_back(static_cast<std::uint32_t>(group));
    }
    for (std::uint32_t s = 0; s < curves_.number_of_segments(); ++s)
      group_boxes_[group_[curves_.place(s).curve]] += curves_.box(curves_.piece(s));
    groups_ = Box_tree(group_boxes_);
  }

  void add_hits(Winding_search& search, const Asked_point& q, const Edge_piece* own, Edge_ray& ray) const {
    const double left = q.point.x - q.error, right = q.point.x + q.error, low = q.point.y - q.error,
                 high = q.point.y + q.error;
    const auto meets_ray = [&](const CGAL::Bbox_2& box) {
      return box.ymin() <= high && low <= box.ymax() && left <= box.xmax();
    };
    const auto holds_point = [&](const CGAL::Bbox_2& box) { return meets_ray(box) && box.xmin() <= right; };
    double end = right;  // of the ray
    for_each_item(
        groups_, [&](const Box_tree::Node& node, std::size_t k) { return holds_point(node.box(k)); },
        [&](const Box_tree::Node& node, std::size_t k) {
          end = (std::max)(end, node.x_high[k]);
          return true;
        });
    const auto is_met = [&](const Box_tree::Node& node, std::size_t k) {
      return meets_ray(node.box(k)) && node.x_low[k] <= end;
    };
    for_each_item(curves_.boxes(), is_met, [&](const Box_tree::Node& node, std::size_t k) {
      if (!holds_point(group_boxes_[group_[curves_.place(node.child[k]).curve]])) return true;
      pieces_.for_each_of_segment(node.child[k], [&](const Edge_piece& p) {
        if (pieces_.cut().edges()[p.edge].representative != p.edge) return;
        if (own != nullptr && p.piece.segment == own->piece.segment && p.piece.first.t == own->piece.first.t) return;
        const int passed = search.passing();
        if (const int number = search.crossings_of(p.piece, p.error)) ray.hits.push_back({p.edge, number});
        if (search.passing() != passed) ray.passing.push_back({p.edge, search.passing() - passed});
      });
      return !search.is_undecided();
    });
  }

  const Edge_pieces& pieces_;
  const Segment_hierarchy& curves_;
  std::vector<std::uint32_t> group_;  // by curve
  std::vector<CGAL::Bbox_2> group_boxes_;
  Box_tree groups_;
  std::unordered_map<std::uint32_t, std::optional<Edge_ray>> known_;  // by edge
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
