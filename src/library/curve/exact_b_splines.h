// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// B-splines of a drawing in doubles with the Bezier pieces that they have in exact numbers: inserted knots are rounded
// in doubles, by which an area differs in its last digits.

#ifndef BOUNDING_ARCS_LIBRARY_CURVE_EXACT_B_SPLINES_H
#define BOUNDING_ARCS_LIBRARY_CURVE_EXACT_B_SPLINES_H

#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>
#include <CGAL/Bounding_arcs_2/number/Exact_number.h>
#include <CGAL/Bounding_arcs_2/number/number_types.h>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

using Exact_chain = std::vector<Bezier_curve_2<Exact_rational>>;

[[nodiscard]] inline Exact_chain exact_chain(const std::vector<Bezier_curve_2<double>>& pieces) {
  Exact_chain chain;
  for (const Bezier_curve_2<double>& piece : pieces) {
    std::vector<Xy<Exact_rational>> points;
    for (const Xy<double>& p : piece.control_points()) points.push_back({Exact_rational(p.x), Exact_rational(p.y)});
    chain.emplace_back(std::move(points), std::vector<Exact_rational>(piece.weights().begin(), piece.weights().end()));
  }
  return chain;
}

[[nodiscard]] inline bool is_same(const Exact_chain& a, const Exact_chain& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i].control_points() != b[i].control_points() || a[i].weights() != b[i].weights()) return false;
  return true;
}

/// \param keep_closed a curve that is closed in doubles only keeps its pieces as they are
/// \return nothing where no piece is rounded
/// \complexity some hundred microseconds a piece of a B-spline
[[nodiscard]] inline std::optional<Drawing_2<Exact_rational>> exact_b_splines(const Drawing_2<double>& drawing,
                                                                              bool keep_closed) {
  Drawing_2<Exact_rational> exact;
  bool is_rounded = false;
  for (const auto& curve : drawing.curves()) is_rounded = is_rounded || curve.b_spline;
  if (!is_rounded) return std::nullopt;
  is_rounded = false;
  for (const auto& curve : drawing.curves()) {
    Exact_chain chain = exact_chain(curve.beziers);
    if (curve.b_spline) {
      Exact_chain pieces = curve.b_spline->over<Exact_rational>().bezier_pieces();
      const bool is_closed = pieces.front().control_points().front() == pieces.back().control_points().back();
      if ((is_closed || !curve.is_closed || !keep_closed) && !is_same(chain, pieces)) {
        chain = std::move(pieces);
        is_rounded = true;
      }
    }
    exact.add(std::move(chain), curve.name);
  }
  return is_rounded ? std::optional(std::move(exact)) : std::nullopt;
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
