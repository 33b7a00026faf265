// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A maximal disc to 113 bits, from one in double.

#ifndef BOUNDING_ARCS_TEST_PRECISE_DISC_H
#define BOUNDING_ARCS_TEST_PRECISE_DISC_H

#include <CGAL/Bounding_arcs_2/medial_axis/maximal_disc.h>
#include "../../src/library/tree/Segment_hierarchy.h"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace bounding_arcs_test {

using Quad = boost::multiprecision::cpp_bin_float_quad;

/// The point and the derivative of a polynomial curve, by de Casteljau's algorithm.
inline std::pair<CGAL::Bounding_arcs::Xy<Quad>, CGAL::Bounding_arcs::Xy<Quad>> precise_jet(
    const CGAL::Bounding_arcs::Bezier_curve_2<double>& curve, const Quad& t) {
  using namespace CGAL::Bounding_arcs;
  std::vector<Xy<Quad>> points;
  for (const Xy<double>& p : curve.control_points()) points.push_back({p.x, p.y});
  for (std::size_t left = points.size() - 1; left > 1; --left)
    for (std::size_t i = 0; i < left; ++i) points[i] = points[i] + t * (points[i + 1] - points[i]);
  const Xy<Quad> way = points[1] - points[0];
  return {points[0] + t * way, Quad(static_cast<double>(curve.degree())) * way};
}

/// The disc that touches at `place`, and the curve of the place that it touches in double: by secants for the foot
/// there. None where that is not found within `room` of the one in double.
inline std::optional<CGAL::Bounding_arcs::Maximal_discs_2::Disc> precise_disc(
    const CGAL::Bounding_arcs::Bounding_arc_tree_2& curves, const CGAL::Bounding_arcs::Curve_place& place,
    const CGAL::Bounding_arcs::Maximal_discs_2::Disc& disc, double room) {
  using namespace CGAL::Bounding_arcs;
  const auto bezier = [&](const Curve_place& p) -> const Bezier_curve_2<double>& {
    return curves.in_unit().bezier(curves.in_unit().number_of_bezier(p.curve, p.bezier));
  };
  const auto [p, derivative] = precise_jet(bezier(place), place.t);
  const Xy<Quad> center{disc.center.x, disc.center.y};
  const Quad turn = dot(perp(derivative), center - p) > 0 ? 1 : -1;
  const Xy<Quad> normal = turn / sqrt(dot(derivative, derivative)) * perp(derivative);
  Quad radius = 0;
  const auto beside = [&](const Quad& t) -> Quad {  // how far the center is from the normal at the foot, times a length
    const auto [q, tangent] = precise_jet(bezier(*disc.touches), t);
    const Xy<Quad> way = q - p;
    radius = dot(way, way) / (2 * dot(way, normal));
    return dot(p + radius * normal - q, tangent);
  };
  Quad last = disc.touches->t, foot = last;
  if (last > 0 && last < 1) {
    constexpr double STEP = 0x1p-30;
    Quad before = beside(last);
    foot = last < 0.5 ? Quad(last + STEP) : Quad(last - STEP);
    constexpr int MOST_STEPS = 12;
    for (int step = 0; step < MOST_STEPS; ++step) {
      const Quad now = beside(foot);
      if (now == before) break;
      const Quad next = foot - now * (foot - last) / (now - before);
      last = foot;
      before = now;
      foot = next;
    }
  }
  beside(foot);
  const Xy<Quad> precise = p + radius * normal;
  const Maximal_discs_2::Disc found{
      {static_cast<double>(precise.x), static_cast<double>(precise.y)}, static_cast<double>(radius), disc.touches};
  if (!(euclidean_norm(found.center - disc.center) <= room)) return std::nullopt;
  return found;
}

}  // namespace bounding_arcs_test

#endif
