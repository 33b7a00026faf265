// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What goes wrong where the textbook's steps decide: tolerances, enclosures, numbers of regions.

#ifndef CGAL_BOUNDING_ARCS_2_STUDY_CONSEQUENCE_STUDY_H
#define CGAL_BOUNDING_ARCS_2_STUDY_CONSEQUENCE_STUDY_H

#include <CGAL/Bounding_arcs_2/study/stability_families.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Bounding_arcs {

/// What went wrong with one formula in double, whose numbers are believed.
struct Consequences {
  std::size_t asked = 0, wrong = 0;  ///< whether a thickness is within a tolerance
  std::size_t not_held = 0;          ///< pieces not proven to be within 16 ulp of their places from the region
  std::size_t miscounted = 0;        ///< pieces halved to another number of regions than exact decisions make
  std::size_t torn = 0;              ///< pieces whose offset, a chord away, begins or ends over 16 ulp from its place
};

/// The consequences of some pieces, of one method.
struct Consequence_row {
  std::string family;
  double delta = 0;
  std::string method;      ///< bca, sfa, bilens
  std::size_t pieces = 0;  ///< with such a region
  Consequences textbook = {}, stable = {};
};

/// Asks for tolerances of exact thickness times 2^(k + 1/2), k = -3, ..., 2, and halves pieces for one of 1/100 of it,
/// into 64 regions at most. Both formulas are evaluated in double without a filter. Circles that touch the curve's ends
/// are moved as a program moves them: the textbook's about their centers to another radius, the stable ones, which have
/// no center, by their normals.
/// \param pieces should be of one family and delta
/// \return a row for each method that has a region on one of the pieces
[[nodiscard]] std::vector<Consequence_row> consequence_rows(const std::vector<Study_piece>& pieces);

}  // namespace CGAL::Bounding_arcs

#endif
