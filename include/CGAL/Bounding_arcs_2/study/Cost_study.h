// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What it costs to be exact: how long numbers become, how long they take, and which stage of the filter decides.

#ifndef CGAL_BOUNDING_ARCS_2_STUDY_COST_STUDY_H
#define CGAL_BOUNDING_ARCS_2_STUDY_COST_STUDY_H

#include <CGAL/Bounding_arcs_2/study/stability_families.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Bounding_arcs {

/// How many comparisons of a thickness with a tolerance each stage of the filter decided.
struct Stage_counts {
  std::size_t bounded = 0;     ///< double with a running error bound
  std::size_t interval = 0;    ///< an interval of doubles over the exact shape
  std::size_t enclosure = 0;   ///< MPFR enclosures over it
  std::size_t expression = 0;  ///< an exact number with square roots
  [[nodiscard]] std::size_t all() const { return bounded + interval + enclosure + expression; }
};

/// What the regions of some pieces cost. Bits are the most that any of them takes. Times are those of all pieces over
/// the time of stable thickness in plain double, measured in one run; 0 where there is no such construction.
struct Cost_row {
  std::string family;
  double delta = 0;
  std::string method;               ///< bca, sfa, bilens
  std::size_t pieces = 0;           ///< with such a region
  std::size_t rational_bits = 0;    ///< of a numerator or denominator of the exact frame
  std::size_t root_bits = 0;        ///< of one in a Root_of_2, a coordinate of a corner over a rational kernel
  std::size_t stable_bits = 0;      ///< that give the thickness to 53 bits by stable formulas
  std::size_t textbook_bits = 0;    ///< that do so by the textbook's; 0 where even 16384 do not
  std::size_t expression_bits = 0;  ///< that a CORE::Expr has to tell the thickness from the double next to it
  std::size_t separation_bits = 0;  ///< that it would need to call their difference 0
  double stable_time = 0;           ///< thickness in double as this library has it, from twice the digits where needed
  double bounded_time = 0;          ///< thickness in double with a running error bound
  double enclosure_time = 0;        ///< thickness in enclosures of stable_bits bits
  double rational_time = 0;         ///< the boundary over rationals, of spiral fat arcs with Root_of_2; none of bilens
  double expression_time = 0;       ///< the thickness as CORE::Expr, compared with the double next to it
  Stage_counts decisions =
      {};  ///< with eps = thickness (1 +- 2^-j), j = 8, 16, ..., 48, and with the double next to it
};

/// Measures BCA, spiral fat arcs and bilens on pieces, which should be of one family and delta.
/// \param repeat times are the least of so many
/// \return a row for each method that has a region on one of the pieces
[[nodiscard]] std::vector<Cost_row> cost_rows(const std::vector<Study_piece>& pieces, std::size_t repeat);

}  // namespace CGAL::Bounding_arcs

#endif
