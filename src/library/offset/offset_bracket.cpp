// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of offset/offset_bracket.h.

#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/offset/Offset_source_2.h>
#include <CGAL/Bounding_arcs_2/offset/offset_bracket.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace CGAL::Bounding_arcs {

Offset_bracket offset_bracket(const Bounding_arc_tree_2& tree, double d, double eps, const Offset_options& options) {
  if (!(std::fabs(d) > eps))
    throw std::invalid_argument(expected("distance", "a number above eps, " + text_of(eps), d));
  if (options.join != Offset_join::ROUND || options.cap != Offset_cap::ROUND || options.side != Offset_side::BOTH)
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
  Offset_chain boundary;
  const auto add = [&](const Xy<double>& from, const Xy<double>& to, double bulge) {
    if (from != to) boundary.pieces.push_back({{from, to, bulge}, {}, 1, Offset_kind::CURVE, true, 0});
  };
  const Arc_side_2 &inner = region.inner, &outer = region.outer;
  add(region.from, inner.size == 1 ? region.to : inner.joint, inner.bulges[0]);
  if (inner.size == 2) add(inner.joint, region.to, inner.bulges[1]);
  if (outer.size == 2) add(region.to, outer.joint, -outer.bulges[1]);
  add(outer.size == 1 ? region.to : outer.joint, region.from, -outer.bulges[0]);
  const double beside = eps / 2, widening = std::isfinite(region.widening) ? region.widening : 0;
  return Offset_source_2({boundary}, beside).at(d + widening + beside);
}

}  // namespace CGAL::Bounding_arcs
