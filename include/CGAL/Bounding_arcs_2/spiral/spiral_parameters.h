// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The parameters that cut a Bezier curve into spiral segments: between neighbouring ones both coordinates are
// monotone and curvature is monotone and keeps its sign, but for slivers beside a cut as short as rounding. They are
// roots in (0,1) of x', y', curvature and its derivative; of several roots within CUT_WIDTH one is the cut.

#ifndef CGAL_BOUNDING_ARCS_2_SPIRAL_SPIRAL_PARAMETERS_H
#define CGAL_BOUNDING_ARCS_2_SPIRAL_SPIRAL_PARAMETERS_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/number/Exact_number.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/spiral/Segment_place.h>
#include <CGAL/Bounding_arcs_2/spiral/internal/cut_count.h>
#include <CGAL/Bounding_arcs_2/spiral/internal/numerator_roots.h>

#include <CGAL/FPU.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <type_traits>

namespace CGAL::Bounding_arcs {

/// Where a curve stops being a spiral segment, and what it is when it never starts being one.
struct Spiral_parameters {
  Short_list<double> breaks;       ///< in increasing order, more than 2^-51 apart and away from 0 and 1
  Short_list<Cut_reason> reasons;  ///< one a break; the first that holds in the order of CUSP, X, Y, INFLECTION, VERTEX
  bool is_point = false;           ///< all control points are equal
  bool is_straight = false;        ///< curvature is zero throughout, or the curve is a point
  bool is_circular = false;        ///< curvature is constant and not zero
  bool has_hidden_tip = false;  ///< x' and y' vanish where no break is kept, but not at an end of equal control points
};

template <class NT> [[nodiscard]] bool is_finite(const Bezier_curve_2<NT>& curve) {
  if constexpr (std::is_floating_point_v<NT>) {
    const auto& p = curve.control_points();
    const auto& w = curve.weights();
    return std::all_of(p.begin(), p.end(), [](const Xy<NT>& q) { return std::isfinite(q.x) && std::isfinite(q.y); }) &&
           std::all_of(w.begin(), w.end(), [](const NT& x) { return std::isfinite(x); });
  } else {
    return true;
  }
}

/// The parameters in (0,1) that cut a curve into spiral segments, and whether it is a point, straight or circular.
/// These are distinct roots of x', y', curvature and its derivative, each rounded to the nearest double. Roots closer
/// than rounding are one cut. One is kept of those within 2^-51 of each other: if possible a common root of x' and y',
/// else a root of either, else the first. None is kept within 2^-51 of an end. A straight curve is cut where x' or y'
/// changes sign or vanishes only; one folded back on itself turns at a cusp. A cusp is told as one if x' and y' vanish
/// at the same double. A cusp that rounding has pulled apart is cut where either vanishes first, and beyond 2^-51
/// wherever else its tight turn has roots. A point has no breaks and counts as straight, too.
/// \param curve any degree, polynomial or rational, over a floating type, a rational or another exact field
/// \throws std::invalid_argument unless all coordinates and weights are finite
/// \guarantee exact: no root is missed, each, rounded to the nearest double, is a break or within 2^-51 of a break or
///   an end; each break is a correctly rounded root; breaks are more than 2^-51 apart and from the ends; `is_...` are
///   decided exactly. Numbers of type double, float, long double are taken for what they are; others must have exact
///   field operations, signs and to_interval. A pair of complex roots as near to the real axis as rounding can tell may
///   add one break, and never hides one.
/// \complexity polynomials of degree up to 4 n - 7, for rational curves 8 n - 11, in interval arithmetic; exact
///   arithmetic for multiple roots, roots shared by an end and identically vanishing polynomials
template <class NT> [[nodiscard]] Spiral_parameters spiral_parameters(const Bezier_curve_2<NT>& curve) {
  if (!is_finite(curve)) throw std::invalid_argument(expected("curve", "finite coordinates and weights", "inf or nan"));
  ++internal::cut_count();
  const Protect_FPU_rounding<true> nearest(CGAL_FE_TONEAREST);
  const internal::Numerator_roots roots = internal::numerator_roots(curve);
  const auto vanishes = [&roots](internal::Numerator which, double t) {
    return internal::vanishes_at(roots[which], t);
  };
  Spiral_parameters r;
  r.breaks = internal::separated_cuts(roots);
  for (const double t : r.breaks) {
    const bool is_x = vanishes(internal::SPEED_X, t), is_y = vanishes(internal::SPEED_Y, t);
    r.reasons.push_back(is_x && is_y                        ? Cut_reason::CUSP
                        : is_x                              ? Cut_reason::X
                        : is_y                              ? Cut_reason::Y
                        : vanishes(internal::INFLECTION, t) ? Cut_reason::INFLECTION
                                                            : Cut_reason::VERTEX);
  }
  r.is_point = roots[internal::SPEED_X].is_zero && roots[internal::SPEED_Y].is_zero;
  r.is_straight = roots[internal::INFLECTION].is_zero;
  r.is_circular = roots[internal::CURVATURE_CHANGE].is_zero && !r.is_straight;
  r.has_hidden_tip = internal::has_hidden_tip(curve, roots, r.breaks);
  return r;
}

// compiled in the library
extern template Spiral_parameters spiral_parameters(const Bezier_curve_2<double>&);

}  // namespace CGAL::Bounding_arcs

#endif
