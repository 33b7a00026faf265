// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Drawings as one, whose pieces know where they come from.

#ifndef BOUNDING_ARCS_LIBRARY_OVERLAY_UNITED_CURVES_H
#define BOUNDING_ARCS_LIBRARY_OVERLAY_UNITED_CURVES_H

#include "Overlay.h"

#include <CGAL/Bounding_arcs_2/curve/exact_bezier.h>
#include <CGAL/Bounding_arcs_2/overlay/Outline_operand.h>
#include <CGAL/Bounding_arcs_2/overlay/Outline_status.h>
#include <CGAL/Bounding_arcs_2/tree/Drawing_hierarchy.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// The place that a Bezier piece of all operands together has in its own.
struct Operand_bezier {
  std::uint32_t operand, curve, bezier;
};

/// All operands together, without pieces of curves that are single points.
struct United_curves {
  Drawing_hierarchy curves;
  std::vector<Operand_bezier> beziers;  ///< numbered through
  std::vector<std::uint32_t> operands;  ///< by curve
};
/// What becomes of curves that are single points.
enum class Lone_points { DROPPED, KEPT };

template <class NT, class Piece>
[[nodiscard]] United_curves united_curves(const std::vector<Outline_operand>& given, Lone_points points,
                                          Decisions decisions, const Piece& piece) {
  Drawing_2<NT> drawing;
  std::vector<Operand_bezier> beziers;
  std::vector<std::uint32_t> operands;
  std::size_t count = 0;
  for (const Outline_operand& o : given)
    for (const auto& curve : o.drawing->curves()) count += curve.beziers.size();
  beziers.reserve(count);
  for (std::uint32_t i = 0; i < given.size(); ++i)
    for (std::uint32_t c = 0; c < given[i].drawing->curves().size(); ++c) {
      const auto& curve = given[i].drawing->curves()[c];
      std::vector<Bezier_curve_2<NT>> chain;
      chain.reserve(curve.beziers.size());
      for (std::uint32_t b = 0; b < curve.beziers.size(); ++b) {
        Bezier_curve_2<NT> p = piece(given[i], c, b);
        const auto& at = p.control_points();
        const bool is_kept = points == Lone_points::KEPT && chain.empty() && b + 1 == curve.beziers.size();
        if (!is_kept && std::all_of(at.begin(), at.end(), [&](const Xy<NT>& q) { return q == at.front(); })) continue;
        beziers.push_back({i, c, b});
        chain.push_back(std::move(p));
      }
      if (chain.empty()) continue;
      drawing.add(std::move(chain), curve.name);
      operands.push_back(i);
    }
  return {Drawing_hierarchy(std::move(drawing), decisions), std::move(beziers), std::move(operands)};
}

[[nodiscard]] inline Bezier_curve_2<Exact_rational> exact_piece(const Outline_operand& o, std::uint32_t c,
                                                                std::uint32_t b) {
  if (o.exact == nullptr) return exact_bezier(o.drawing->curves()[c].beziers[b]);
  const Segment_hierarchy& curves = o.exact->in_unit();
  const auto in_unit = curves.exact_bezier(curves.number_of_bezier(c, b));
  std::vector<Xy<Exact_rational>> points;
  for (const auto& p : in_unit.control_points())
    points.push_back({o.exact->unit().exactly_out(p.x), o.exact->unit().exactly_out(p.y)});
  return Bezier_curve_2<Exact_rational>(std::move(points), in_unit.weights());
}

/// Unites operands, exactly where one of them has other numbers than doubles.
[[nodiscard]] inline United_curves united_curves(const std::vector<Outline_operand>& operands, Lone_points points,
                                                 Decisions decisions) {
  if (std::any_of(operands.begin(), operands.end(), [](const Outline_operand& o) { return o.exact != nullptr; }))
    return united_curves<Exact_rational>(operands, points, decisions, exact_piece);
  return united_curves<double>(
      operands, points, decisions,
      [](const Outline_operand& o, std::uint32_t c, std::uint32_t b) { return o.drawing->curves()[c].beziers[b]; });
}

/// Returns what an overlay of united curves left open, by operands.
[[nodiscard]] inline Undecided_meeting undecided_meeting(const Open_place& open, const United_curves& united) {
  const auto of = [&](std::uint32_t bezier) {
    const Operand_bezier& at = united.beziers[bezier];
    return Undecided_meeting::Of{at.operand, at.curve, at.bezier};
  };
  return {united.curves.unit().out(open.point), of(open.bezier_a), of(open.bezier_b)};
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
