// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cuts off the tips of loops that turn back.
//
//      ______________        Where a strip is just as wide as two distances, what is left of its ends begins with two
//     |_____             ->  parts that touch: next to the tip rounding tells which of them is on which side, and they
//           \____            cross.  Cut off where they are farther apart than that, they do not.

#ifndef BOUNDING_ARCS_LIBRARY_OFFSET_BLUNT_CUSPS_H
#define BOUNDING_ARCS_LIBRARY_OFFSET_BLUNT_CUSPS_H

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>
#include "Raw_offset.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// Cuts off a share of the part's length from its end, or from its start.
inline void shorten(Raw_part& part, double share, bool is_end) {
  const double bulge = std::tan(std::atan(part.arc.bulge) * (1 - share)), along = share * (part.v - part.u);
  if (is_end) {
    part.arc = {part.arc.from, point(part.arc, 1 - share), bulge};
    part.v -= along;
  } else {
    part.arc = {point(part.arc, share), part.arc.to, bulge};
    part.u += along;
  }
}

/// \param width how far parts are apart where they are cut; some times what rounding may move their points by
inline void blunt_cusps(Raw_loop& loop, double width) {
  constexpr double TURNS_BACK = 0x1p-20,  // the sine of an angle within which rounding may decide
      LEAST = 0x1p-40, MOST = 0x1p-2;     // shares of the shorter part
  std::vector<std::optional<Raw_part>> tips(loop.size());
  const std::size_t n = loop.size();
  bool has_tips = false;
  for (std::size_t i = 0; n > 1 && i < n; ++i) {
    Raw_part &a = loop[i], &b = loop[(i + 1) % n];
    const Xy<double> coming = tangent(a.arc, 1), going = tangent(b.arc, 0);
    if (dot(coming, going) > 0 || std::fabs(cross(coming, going)) > TURNS_BACK) continue;
    const double of_a = length(a.arc), of_b = length(b.arc), shorter = (std::min)(of_a, of_b);
    for (double share = LEAST; share <= MOST && !tips[i]; share *= 2) {
      const double s = share * shorter;
      if (euclidean_norm(point(a.arc, 1 - s / of_a) - point(b.arc, s / of_b)) < width) continue;
      shorten(a, s / of_a, true);
      shorten(b, s / of_b, false);
      tips[i] = Raw_part{a.edge, {a.arc.to, b.arc.from, 0}, a.v, a.v};
      has_tips = true;
    }
  }
  if (!has_tips) return;
  Raw_loop result;
  for (std::size_t i = 0; i < n; ++i) {
    result.push_back(loop[i]);
    if (tips[i]) result.push_back(*tips[i]);
  }
  loop = std::move(result);
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
