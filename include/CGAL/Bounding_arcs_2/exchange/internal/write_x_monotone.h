// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Splitting curves of CGAL's arrangements: the same with CGAL 5 and 6.

#ifndef CGAL_BOUNDING_ARCS_2_EXCHANGE_INTERNAL_WRITE_X_MONOTONE_H
#define CGAL_BOUNDING_ARCS_2_EXCHANGE_INTERNAL_WRITE_X_MONOTONE_H

#include <CGAL/Bounding_arcs_2/region/variant.h>

#include <boost/iterator/function_output_iterator.hpp>

namespace CGAL::Bounding_arcs::internal {

/// Writes the x-monotone parts of a curve, in the order in which the traits hand them out.
template <class Traits, class OutputIterator>
OutputIterator write_x_monotone(const typename Traits::Curve_2& curve, OutputIterator out) {
  const auto keep = [&](const auto& object) {
    if (const auto part = value_as<typename Traits::X_monotone_curve_2>(object)) *out++ = *part;
  };
  Traits().make_x_monotone_2_object()(curve, boost::make_function_output_iterator(keep));
  return out;
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
