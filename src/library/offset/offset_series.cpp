// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of offset/offset_series.h.

#include "Offset_sources.h"

#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/offset/Offset_source_2.h>
#include <CGAL/Bounding_arcs_2/offset/offset_series.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace CGAL::Bounding_arcs {

std::vector<Offset> insets(const Bounding_arc_tree_2& tree, double step, double eps, const Offset_options& options) {
  internal::Offset_job job = internal::offset_job(eps, options);
  job.drops_open = true;  // bands, which points have, too, would never vanish
  if (!(step > eps)) throw std::invalid_argument(expected("step", "a number above eps, " + text_of(eps), step));
  const CGAL::Bbox_2 box = tree.box();
  const internal::Offset_sources source(tree, job);
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

Offset_twice offset_twice(const Bounding_arc_tree_2& tree, double first, double second, double eps,
                          const Offset_options& options) {
  Offset_options of_chains = options;
  of_chains.rule = Fill_rule::NONZERO;  // chains run as regions do
  Offset_twice result;
  result.first = offset(tree, first, eps / 2, options);
  result.second = Offset_source_2(result.first.chains, eps / 2, of_chains).at(second);
  result.second.status = (std::max)(result.first.status, result.second.status);
  return result;
}

Offset opening(const Bounding_arc_tree_2& tree, double radius, double eps, const Offset_options& options) {
  return offset_twice(tree, -radius, radius, eps, options).second;
}

Offset closing(const Bounding_arc_tree_2& tree, double radius, double eps, const Offset_options& options) {
  return offset_twice(tree, radius, -radius, eps, options).second;
}

}  // namespace CGAL::Bounding_arcs
