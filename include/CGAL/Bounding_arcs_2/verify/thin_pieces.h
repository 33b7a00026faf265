// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A certified region may be another one than a tree decided on, and thicker: its piece is halved until regions are
// thin.

#ifndef CGAL_BOUNDING_ARCS_2_VERIFY_THIN_PIECES_H
#define CGAL_BOUNDING_ARCS_2_VERIFY_THIN_PIECES_H

#include <CGAL/Bounding_arcs_2/region/thickness_bound.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>

namespace CGAL::Bounding_arcs {

/// A certified upper bound of the exact thickness of the construction's region of [t0, t1], at most eps where that is.
/// \tparam Spiral Bezier_spiral_2
/// \complexity as sharp_thickness, which it is as a rule
template <class Construction, class Spiral>
[[nodiscard]] double certified_thickness(const Construction& construction, const Spiral& spiral, double t0, double t1,
                                         double eps) {
  const std::optional<double> sharp = sharp_thickness(construction, spiral, t0, t1);
  if (sharp && *sharp <= eps) return *sharp;
  using Exact = typename Spiral::Exact_number_type;
  const auto shape = spiral.template shape<Exact>(t0, t1, shape_parts<Construction>());
  return (std::min)(sharp.value_or(std::numeric_limits<double>::infinity()),
                    bound_exactly(construction, shape, eps).upper);
}

/// Calls visit(t0, t1, region) for the region of [t0, t1] or, in curve order, for those of its halves, and of theirs,
/// until regions are at most eps thick.
/// \param room how many regions there may be beside the first; taken from
/// \param make make(t0, t1) -> a region with members `thickness` and `is_certified`; others than certified ones are not
///   halved
/// \guarantee a certified region that is visited and thicker than eps has no room: room is 0, or no double is between
///   t0 and t1
template <class Make, class Visit>
void for_each_thin_piece(double t0, double t1, double eps, std::size_t& room, const Make& make, const Visit& visit) {
  const auto region = make(t0, t1);
  const double middle = t0 + (t1 - t0) / 2;
  if (!region.is_certified || region.thickness <= eps || room == 0 || !(t0 < middle && middle < t1))
    return visit(t0, t1, region);
  --room;
  for_each_thin_piece(t0, middle, eps, room, make, visit);
  for_each_thin_piece(middle, t1, eps, room, make, visit);
}

}  // namespace CGAL::Bounding_arcs

#endif
