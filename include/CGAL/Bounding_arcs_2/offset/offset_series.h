// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is made of several offsets: insets until nothing is left, opening and closing.

#ifndef CGAL_BOUNDING_ARCS_2_OFFSET_OFFSET_SERIES_H
#define CGAL_BOUNDING_ARCS_2_OFFSET_OFFSET_SERIES_H

#include <CGAL/Bounding_arcs_2/offset/Offset_source_2.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace CGAL::Bounding_arcs {

/// Insets of closed curves a step apart, from the first until nothing is left: a pocket's tool paths.
/// \param step a positive length; there are as many insets as steps to the centre of the largest inscribed circle
/// \throws std::invalid_argument for a step that is not larger than eps, and as Offset_source_2
[[nodiscard]] inline std::vector<Offset> insets(const Drawing_2<double>& drawing, double step,
                                                const Offset_options& options = {}) {
  if (!(step > options.eps)) throw std::invalid_argument("insets' step must be larger than eps");
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
  const Offset_source_2 source(closed, options);
  const double largest = (std::min)(box.xmax() / 2 - box.xmin() / 2, box.ymax() / 2 - box.ymin() / 2);
  std::vector<Offset> result;
  for (double k = 1; k * step <= largest + options.eps; ++k) {
    result.push_back(source.at(-k * step));
    if (!result.back().chains.empty()) continue;
    result.pop_back();
    break;
  }
  return result;
}

/// Two offsets one after the other; pieces of the second have pieces of the first as their places: `curve` is a chain,
/// `bezier` a piece of it.
struct Offset_twice {
  Offset first, second;
};

/// \param first, second signed distances
/// \guarantee each of both as Offset_source_2::at, of half of eps: the second's points are that far from the first's
///   chains; the second is not COMPLETE where the first is not
[[nodiscard]] inline Offset_twice offset_twice(const Drawing_2<double>& drawing, double first, double second,
                                               Offset_options options = {}) {
  options.eps /= 2;
  Offset_twice result;
  result.first = Offset_source_2(drawing, options).at(first);
  options.rule = Fill_rule::NONZERO;  // chains run as regions do
  result.second = Offset_source_2(result.first.chains, options).at(second);
  result.second.status = (std::max)(result.first.status, result.second.status);
  return result;
}

/// Opening: what discs of a radius cover that are in what closed curves enclose.  Round outer corners are left.
[[nodiscard]] inline Offset opening(const Drawing_2<double>& drawing, double radius,
                                    const Offset_options& options = {}) {
  return offset_twice(drawing, -radius, radius, options).second;
}
/// Closing: what discs of a radius do not cover that are outside.  Gaps are closed, and inner corners rounded.
[[nodiscard]] inline Offset closing(const Drawing_2<double>& drawing, double radius,
                                    const Offset_options& options = {}) {
  return offset_twice(drawing, radius, -radius, options).second;
}

}  // namespace CGAL::Bounding_arcs

#endif
