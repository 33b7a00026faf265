// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of offset/offset_series.h.

#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/offset/Offset_source.h>
#include <CGAL/Bounding_arcs_2/offset/internal/compiled_offsets.h>
#include <CGAL/Bounding_arcs_2/offset/offset_series.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

std::vector<Offset> insets(const Drawing_2<double>& drawing, double step, const Offset_job& job) {
  if (!(step > job.eps)) throw std::invalid_argument(expected("step", "a number above eps, " + text_of(job.eps), step));
  Drawing_2<double> closed;  // bands of others, which points have, too, would never vanish
  CGAL::Bbox_2 box;
  for (const auto& c : drawing.curves()) {
    const Xy<double> start = c.beziers.front().control_points().front();
    bool is_point = true;
    for (const auto& piece : c.beziers)
      for (const Xy<double>& p : piece.control_points()) {
        is_point = is_point && p == start;
        box += CGAL::Bbox_2(p.x, p.y, p.x, p.y);
      }
    if (c.is_closed && !is_point) closed.add(c.beziers, c.name);
  }
  const Offset_source source(closed, job);
  const double largest = (std::min)(box.xmax() / 2 - box.xmin() / 2, box.ymax() / 2 - box.ymin() / 2);
  std::vector<Offset> result;
  for (double k = 1; k * step <= largest + job.eps; ++k) {
    result.push_back(source.at(-k * step));
    if (!result.back().chains.empty()) continue;
    result.pop_back();
    break;
  }
  return result;
}

Offset_twice offset_twice(const Drawing_2<double>& drawing, double first, double second, Offset_job job) {
  job.eps /= 2;
  Offset_twice result;
  result.first = Offset_source(drawing, job).at(first);
  job.rule = Fill_rule::NONZERO;  // chains run as regions do
  result.second = Offset_source(result.first.chains, job).at(second);
  result.second.status = (std::max)(result.first.status, result.second.status);
  return result;
}

Offset opening(const Drawing_2<double>& drawing, double radius, const Offset_job& job) {
  return offset_twice(drawing, -radius, radius, job).second;
}

Offset closing(const Drawing_2<double>& drawing, double radius, const Offset_job& job) {
  return offset_twice(drawing, radius, -radius, job).second;
}

}  // namespace CGAL::Bounding_arcs::internal
