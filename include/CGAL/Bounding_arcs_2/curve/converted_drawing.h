// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A drawing over another number type.

#ifndef CGAL_BOUNDING_ARCS_2_CURVE_CONVERTED_DRAWING_H
#define CGAL_BOUNDING_ARCS_2_CURVE_CONVERTED_DRAWING_H

#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>
#include <CGAL/Bounding_arcs_2/number/Exact_number.h>
#include <CGAL/Bounding_arcs_2/number/convert.h>

#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

/// Converts a drawing: each number is converted by convert(): exactly where the target holds it, else rounded.
template <class To, class From> [[nodiscard]] Drawing_2<To> converted(const Drawing_2<From>& drawing) {
  const auto number = [](const From& x) {
    if constexpr (std::is_same_v<From, long double> && !std::is_floating_point_v<To>)
      return convert<To>(Exact_number<From>::make(x));
    else return convert<To>(x);
  };
  const auto numbers = [&](const std::vector<From>& all) {
    std::vector<To> result;
    result.reserve(all.size());
    for (const From& x : all) result.push_back(number(x));
    return result;
  };
  Drawing_2<To> result;
  for (const auto& curve : drawing.curves()) {
    std::vector<Bezier_curve_2<To>> chain;
    for (const auto& piece : curve.beziers) {
      std::vector<Xy<To>> points;
      for (const auto& p : piece.control_points()) points.push_back({number(p.x), number(p.y)});
      chain.emplace_back(std::move(points), numbers(piece.weights()));
    }
    result.add(std::move(chain), curve.name, numbers(curve.parameters));
  }
  return result;
}

}  // namespace CGAL::Bounding_arcs

#endif
