// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A chain of arcs along curves of one's own, of which there are regions but no tree of Bezier pieces.

#ifndef CGAL_BOUNDING_ARCS_2_CHAIN_ARC_CHAIN_OF_REGIONS_H
#define CGAL_BOUNDING_ARCS_2_CHAIN_ARC_CHAIN_OF_REGIONS_H

#include <CGAL/Bounding_arcs_2/chain/arc_chain.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/region/region_bounds.h>
#include <CGAL/Bounding_arcs_2/tree/Region_hierarchy_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace CGAL::Bounding_arcs {

/// Returns arcs that follow the curves that regions are of, one arc a piece, with both ends on the curve. It is for
/// curves of one's own, which no Bounding_arc_tree_2 takes; that one's arc_chain() needs fewer arcs.
/// \code
/// const Region_hierarchy_2<Bca_traits_2<Kernel>, Jet_spiral_2<Clothoid>> regions({spiral}, 1e-3);
/// const Arc_chain chain = arc_chain(regions, 1e-6);
/// \endcode
/// \param eps the largest error of an arc, positive. It is not bound to that of the regions
/// \return a chain whose status is COMPLETE when every error is at most eps; RESOLUTION_REACHED where the errors of the
///   segments leave more, with the errors reached; REGION_LIMIT, and no arcs, above max_arcs
/// \guarantee certified, as far as the segments are spirals and their errors hold: no point of an arc is farther than
///   its error from its piece, and none of the piece farther from the arc (the fat arc of a BCA, Fat_arc_2.h)
/// \complexity about four regions an arc
/// \throws std::invalid_argument for an eps that is not positive
template <class Traits, class Spiral>
[[nodiscard]] Arc_chain arc_chain(const Region_hierarchy_2<Traits, Spiral>& regions, double eps,
                                  std::size_t max_arcs = Arc_chain::Options().max_arcs) {
  static_assert(std::is_same_v<typename Traits::FT, double>, "arc_chain takes regions over double");
  check_above_zero("eps", eps);
  Arc_chain chain;
  for (std::uint32_t i = 0; i < regions.spirals().size(); ++i) {
    const double first = regions.spirals()[i].first(), last = regions.spirals()[i].last();
    constexpr double RESOLVED = 4;  // widenings: errors do not fall below one, however short an arc is
    double target = eps;
    const auto arc_of = [&](double t0, double t1) {
      const Arc_region_2 region = regions.bounding_arcs(i, t0, t1);
      target = (std::max)(eps, RESOLVED * region.widening);
      const Fat_arc_2 fat = fat_arc(region);
      return Arc_chain::Arc{fat.arc, t0, t1, fat.radius, i};
    };
    double step = last - first;
    for (double t = first; t < last;) {
      // The error grows with the cube of the length.
      constexpr double SHORTER = 0.97, LEAST = 0.125, MOST = 2;
      const auto scale = [&](double error) { return std::clamp(SHORTER * std::cbrt(target / error), LEAST, MOST); };
      Arc_chain::Arc arc = arc_of(t, t + step < last ? t + step : last);
      while (!(arc.error <= target)) {
        const double next = t + (arc.t1 - t) * (std::min)(SHORTER, scale(arc.error));
        if (!(t < next && next < arc.t1)) break;
        arc = arc_of(t, next);
      }
      if (chain.arcs.size() == max_arcs) return {{}, 0, Build_status::REGION_LIMIT};
      chain.arcs.push_back(arc);
      chain.error = (std::max)(chain.error, arc.error);
      step = (arc.t1 - t) * scale(arc.error);
      t = arc.t1;
    }
  }
  if (chain.error > eps) chain.status = Build_status::RESOLUTION_REACHED;
  return chain;
}

}  // namespace CGAL::Bounding_arcs

#endif
