// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A curve as few circular arcs and segments as a tolerance allows, each with a certified bound of its error.

#ifndef CGAL_BOUNDING_ARCS_2_APPROXIMATION_ARC_CHAIN_H
#define CGAL_BOUNDING_ARCS_2_APPROXIMATION_ARC_CHAIN_H

#include <CGAL/Bounding_arcs_2/approximation/Spiral_arcs.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>
#include <CGAL/Bounding_arcs_2/tree/equalize_breaks.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <vector>

namespace CGAL::Bounding_arcs {

struct Arc_chain_options {
  Continuity continuity = Continuity::TANGENT;
  Chain_side side = Chain_side::BOTH;
  std::size_t max_arcs = 20'000'000;
};

struct Arc_chain {
  std::vector<Chain_arc_2> arcs;  ///< in curve order
  double error = 0;               ///< the largest of an arc
  Build_status status = Build_status::COMPLETE;
};

/// Arcs and segments that follow the spiral segments, which are what `spiral_segments` gives for one curve or several that
/// are joined. Each arc starts where the one before ends, bit for bit, where the curve does; both ends of a spiral segment
/// are break points. A straight segment becomes one segment, a circular one a single arc.
/// \param eps the largest error of an arc, in units of the coordinates, positive
/// \return a chain whose status is COMPLETE when every error is at most eps; RESOLUTION_REACHED when eps is below what
///   coordinates resolve, with the errors reached; REGION_LIMIT, and no arcs, above max_arcs
/// \throws std::invalid_argument for an eps that is not positive
/// \guarantee certified: an arc's error is at least the Frechet distance, hence the Hausdorff distance, between the arc
///   with this `from`, `to` and `bulge` and the curve's piece [t0, t1], rounding included; only an error that could be brought
///   neither to eps nor to what coordinates resolve is some number above both. With a side, the chain is on it
///   but for rounding of coordinates. Tangents at joints agree but for rounding. The number of arcs is a heuristic close
///   to the least, see doc/arcs.md
/// \complexity about three fits an arc
[[nodiscard]] inline Arc_chain arc_chain(const std::vector<Bezier_spiral_2<double>>& spirals, double eps,
                                         const Arc_chain_options& options = {}) {
  if (!(eps > 0)) throw std::invalid_argument("eps must be positive");
  Arc_chain chain;
  chain.arcs.reserve(4 * spirals.size());
  Measured_breaks pieces;
  std::optional<Xy<double>> end;  // of the spiral before
  for (std::size_t i = 0; i < spirals.size(); ++i) {
    const bool goes_on = i > 0 && &spirals[i].curve() == &spirals[i - 1].curve() && spirals[i].first() == spirals[i - 1].last();
    internal::Spiral_arcs arcs(spirals[i], options.continuity, options.side, eps, goes_on ? end : std::nullopt);
    end = arcs.end_point();
    arcs.guess(pieces.breaks);
    const auto fit = [&](const std::vector<double>& breaks, std::vector<double>& errors) { arcs.fit(breaks, errors); };
    const bool within = equalize_breaks(pieces, arcs.reachable(), options.max_arcs, fit);
    if (pieces.breaks.size() > options.max_arcs) return {{}, 0, Build_status::REGION_LIMIT};
    if (!within || arcs.reachable() > eps) chain.status = Build_status::RESOLUTION_REACHED;
    const std::size_t first = chain.arcs.size();
    arcs.append_to(chain.arcs);
    for (std::size_t j = first; j < chain.arcs.size(); ++j) {
      chain.arcs[j].spiral = i;
      chain.error = (std::max)(chain.error, chain.arcs[j].error);
    }
  }
  if (chain.arcs.size() > options.max_arcs) return {{}, 0, Build_status::REGION_LIMIT};
  return chain;
}

}  // namespace CGAL::Bounding_arcs

#endif
