// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How fast what is put over a short piece of curve comes near to it.

#ifndef BOUNDING_ARCS_LIBRARY_CHAIN_CUBIC_FACTOR_H
#define BOUNDING_ARCS_LIBRARY_CHAIN_CUBIC_FACTOR_H

#include <CGAL/Bounding_arcs_2/number/strict_math.h>

/// h^3 |dkappa/ds| times one of these is the measure of a short piece of length h; N*(eps) = (factor / eps)^(1/3) times
/// slope_integral pieces is the least number as eps goes to 0.  Derived in doc/arcs.md.
namespace CGAL::Bounding_arcs::cubic_factor {

inline constexpr double BCA = 1 / 24.0, SPIRAL_FAT_ARC = 1 / 6.0, BILENS = 1 / 48.0;  // thickness
inline constexpr double ARC = 1 / 124.70765814495915;                          // 72 sqrt(3): balanced arc, distance
inline constexpr double BIARC = 1 / 324.0;                                     // balanced biarc, distance
inline constexpr double ONE_SIDED_ARC = 2 / 81.0, ONE_SIDED_BIARC = 1 / 96.0;  // boundaries of BCA and bilens

}  // namespace CGAL::Bounding_arcs::cubic_factor

#endif
