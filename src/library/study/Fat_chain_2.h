// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One or two fat arcs in a row: the form in which spiral fat arcs, bilens, fat arcs and fat biarcs answer questions.

#ifndef BOUNDING_ARCS_LIBRARY_STUDY_FAT_CHAIN_2_H
#define BOUNDING_ARCS_LIBRARY_STUDY_FAT_CHAIN_2_H

#include <CGAL/Bounding_arcs_2/region/Fat_arc_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL::Bounding_arcs {

/// The first `size` parts hold the piece, one after the other.
struct Fat_chain_2 {
  Fat_arc_2 parts[2];
  std::size_t size = 1;

  [[nodiscard]] const Fat_arc_2* begin() const { return parts; }
  [[nodiscard]] const Fat_arc_2* end() const { return parts + size; }
};

[[nodiscard]] inline double half_width(const Fat_chain_2& chain) { return chain.parts[0].radius; }

/// Bounds of the distance from a point to the piece.
[[nodiscard]] inline Bracket distance_bounds(const Xy<double>& q, const Fat_chain_2& chain) {
  Bracket least{HUGE_VAL, HUGE_VAL};
  for (const Fat_arc_2& part : chain) {
    const Bracket d = distance_bounds(q, part);
    least = {(std::min)(least.lower, d.lower), (std::min)(least.upper, d.upper)};
  }
  return least;
}
/// A lower bound of the distance of two pieces.
[[nodiscard]] inline double least_distance(const Fat_chain_2& a, const Fat_chain_2& b) {
  double least = HUGE_VAL;
  for (const Fat_arc_2& p : a)
    for (const Fat_arc_2& q : b) least = (std::min)(least, least_distance(p, q));
  return least;
}
/// Whether two pieces for certain have no common point; false may mean that it is not known.
[[nodiscard]] inline bool are_apart(const Fat_chain_2& a, const Fat_chain_2& b) {
  for (const Fat_arc_2& p : a)
    for (const Fat_arc_2& q : b)
      if (!are_apart(p, q)) return false;
  return true;
}

}  // namespace CGAL::Bounding_arcs

#endif
