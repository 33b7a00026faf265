// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of medial_axis/maximal_disc.h.

#include <CGAL/Bounding_arcs_2/curve/Unit.h>
#include <CGAL/Bounding_arcs_2/medial_axis/maximal_disc.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/query/closest_point.h>
#include <CGAL/Bounding_arcs_2/query/point_location.h>
#include "../query/query_units.h"
#include "../tree/Segment_hierarchy.h"
#include "Disc_search.h"
#include "Line_parts.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>

namespace CGAL::Bounding_arcs {

namespace internal {

[[nodiscard]] static Bounding_parts bounds_of_closed(const Bounding_arc_tree_2& curves, Fill_rule rule) {
  check_closed(curves.drawing());
  Medial_axis_2::Options options;
  options.rule = rule;
  const Segment_hierarchy& in_unit = curves.in_unit();
  return bounding_parts(in_unit, options, CLOSE_WALLS * in_unit.drawing().coordinate_size());
}

}  // namespace internal

struct Maximal_discs_2::Boundary {
  const Bounding_arc_tree_2& curves;
  Bounding_parts bounds;
  internal::Axis_boundary boundary;
  internal::Foot_runs places;

  Boundary(const Bounding_arc_tree_2& tree, Fill_rule rule)
      : curves(tree), bounds(internal::bounds_of_closed(tree, rule)), boundary(bounds), places(bounds, 0) {}

  [[nodiscard]] Maximal_discs_2::Disc at(const internal::Boundary_place& p) const;
};

Maximal_discs_2::Maximal_discs_2(const Bounding_arc_tree_2& tree, Fill_rule rule)
    : boundary_(std::make_shared<const Boundary>(tree, rule)) {}

std::optional<Maximal_discs_2::Disc> Maximal_discs_2::operator()(const Curve_place& place) const {
  const auto& all = boundary_->curves.drawing().curves();
  if (place.curve >= all.size() || place.bezier >= all[place.curve].beziers.size() || !(place.t >= 0 && place.t <= 1))
    throw std::invalid_argument(
        expected("place", "one of the drawing",
                 "curve " + text_of(place.curve) + ", piece " + text_of(place.bezier) + ", t " + text_of(place.t)));
  const Segment_hierarchy& parts = boundary_->bounds.segments;
  const auto segment = boundary_->places.segment_at(parts.number_of_bezier(place.curve, place.bezier), place.t);
  if (!segment || place.t < parts.piece(*segment).first.t || place.t > parts.piece(*segment).last.t)
    return std::nullopt;
  for (const std::uint32_t e : boundary_->boundary.sides(*segment))
    if (e != internal::Axis_boundary::NONE) return boundary_->at(boundary_->boundary.place(e, place.t));
  return std::nullopt;
}

Maximal_discs_2::Disc Maximal_discs_2::Boundary::at(const internal::Boundary_place& p) const {
  const internal::Boundary_jet jet = boundary(p);
  const double curvature = jet.speed > 0 ? jet.turn / jet.speed : 0;
  double most = boundary.largest_radius();
  if (curvature * most > 1) most = 1 / curvature;
  // along a spiral segment no disc touches twice: another place is on another segment
  const auto others = [&](std::uint32_t e, const auto& visit) {
    const internal::Boundary_element& other = boundary.element(e);
    if (other.segment != boundary.element(p.element).segment) visit(other.first, other.last);
  };
  internal::Disc_search search(boundary, others, jet, most);
  search.search();
  Maximal_discs_2::Disc disc{curves.unit().out(search.disc().center), curves.unit().out(search.disc().radius),
                             std::nullopt};
  if (search.is_found()) disc.touches = boundary.curve_place(search.place());
  return disc;
}

std::optional<Medial_axis_2::Inscribed_disc> largest_inscribed_disc(const Bounding_arc_tree_2& curves,
                                                                    const Medial_axis_2& axis) {
  if (axis.vertices.empty()) return std::nullopt;
  const Medial_axis_2::Vertex* vertex = &axis.vertices.front();
  for (const Medial_axis_2::Vertex& v : axis.vertices)
    if (v.radius > vertex->radius) vertex = &v;
  Xy<double> center = vertex->center;
  double most = vertex->radius;
  for (const Medial_axis_2::Edge& e : axis.edges)
    for (const Medial_axis_2::Sample& s : e.samples)
      if (s.radius > most) most = s.radius, center = s.center;
  const internal::Unit& unit = curves.unit();
  const Bracket in_unit = closest_point(internal::bounds_of(axis, curves.in_unit())->segments, point_in(unit, center))
                              ->distance,
                found = unit.bounds_out(in_unit);
  return Medial_axis_2::Inscribed_disc{center, {found.lower, (std::max)(found.upper, most + axis.eps)}};
}

}  // namespace CGAL::Bounding_arcs
