// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of query/convex_hull.h.

#include <CGAL/Bounding_arcs_2/query/Work_limit.h>
#include <CGAL/Bounding_arcs_2/query/convex_hull.h>
#include "Hull_chain.h"
#include "Hull_outline.h"
#include "Hull_parts.h"
#include "Hull_samples.h"
#include "polygon_measures.h"
#include "query_units.h"

#include <algorithm>
#include <optional>

namespace CGAL::Bounding_arcs::internal {

/// What the distances of a polygon's corners and lines are rounded by: differences, products, norm and quotient.
constexpr double POLYGON_ROUNDING = 16 * HALF_ULP;

/// Makes parts of the hull, whose pieces are halved where they matter.
[[nodiscard]] static Hull_parts hull_parts(const Segment_hierarchy& curves) {
  constexpr double ROUGH = 0x1p-10;  // of the extent
  return {curves, Hull_samples(curves, ROUGH * extent_of(curves))};
}

/// Bounds of a measure of the hull that is between that of a polygon of samples and one so much larger.
[[nodiscard]] static Measure_bounds measure_bounds(double of_polygon, double more, double extent, double error,
                                                   double tolerance, bool is_limited) {
  const double room = POLYGON_ROUNDING * extent, lower = (std::max)(0.0, of_polygon - 2 * error - room),
               upper = of_polygon + more + room;
  return {lower, upper, status_of(upper - lower, tolerance, is_limited)};
}
/// Bounds a measure by samples: such a measure grows by at most twice as much as the hull is widened by.
[[nodiscard]] static Measure_bounds measure_bounds(double of_polygon, const Hull_samples& samples, double tolerance) {
  return measure_bounds(of_polygon, 2 * (samples.height() + samples.error()), diameter_of(samples.polygon()).distance,
                        samples.error(), tolerance, samples.is_limited());
}
/// Bounds a measure by parts, which reach no farther than `most` but for the error of their ends.
[[nodiscard]] static Measure_bounds measure_bounds(double of_polygon, double most, const Hull_parts& parts,
                                                   double tolerance) {
  return measure_bounds(of_polygon, (most - of_polygon) + 2 * parts.error(), diameter_of(parts.polygon()).distance,
                        parts.error(), tolerance, parts.is_limited());
}

/// \param samples, tolerance in the curves's unit
template <class Samples>
[[nodiscard]] Convex_hull<> hull_of(const Bounding_arc_tree_2& curves, const Samples& samples, double tolerance) {
  const Unit& unit = curves.unit();
  Convex_hull<> hull;
  hull.height = unit.bounds_out(Measure_bounds{0, samples.height()}).upper;
  // pieces that are as high as was asked are within it but for the errors of their ends
  hull.status = status_of(samples.height() - 2 * samples.error(), tolerance, samples.is_limited());
  const Hull_chain chain(curves.in_unit(), samples.polygon(), samples.pieces());
  for (const Hull_link& l : chain.links())
    hull.pieces.push_back({l.is_curve ? Hull_piece_kind::CURVE : Hull_piece_kind::BITANGENT,
                           curves.in_unit().place_at(l.from.segment, l.from.t),
                           curves.in_unit().place_at(l.to.segment, l.to.t), unit.out(l.from.point),
                           unit.out(l.to.point)});
  return hull;
}

[[nodiscard]] static Width_of_drawing<> width_by_samples(const Segment_hierarchy& curves, double tolerance) {
  const Hull_samples samples(curves, tolerance / 4);
  const Polygon_width w = width_of(samples.polygon());
  return {measure_bounds(w.width, samples, tolerance), (1 / euclidean_norm(w.along)) * w.along};
}
[[nodiscard]] static Width_of_drawing<> width_by_parts(const Segment_hierarchy& curves, double tolerance) {
  Hull_parts parts = hull_parts(curves);
  const Width_search search(parts, tolerance / 2);
  const Found_width& f = search.found();
  return {measure_bounds(f.width.width, f.upper, parts, tolerance), (1 / euclidean_norm(f.along)) * f.along};
}

// Corners are ends of pieces.
[[nodiscard]] static Curve_place place_of_sample(const Segment_hierarchy& curves, const Spiral_piece_2& piece,
                                                 const Xy<double>& p, const Curve_place& other) {
  for (const Spiral_sample* s : {&piece.first, &piece.last})
    if (s->point == p) return curves.place_at(piece.segment, s->t);
  return other;
}
[[nodiscard]] static Diameter_of_drawing<> diameter_by_samples(const Segment_hierarchy& curves, double tolerance) {
  const Hull_samples samples(curves, tolerance / 4);
  const Corner_pair pair = diameter_of(samples.polygon());
  const auto place = [&](const Xy<double>& p) {
    Curve_place found{};
    for (auto i = samples.pieces().rbegin(); i != samples.pieces().rend(); ++i)
      found = place_of_sample(curves, *i, p, found);
    return found;
  };
  return {measure_bounds(pair.distance, samples, tolerance), place(pair.first), place(pair.second), pair.first,
          pair.second};
}
/// \return nothing where too many pieces are as far from each other
[[nodiscard]] static std::optional<Diameter_of_drawing<>> diameter_by_parts(const Segment_hierarchy& curves,
                                                                            double tolerance) {
  Hull_parts parts = hull_parts(curves);
  const auto found = find_diameter(parts, tolerance / 2);
  if (!found) return std::nullopt;
  const auto& [pair, upper] = *found;
  const auto place = [&](const Xy<double>& p) {
    Curve_place at{};
    for (const Hull_parts::Part& part : parts.parts()) at = place_of_sample(curves, part.piece, p, at);
    return at;
  };
  return Diameter_of_drawing<>{measure_bounds(pair.distance, upper, parts, tolerance), place(pair.first),
                               place(pair.second), pair.first, pair.second};
}

Convex_hull<> convex_hull(const Bounding_arc_tree_2& curves, double tolerance) {
  check_tolerance(tolerance);
  if (curves.empty()) return {};
  const double asked = curves.unit().tolerance_in(tolerance);
  if (is_fine(curves.in_unit(), asked)) return hull_of(curves, Hull_outline(curves.in_unit(), asked), asked);
  return hull_of(curves, Hull_samples(curves.in_unit(), asked), asked);
}

std::optional<Width_of_drawing<>> width(const Bounding_arc_tree_2& curves, double tolerance) {
  check_tolerance(tolerance);
  if (curves.empty()) return std::nullopt;
  const double asked = curves.unit().tolerance_in(tolerance);
  const Segment_hierarchy& in_unit = curves.in_unit();
  Width_of_drawing<> found =
      is_fine(in_unit, asked) ? width_by_parts(in_unit, asked) : width_by_samples(in_unit, asked);
  found.width = curves.unit().bounds_out(found.width);
  return found;
}

std::optional<Diameter_of_drawing<>> diameter(const Bounding_arc_tree_2& curves, double tolerance) {
  check_tolerance(tolerance);
  if (curves.empty()) return std::nullopt;
  const Unit& unit = curves.unit();
  const double asked = unit.tolerance_in(tolerance);
  const Segment_hierarchy& in_unit = curves.in_unit();
  std::optional<Diameter_of_drawing<>> found;
  if (is_fine(in_unit, asked)) found = diameter_by_parts(in_unit, asked);
  if (!found) found = diameter_by_samples(in_unit, asked);
  found->diameter = unit.bounds_out(found->diameter);
  found->first_point = unit.out(found->first_point), found->second_point = unit.out(found->second_point);
  return found;
}

}  // namespace CGAL::Bounding_arcs::internal
