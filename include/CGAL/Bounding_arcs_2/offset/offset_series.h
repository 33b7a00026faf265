// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is made of several offsets: insets until nothing is left, opening and closing.

#ifndef CGAL_BOUNDING_ARCS_2_OFFSET_OFFSET_SERIES_H
#define CGAL_BOUNDING_ARCS_2_OFFSET_OFFSET_SERIES_H

#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>
#include <CGAL/Bounding_arcs_2/offset/Offset_2.h>

#include <vector>

namespace CGAL::Bounding_arcs {

/// Insets of closed curves a step apart, from the first until nothing is left: a pocket's tool paths.
/// \param step a positive length; there are as many insets as steps to the centre of the largest inscribed circle
/// \throws std::invalid_argument for a step that is not larger than eps, and as Offset_source_2
[[nodiscard]] std::vector<Offset> insets(const Drawing_2<double>& drawing, double step,
                                         const Offset_options& options = {});

/// Two offsets one after the other; pieces of the second have pieces of the first as their places: `curve` is a chain,
/// `bezier` a piece of it.
struct Offset_twice {
  Offset first, second;
};

/// \param first, second signed distances
/// \guarantee each of both as Offset_source_2::at, of half of eps: the second's points are that far from the first's
///   chains; the second is not COMPLETE where the first is not
[[nodiscard]] Offset_twice offset_twice(const Drawing_2<double>& drawing, double first, double second,
                                        Offset_options options = {});

/// Opening: what discs of a radius cover that are in what closed curves enclose.  Round outer corners are left.
[[nodiscard]] Offset opening(const Drawing_2<double>& drawing, double radius, const Offset_options& options = {});
/// Closing: what discs of a radius do not cover that are outside.  Gaps are closed, and inner corners rounded.
[[nodiscard]] Offset closing(const Drawing_2<double>& drawing, double radius, const Offset_options& options = {});

}  // namespace CGAL::Bounding_arcs

#ifndef BOUNDING_ARCS_KERNELS
#include <CGAL/Bounding_arcs_2/internal/offset/offset_series_impl.h>
#endif

#endif
