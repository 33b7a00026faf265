// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The order in which independent work at many places is done: along a curve that fills the plane, so that what lies
// side by side is looked at in turn, while it is in the processor's cache (Morton 1966).

#ifndef BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_ORDER_BY_PLACE_H
#define BOUNDING_ARCS_LIBRARY_MEDIAL_AXIS_ORDER_BY_PLACE_H

#include <CGAL/Bounding_arcs_2/number/Xy.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// \param place Xy<double>(std::uint32_t i), where work i is
/// \param size no coordinate of curves is larger
/// \return 0, ..., count - 1, ordered by place
template <class Place_of>
[[nodiscard]] std::vector<std::uint32_t> order_by_place(std::size_t count, const Place_of& place, double size) {
  constexpr int BITS = 12;  // of each coordinate: cells as large as some discs in drawings of 10^7 curves
  const auto cell = [size](double x) {
    constexpr double CELLS = 1U << BITS;
    return static_cast<std::uint32_t>(std::clamp((x / size + 1) * (CELLS / 2), 0.0, CELLS - 1));
  };
  std::vector<std::pair<std::uint32_t, std::uint32_t>> keys(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const Xy<double> p = place(i);
    const std::uint32_t x = cell(p.x), y = cell(p.y);
    std::uint32_t key = 0;
    for (int b = BITS - 1; b >= 0; --b) key = key << 2U | ((x >> b) & 1U) << 1U | ((y >> b) & 1U);
    keys[i] = {key, i};
  }
  std::sort(keys.begin(), keys.end());
  std::vector<std::uint32_t> order(count);
  std::transform(keys.begin(), keys.end(), order.begin(), [](const auto& k) { return k.second; });
  return order;
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
