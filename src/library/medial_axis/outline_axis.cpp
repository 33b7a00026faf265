// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of medial_axis/outline_axis.h.

#include "../boolean/plane_faces.h"

#include <CGAL/Bounding_arcs_2/boolean/boolean_operations.h>
#include <CGAL/Bounding_arcs_2/medial_axis/internal/axis_of_uncrossed.h>
#include <CGAL/Bounding_arcs_2/medial_axis/internal/compiled_axes.h>
#include <CGAL/Bounding_arcs_2/medial_axis/outline_axis.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/query/closed_curves.h>

#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

namespace {

[[nodiscard]] std::vector<Outline_axis::Source> sources_of(const Outline_chain& chain) {
  std::vector<Outline_axis::Source> sources;
  for (const Outline_part& p : chain.parts) sources.push_back({{p.curve, p.bezier, p.from.middle()}, p.to.middle()});
  return sources;
}

}  // namespace

Outline_axis internal::outline_axis(const Drawing_hierarchy& curves, const Axis_job& job, Decisions decisions) {
  check_above_zero("eps", job.eps);
  if (job.is_framed) throw std::invalid_argument(expected("job", "no frame, for which medial_axis is made", "one"));
  const Drawing_2<double>& drawing = curves.drawing();
  check_closed(drawing);
  const Outline_operand operand{&drawing, curves.in_unit().is_rounded() ? &curves : nullptr, job.rule};
  const Outline_2 outline = region_outline(operand, decisions);
  Outline_axis result;
  Drawn_outline drawn = drawn_outline(outline, {operand}, {false});
  result.error = drawn.moved;
  result.outline = std::move(drawn.drawing);
  std::vector<bool> is_ccw;
  for (const Outline_chain& chain : outline.chains) {
    is_ccw.push_back(chain.is_ccw);
    result.sources.push_back(sources_of(chain));
  }
  result.axis = axis_to_the_left(Drawing_hierarchy(result.outline), is_ccw, job);
  if (outline.status == Outline_status::UNDECIDED) result.axis.status = Medial_axis_status::UNRESOLVED;
  return result;
}

}  // namespace CGAL::Bounding_arcs
