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

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace CGAL::Bounding_arcs {

namespace {

/// How far parts of curves that are cut in doubles may be from these. A piece of degree n is cut twice, each time in n
/// steps. A step takes the mean of two points, with weights that are between 0 and 1 and sum up to 1 but for roundings:
/// at most 8 u M for coordinates up to M, rational ones included. So it is 16 n u M. With weights w the parameters of a
/// cut, some ulp apart, move it by less than 16 n u M (max w / min w)^2, as |C'| is at most 2 n M times that.
[[nodiscard]] double cutting_error(const Drawing_2<double>& drawing) {
  double most = 0;
  for (const auto& curve : drawing.curves())
    for (const auto& piece : curve.beziers) {
      double size = 0, ratio = 1;
      for (const Xy<double>& p : piece.control_points()) size = (std::max)({size, std::fabs(p.x), std::fabs(p.y)});
      if (piece.is_rational()) {
        const auto range = std::minmax_element(piece.weights().begin(), piece.weights().end());
        ratio = *range.second / *range.first;
      }
      most = (std::max)(most, 16 * HALF_ULP * piece.degree() * size * (1 + ratio * ratio));
    }
  return most;
}

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
  result.error = cutting_error(drawing);
  result.outline = outline_drawing(outline, {&drawing});
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
