// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of overlay/overlay.h: what the engine has found, as plain lists.
//
//   trees -> one list of segments -> Overlay -> vertices with brackets, edges with their sources, faces in an order of
//   visits

#include "Boundary_sum.h"
#include "Overlay.h"
#include "United_curves.h"

#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/overlay/overlay.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>
#include "../tree/Segment_hierarchy.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

namespace {

/// A box that holds a point.
struct Point_box {
  Bracket x, y;

  void cut(const Point_box& other) {
    x = {(std::max)(x.lower, other.x.lower), (std::min)(x.upper, other.x.upper)};
    y = {(std::max)(y.lower, other.y.lower), (std::min)(y.upper, other.y.upper)};
  }
};

/// The box of a Bezier piece's points with parameters in a bracket: by its derivative, and by its control points.
[[nodiscard]] Point_box box_at(const Segment_hierarchy& curves, std::uint32_t bezier, const Bracket& t) {
  const Bezier_evaluator& curve = curves.evaluator(bezier);
  const double rounding = curves.rounding(bezier), at = t.middle();
  const Curve_jet jet = curve(at);
  constexpr double ROUNDED_UP_HALF = 0.5 * (1 + 0x1p-40), UP = 1 + 0x1p-40;
  const double reach = t.is_single() ? 0 : ROUNDED_UP_HALF * t.width() + std::numeric_limits<double>::denorm_min();
  const double slack = curve.errors_at(at, jet).first + curve.first_change(rounding) +
                       reach * (curve.second_bound() + curve.second_change(rounding));
  const double error = rounding + (is_end_of_piece(t) ? 0 : curve.point_error());  // of the point
  Point_box box{range_around(jet.point.x, (error + reach * (std::fabs(jet.first.x) + slack)) * UP),
                range_around(jet.point.y, (error + reach * (std::fabs(jet.first.y) + slack)) * UP)};
  const auto& points = curve.curve().control_points();
  const auto [left, right] = std::minmax_element(points.begin(), points.end(),
                                                 [](const Xy<double>& p, const Xy<double>& q) { return p.x < q.x; });
  const auto [low, high] = std::minmax_element(points.begin(), points.end(),
                                               [](const Xy<double>& p, const Xy<double>& q) { return p.y < q.y; });
  box.cut({{range_around(left->x, rounding).lower, range_around(right->x, rounding).upper},
           {range_around(low->y, rounding).lower, range_around(high->y, rounding).upper}});
  return box;
}

/// Writes the engine's cells. A curve that is one point on no other curve is an edge there, and a vertex here.
class Overlay_writer {
 public:
  Overlay_writer(const Overlay& overlay, const United_curves& united, std::size_t operands)
      : overlay_(overlay), cut_(overlay.cut()), united_(united), unit_(united.unit),
        edges_(cut_.edges().size(), NO_NUMBER), faces_(overlay.number_of_faces(), NO_NUMBER) {
    result_.number_of_operands = operands;
    number_faces();
    add_vertices();
    add_edges();
    add_boundaries();
  }
  [[nodiscard]] Overlay_2& result() { return result_; }

 private:
  // Faces in the order of visits, so that a face comes after the one that its way out leads to.
  void number_faces() {
    std::optional<Edge_side> over;
    overlay_.for_each_face([&](Edge_side s) { over = s; },
                           [&](std::uint32_t face) {
                             faces_[face] = static_cast<std::uint32_t>(ways_out_.size());
                             ways_out_.push_back(over ? other_side(*over) : NO_NUMBER);
                           });
  }

  void add_vertices() {
    result_.vertices.resize(cut_.number_of_vertices());
    for (std::uint32_t v = 0; v < cut_.number_of_vertices(); ++v) {
      std::optional<Point_box> box;
      bool has_edge = false;
      for (std::uint32_t i = cut_.first_at(v); i < cut_.first_at(v + 1); ++i) {
        const std::uint32_t cut = cut_.cuts_by_vertex()[i];
        const Joint_place& at = cut_.cuts()[cut].at;
        const Point_box own = box_at(overlay_.curves(), at.bezier, at.t);
        if (box) box->cut(own);
        else box = own;
        for (const std::uint32_t e : {cut_.edge_after(cut), cut_.edge_before(cut)})
          has_edge = has_edge || (e != NO_NUMBER && cut_.edges()[e].representative != NO_NUMBER);
      }
      set_vertex(result_.vertices[v], overlay_.points()[v], *box);
      if (!has_edge) result_.vertices[v].face = faces_[overlay_.face_around(curve_at(v))];
    }
  }
  [[nodiscard]] std::uint32_t curve_at(std::uint32_t vertex) const {
    return static_cast<std::uint32_t>(
        overlay_.curves().curve_of_bezier(cut_.cuts()[cut_.cuts_by_vertex()[cut_.first_at(vertex)]].at.bezier));
  }
  void set_vertex(Overlay_2::Vertex& vertex, const Xy<double>& point, const Point_box& box) const {
    vertex.x = unit_.bounds_out(box.x);
    vertex.y = unit_.bounds_out(box.y);
    const Xy<double> at = unit_.out(point);
    vertex.point = {std::clamp(at.x, vertex.x.lower, vertex.x.upper), std::clamp(at.y, vertex.y.lower, vertex.y.upper)};
  }

  void add_edges() {
    for (std::uint32_t e = 0; e < cut_.edges().size(); ++e) {
      if (!cut_.is_representative(e)) continue;
      const Cut_edge& edge = cut_.edges()[e];
      const bool has_ends = edge.first != NO_NUMBER;
      if (!has_ends && add_lone_point(edge.curve)) continue;
      edges_[e] = static_cast<std::uint32_t>(result_.edges.size());
      Overlay_2::Edge& made = result_.edges.emplace_back();
      if (has_ends) {
        made.from = overlay_.vertex_at(e, true);
        made.to = overlay_.vertex_at(e, false);
      }
      made.left = faces_[overlay_.face_of(side_of(e, false))];
      made.right = faces_[overlay_.face_of(side_of(e, true))];
      for (std::uint32_t member = e; member != NO_NUMBER; member = cut_.next_member(member))
        made.sources.push_back(source(member));
    }
  }
  [[nodiscard]] bool add_lone_point(std::uint32_t curve) {
    const std::uint32_t bezier = overlay_.curves().number_of_bezier(curve, 0);
    if (!cut_.is_point(bezier)) return false;
    Overlay_2::Vertex& vertex = result_.vertices.emplace_back();
    const Xy<double>& point = overlay_.curves().bezier(bezier).control_points().front();
    set_vertex(vertex, point, box_at(overlay_.curves(), bezier, {0, 0}));
    vertex.face = faces_[overlay_.face_around(curve)];
    return true;
  }
  [[nodiscard]] Overlay_2::Source source(std::uint32_t e) const {
    const Cut_edge& edge = cut_.edges()[e];
    std::vector<Bezier_span> spans = cut_.spans_of(e);
    if (edge.is_against) std::reverse(spans.begin(), spans.end());
    const Operand_bezier& first = united_.beziers[spans.front().bezier];
    Overlay_2::Source source{
        first.operand, first.curve, overlay_.curves().drawing().curves()[edge.curve].is_closed, edge.is_against, {}};
    source.parts.reserve(spans.size());
    for (const Bezier_span& s : spans)
      source.parts.push_back(
          {united_.beziers[s.bezier].bezier, edge.is_against ? s.to : s.from, edge.is_against ? s.from : s.to});
    return source;
  }

  void add_boundaries() {
    result_.faces.resize(faces_.size());
    for (std::uint32_t f = 0; f < faces_.size(); ++f) {
      Overlay_2::Face& face = result_.faces[faces_[f]];
      face.is_bounded = f != 0;
      if (face.is_bounded) face.way_out = public_side(ways_out_[faces_[f]]);
      for (const std::uint32_t ring : overlay_.rings_of_face(f)) {
        std::vector<Overlay_2::Side> boundary;
        for (const Edge_side s : overlay_.sides_of_ring(ring))
          if (edges_[edge_of(s)] != NO_NUMBER) boundary.push_back(public_side(s));
        if (!boundary.empty()) face.boundaries.push_back(std::move(boundary));  // else it is that of a lone point
      }
    }
  }
  [[nodiscard]] Overlay_2::Side public_side(Edge_side s) const { return {edges_[edge_of(s)], is_reversed(s)}; }

  const Overlay& overlay_;
  const Cut_curves& cut_;
  const United_curves& united_;
  const Unit& unit_;
  std::vector<std::uint32_t> edges_, faces_;  // their numbers here
  std::vector<Edge_side> ways_out_;           // by face here
  Overlay_2 result_;
};

}  // namespace

}  // namespace CGAL::Bounding_arcs::internal

namespace CGAL::Bounding_arcs {

Overlay_2 overlay(const std::vector<const Bounding_arc_tree_2*>& trees, const Overlay_2::Options& options) {
  const internal::United_curves united = internal::united_curves(trees, internal::Lone_points::KEPT);
  const internal::Overlay cells(*united.segments, options.at_joints);
  if (!cells.open()) return std::move(internal::Overlay_writer(cells, united, trees.size()).result());
  Overlay_2 result;
  result.number_of_operands = trees.size();
  result.status = Overlay_2::Status::UNDECIDED;
  result.undecided = internal::undecided_meeting(*cells.open(), united);
  return result;
}

Measure_bounds Overlay_2::face_area(const std::vector<const Bounding_arc_tree_2*>& trees, std::uint32_t face,
                                    double eps) const {
  check_tolerance(eps);
  const Face& of = faces.at(face);
  if (!of.is_bounded) throw std::invalid_argument(expected("face", "a bounded face", "the unbounded one"));
  internal::Boundary_sum sum;
  for (const std::vector<Side>& boundary : of.boundaries) {
    for (const Side& side : boundary) {
      const Source& along = edges[side.edge].sources.front();
      const auto add = [&](const Part& part) {
        const auto bezier = trees.at(along.operand)->exact_bezier(along.curve, part.bezier);
        sum.add(bezier, side.is_reversed ? part.to : part.from, side.is_reversed ? part.from : part.to);
      };
      if (side.is_reversed) std::for_each(along.parts.rbegin(), along.parts.rend(), add);
      else std::for_each(along.parts.begin(), along.parts.end(), add);
    }
    sum.close();
  }
  return sum.bounds(eps);
}

}  // namespace CGAL::Bounding_arcs
