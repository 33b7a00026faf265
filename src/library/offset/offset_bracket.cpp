// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of offset/offset_bracket.h and offset/offset_series.h.

#include "Offset_sources.h"

#include <CGAL/Bounding_arcs_2/arc/arc_beziers.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/offset/Offset_source_2.h>
#include <CGAL/Bounding_arcs_2/offset/offset_bracket.h>
#include <CGAL/Bounding_arcs_2/offset/offset_series.h>
#include <CGAL/Bounding_arcs_2/query/distance.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

Offset::Bounds offset_bracket(const Bounding_arc_tree_2& tree, double d, double eps, const Offset::Options& options) {
  if (!(std::fabs(d) > eps))
    throw std::invalid_argument(expected("distance", "a number above eps, " + text_of(eps), d));
  if (options.join != Offset::Join::ROUND || options.cap != Offset::Cap::ROUND || options.side != Offset::Side::BOTH)
    throw std::invalid_argument(
        expected("options", "round joins and caps, and both sides", "another join, cap or side"));
  const auto& curves = tree.drawing().curves();
  const bool has_closed = std::any_of(curves.begin(), curves.end(), [](const auto& c) { return c.is_closed; });
  if (!has_closed) d = std::fabs(d);  // a band grows with |d|
  const double beside = eps / 4;
  const Offset_source_2 source(tree, beside, options);
  return {source.at(d - beside), source.at(d + beside)};
}

Offset sleeve(const Arc_region_2& region, double d, double eps) {
  check_above_zero("distance", d);
  Offset::Chain boundary;
  const auto add = [&](const Xy<double>& from, const Xy<double>& to, double bulge) {
    if (from != to) boundary.pieces.push_back({{from, to, bulge}, {}, 1, Offset::Kind::CURVE, true, 0});
  };
  const Arc_region_2::Side &inner = region.inner, &outer = region.outer;
  add(region.from, inner.size == 1 ? region.to : inner.joint, inner.bulges[0]);
  if (inner.size == 2) add(inner.joint, region.to, inner.bulges[1]);
  if (outer.size == 2) add(region.to, outer.joint, -outer.bulges[1]);
  add(outer.size == 1 ? region.to : outer.joint, region.from, -outer.bulges[0]);
  const double beside = eps / 2, widening = std::isfinite(region.widening) ? region.widening : 0;
  return Offset_source_2({boundary}, beside).at(d + widening + beside);
}

Drawing_2<double> Offset::drawing() const {
  Drawing_2<double> result;
  for (const Chain& chain : chains) {
    std::vector<Bezier_curve_2<double>> beziers;
    const auto finish = [&] {
      if (!beziers.empty()) result.add(std::exchange(beziers, {}));
    };
    for (const Offset::Piece& piece : chain.pieces) {
      if (!piece.is_round) finish();
      else
        for (Bezier_curve_2<double>& part : arc_beziers(piece.arc.from, piece.arc.to, piece.arc.bulge))
          beziers.push_back(std::move(part));
    }
    finish();
  }
  return result;
}

std::optional<Offset::Error> offset_error(const Bounding_arc_tree_2& curves, const Offset& offset, double eps) {
  const Bounding_arc_tree_2 chains(offset.drawing(), Decisions::DOUBLE);
  const double d = std::fabs(offset.distance);
  const auto most = directed_hausdorff_distance(chains, curves, eps);
  if (!most) return std::nullopt;
  const auto least = distance(chains, curves, eps);
  return Offset::Error{{least->distance.lower - d, least->distance.upper - d},
                       {most->distance.lower - d, most->distance.upper - d}};
}

std::vector<Offset> insets(const Bounding_arc_tree_2& tree, double step, double eps, const Offset::Options& options) {
  if (!(step > eps)) throw std::invalid_argument(expected("step", "a number above eps, " + text_of(eps), step));
  const CGAL::Bbox_2 box = tree.box();
  // bands, which points have, too, would never vanish
  const internal::Offset_sources source(tree, eps, options, true);
  const double largest = (std::min)(box.xmax() / 2 - box.xmin() / 2, box.ymax() / 2 - box.ymin() / 2);
  std::vector<Offset> result;
  for (double k = 1; k * step <= largest + eps; ++k) {
    result.push_back(source.at(-k * step));
    if (!result.back().chains.empty()) continue;
    result.pop_back();
    break;
  }
  return result;
}

// Two offsets one after the other, each of half of eps: the second one, not COMPLETE where the first one is not.
[[nodiscard]] static Offset offset_twice(const Bounding_arc_tree_2& tree, double first, double second, double eps,
                                         const Offset::Options& options) {
  Offset::Options of_chains = options;
  of_chains.rule = Fill_rule::NONZERO;  // chains run as regions do
  const Offset between = offset(tree, first, eps / 2, options);
  Offset result = Offset_source_2(between.chains, eps / 2, of_chains).at(second);
  result.status = (std::max)(between.status, result.status);
  return result;
}

Offset opening(const Bounding_arc_tree_2& tree, double radius, double eps, const Offset::Options& options) {
  return offset_twice(tree, -radius, radius, eps, options);
}

Offset closing(const Bounding_arc_tree_2& tree, double radius, double eps, const Offset::Options& options) {
  return offset_twice(tree, radius, -radius, eps, options);
}

}  // namespace CGAL::Bounding_arcs
