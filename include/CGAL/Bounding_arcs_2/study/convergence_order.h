// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How fast a method's regions become thin: the exponent p of thickness = c h^p, fitted over pieces of size h.

#ifndef CGAL_BOUNDING_ARCS_2_STUDY_CONVERGENCE_ORDER_H
#define CGAL_BOUNDING_ARCS_2_STUDY_CONVERGENCE_ORDER_H

#include <CGAL/Bounding_arcs_2/number/stable_norm.h>
#include <CGAL/Bounding_arcs_2/region/thickness_bound.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/assertions.h>

#include <cmath>
#include <vector>

namespace CGAL::Bounding_arcs {

/// A piece's size, the distance of its ends, and the thickness of its region.
struct Piece_size {
  double size, thickness;
};

/// The pieces of parameters t to t + width, halved `count` times less one, the longest first: thickness in 128 bits of
/// the exact piece, so that no rounding shows however short pieces are.
/// \tparam Spiral Bezier_spiral_2, of which t + width has to be a parameter
template <class Construction, class Spiral>
[[nodiscard]] std::vector<Piece_size> piece_sizes(const Construction& construction, const Spiral& spiral, double t,
                                                  double width, int count) {
  using Exact = typename Spiral::Exact_number_type;
  constexpr mpfr_prec_t BITS = 128;
  std::vector<Piece_size> sizes;
  for (; count > 0; --count, width /= 2) {
    const auto shape = spiral.template shape<Exact>(t, t + width, shape_parts<Construction>());
    const double unit = CGAL::to_double(shape.unit), x = CGAL::to_double(shape.chord.x),
                 y = CGAL::to_double(shape.chord.y);
    if (const auto thickness = thickness_enclosure(construction, shape, BITS))
      sizes.push_back({unit * stable_norm(Xy<double>{x, y}), thickness->middle()});
  }
  return sizes;
}

/// The slope of the line of least squares through the logarithms. \pre two sizes at least, thicknesses above 0
[[nodiscard]] inline double convergence_order(const std::vector<Piece_size>& sizes) {
  CGAL_precondition(sizes.size() >= 2);
  double x = 0, y = 0, xx = 0, xy = 0;
  for (const Piece_size& s : sizes) {
    const double u = std::log(s.size), v = std::log(s.thickness);
    x += u;
    y += v;
    xx += u * u;
    xy += u * v;
  }
  const double n = static_cast<double>(sizes.size());
  return (n * xy - x * y) / (n * xx - x * x);
}

}  // namespace CGAL::Bounding_arcs

#endif
