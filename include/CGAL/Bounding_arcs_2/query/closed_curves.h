// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A check for what is asked of closed curves only.

#ifndef CGAL_BOUNDING_ARCS_2_QUERY_CLOSED_CURVES_H
#define CGAL_BOUNDING_ARCS_2_QUERY_CLOSED_CURVES_H

#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>

#include <cstddef>
#include <stdexcept>
#include <string>

namespace CGAL::Bounding_arcs {

/// \throws std::invalid_argument if a curve is open, with its number, from 0, and its name
template <class NT> void check_closed(const Drawing_2<NT>& drawing) {
  for (std::size_t i = 0; i < drawing.curves().size(); ++i) {
    const auto& curve = drawing.curves()[i];
    if (curve.is_closed) continue;
    const std::string name = curve.name.empty() ? std::string() : " '" + curve.name + "'";
    throw std::invalid_argument(
        expected("curve " + text_of(i) + name, "a closed curve, which has an inside", "an open one"));
  }
}

}  // namespace CGAL::Bounding_arcs

#endif
