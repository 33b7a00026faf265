// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The point of a drawing nearest to a point, or to each of many points, with its distance between two bounds.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_CLOSEST_POINT_H
#define CGAL_BOUNDING_ARCS_2_QUERY_CLOSEST_POINT_H

#include <CGAL/Bounding_arcs_2/internal/tree/for_each_index.h>
#include <CGAL/Bounding_arcs_2/query/Curve_index_2.h>
#include <CGAL/Bounding_arcs_2/query/Query_point.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Bounding_arcs {

/// The point of a drawing nearest to q, one of them where there are several.
/// \return nothing of an empty drawing
/// \guarantee the bracket is certified; it is some roundings of coordinates and distance wide, but next to cusps and
///   centres of curvature, where it may be wider
/// \complexity about logarithmic in the number of segments
/// \throws std::invalid_argument for a point that is no number
[[nodiscard]] std::optional<Closest_point> closest_point(const Curve_index_2& index, const Xy<double>& q);

/// The same by way of a place that is near to the result, that of a neighbouring point, say, which only makes it
/// faster.
/// \param near a place of this drawing
[[nodiscard]] std::optional<Closest_point> closest_point(const Curve_index_2& index, const Xy<double>& q,
                                                         const Curve_place& near);

/// The nearest points to many points, in their order.
/// \tparam ConcurrencyTag CGAL::Sequential_tag or CGAL::Parallel_tag, which needs TBB; where several points are
///   nearest, the two may answer with different ones
/// \return as many as there are points, or none of an empty drawing
/// \guarantee as closest_point; each search starts from the place before, so that neighbours had better be in order
/// \throws std::invalid_argument for a point that is no number
template <class ConcurrencyTag = CGAL::Sequential_tag>
[[nodiscard]] std::vector<Closest_point> closest_points_of_all(const Curve_index_2& index,
                                                               const std::vector<Xy<double>>& points) {
  for (const Xy<double>& q : points) check_point(q);
  if (index.empty()) return {};
  std::vector<Closest_point> results(points.size());
  internal::for_each_range<ConcurrencyTag>(points.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      results[i] =
          i == begin ? *closest_point(index, points[i]) : *closest_point(index, points[i], results[i - 1].place);
  });
  return results;
}

}  // namespace CGAL::Bounding_arcs

#ifndef BOUNDING_ARCS_KERNELS
#include <CGAL/Bounding_arcs_2/internal/query/closest_point_impl.h>
#endif

#endif
