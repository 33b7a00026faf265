// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of medial_axis/outline_axis.h.

#include <CGAL/Bounding_arcs_2/arc/arc_beziers.h>
#include <CGAL/Bounding_arcs_2/medial_axis/internal/axis_of_uncrossed.h>
#include <CGAL/Bounding_arcs_2/medial_axis/internal/compiled_axes.h>
#include <CGAL/Bounding_arcs_2/medial_axis/outline_axis.h>
#include <CGAL/Bounding_arcs_2/offset/Offset_source.h>
#include <CGAL/Bounding_arcs_2/query/closed_curves.h>

#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

Outline_axis internal::outline_axis(const Drawing_2<double>& drawing, const Axis_job& job) {
  if (!(job.eps > 0)) throw std::invalid_argument("a tolerance above 0 is needed");
  check_closed(drawing);
  Outline_axis result;
  Offset_job of_outline;
  of_outline.eps = job.eps / 2;
  of_outline.rule = job.rule;
  const Offset outline = Offset_source(drawing, of_outline).outline();
  result.error = outline.error;
  for (const Offset_chain& chain : outline.chains) {
    std::vector<Bezier_curve_2<double>> pieces;
    std::vector<Outline_axis::Source> sources;
    for (const Offset_piece& p : chain.pieces) {
      if (p.arc.from == p.arc.to) continue;
      auto parts = arc_beziers<double>(p.arc.from, p.arc.to, p.arc.bulge);
      const double step = (p.t_end - p.source.t) / static_cast<double>(parts.size());
      Curve_place place = p.source;
      for (auto& part : parts) {
        pieces.push_back(std::move(part));
        sources.push_back({place, place.t + step});
        place.t += step;
      }
    }
    if (pieces.empty()) continue;
    result.outline.add(std::move(pieces));
    result.sources.push_back(std::move(sources));
  }
  Axis_job of_axis = job;
  of_axis.eps = job.eps / 2;
  of_axis.rule = Fill_rule::NONZERO;
  result.axis = internal::axis_of_uncrossed(Drawing_hierarchy(result.outline), of_axis);
  if (outline.status == Offset_status::UNRESOLVED) result.axis.status = Medial_axis_status::UNRESOLVED;
  return result;
}

}  // namespace CGAL::Bounding_arcs
