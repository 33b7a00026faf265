// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of offset/offset_bracket.h, which the library has compiled.

#ifndef CGAL_BOUNDING_ARCS_2_INTERNAL_OFFSET_OFFSET_BRACKET_IMPL_H
#define CGAL_BOUNDING_ARCS_2_INTERNAL_OFFSET_OFFSET_BRACKET_IMPL_H

#include <CGAL/Bounding_arcs_2/internal/inline.h>
#include <CGAL/Bounding_arcs_2/offset/Offset_source_2.h>
#include <CGAL/Bounding_arcs_2/offset/offset_bracket.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace CGAL::Bounding_arcs {

CGAL_BOUNDING_ARCS_INLINE Offset_bracket offset_bracket(const Drawing_2<double>& drawing, double d,
                                                        Offset_options options) {
  if (!(std::fabs(d) > options.eps)) throw std::invalid_argument("a bracket's distance must be larger than eps");
  if (options.join != Offset_join::ROUND || options.cap != Offset_cap::ROUND || options.side != Offset_side::BOTH)
    throw std::invalid_argument("a bracket has round joins and caps, and both sides");
  const auto& curves = drawing.curves();
  const bool has_closed = std::any_of(curves.begin(), curves.end(), [](const auto& c) { return c.is_closed; });
  if (!has_closed) d = std::fabs(d);  // a band grows with |d|
  options.eps /= 4;
  const Offset_source_2 source(drawing, options);
  return {source.at(d - options.eps), source.at(d + options.eps)};
}

CGAL_BOUNDING_ARCS_INLINE Offset sleeve(const Arc_region_2& region, double d, double eps) {
  if (!(d > 0)) throw std::invalid_argument("a sleeve's distance must be positive");
  Offset_chain boundary;
  const auto add = [&](const Xy<double>& from, const Xy<double>& to, double bulge) {
    if (from != to) boundary.pieces.push_back({{from, to, bulge}, {}, 1, Offset_kind::CURVE, true});
  };
  const Arc_side_2 &inner = region.inner, &outer = region.outer;
  add(region.from, inner.size == 1 ? region.to : inner.joint, inner.bulges[0]);
  if (inner.size == 2) add(inner.joint, region.to, inner.bulges[1]);
  if (outer.size == 2) add(region.to, outer.joint, -outer.bulges[1]);
  add(outer.size == 1 ? region.to : outer.joint, region.from, -outer.bulges[0]);
  Offset_options options;
  options.eps = eps / 2;
  const double widening = std::isfinite(region.widening) ? region.widening : 0;
  return Offset_source_2({boundary}, options).at(d + widening + options.eps);
}

}  // namespace CGAL::Bounding_arcs

#endif
