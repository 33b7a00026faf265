// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of query/convex_hull.h, which the library has compiled.

#ifndef CGAL_BOUNDING_ARCS_2_INTERNAL_QUERY_CONVEX_HULL_IMPL_H
#define CGAL_BOUNDING_ARCS_2_INTERNAL_QUERY_CONVEX_HULL_IMPL_H

#include <CGAL/Bounding_arcs_2/internal/inline.h>
#include <CGAL/Bounding_arcs_2/internal/query/Hull_chain.h>
#include <CGAL/Bounding_arcs_2/internal/query/Hull_samples.h>
#include <CGAL/Bounding_arcs_2/internal/query/polygon_measures.h>
#include <CGAL/Bounding_arcs_2/query/convex_hull.h>

#include <algorithm>
#include <optional>

namespace CGAL::Bounding_arcs {

namespace internal {

/// What the distances of a polygon's corners and lines are rounded by: differences, products, norm and quotient.
inline constexpr double POLYGON_ROUNDING = 16 * ARC_HALF_ULP;

/// Bounds of a measure of the hull that grows with it, by at most twice as much as it is widened by.
[[nodiscard]] inline Measure_bounds measure_bounds(double of_polygon, const Hull_samples& samples) {
  const double extent = diameter_of(samples.polygon()).distance, room = POLYGON_ROUNDING * extent;
  return {(std::max)(0.0, of_polygon - 2 * samples.error() - room),
          of_polygon + 2 * (samples.height() + samples.error()) + room};
}

}  // namespace internal

CGAL_BOUNDING_ARCS_INLINE Convex_hull convex_hull(const Curve_index_2& index, double tolerance) {
  check_tolerance(tolerance);
  if (index.empty()) return {};
  const internal::Hull_samples samples(index, tolerance);
  Convex_hull hull;
  hull.height = samples.height();
  const internal::Hull_chain chain(index, samples);
  for (const internal::Hull_link& l : chain.links())
    hull.pieces.push_back({l.is_curve ? Hull_piece::Kind::CURVE : Hull_piece::Kind::BITANGENT,
                           index.place_at(l.from.segment, l.from.t), index.place_at(l.to.segment, l.to.t), l.from.point,
                           l.to.point});
  return hull;
}

CGAL_BOUNDING_ARCS_INLINE std::optional<Width_of_drawing> width(const Curve_index_2& index, double tolerance) {
  check_tolerance(tolerance);
  if (index.empty()) return std::nullopt;
  const internal::Hull_samples samples(index, tolerance / 4);
  const internal::Polygon_width w = internal::width_of(samples.polygon());
  return Width_of_drawing{internal::measure_bounds(w.width, samples), (1 / euclidean_norm(w.along)) * w.along};
}

CGAL_BOUNDING_ARCS_INLINE std::optional<Diameter_of_drawing> diameter(const Curve_index_2& index, double tolerance) {
  check_tolerance(tolerance);
  if (index.empty()) return std::nullopt;
  const internal::Hull_samples samples(index, tolerance / 4);
  const internal::Corner_pair pair = internal::diameter_of(samples.polygon());
  const auto place = [&](const Xy<double>& p) {
    for (const Spiral_piece_2& piece : samples.pieces())
      for (const Spiral_sample* s : {&piece.first, &piece.last})
        if (s->point == p) return index.place_at(piece.segment, s->t);
    return Curve_place{};  // corners are ends of pieces
  };
  return Diameter_of_drawing{internal::measure_bounds(pair.distance, samples), place(pair.first), place(pair.second),
                             pair.first, pair.second};
}

}  // namespace CGAL::Bounding_arcs

#endif
