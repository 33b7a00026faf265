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
#include <CGAL/Bounding_arcs_2/number/Double_double.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/polynomial/Exact_isolation.h>
#include <CGAL/Bounding_arcs_2/spiral/Segment_place.h>
#include <CGAL/Bounding_arcs_2/spiral/internal/Layered_curve.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <stdexcept>
#include <type_traits>

namespace CGAL::Bounding_arcs {

/// Where a curve stops being a spiral segment, and what it is when it never starts being one.
struct Spiral_parameters {
  internal::Short_list<double> breaks;  ///< in increasing order, more than 2^-51 apart and away from 0 and 1
  internal::Short_list<Cut_reason>
      reasons;                  ///< one a break; the first that holds in the order of CUSP, X, Y, INFLECTION, VERTEX
  bool is_point = false;        ///< all control points are equal
  bool is_straight = false;     ///< curvature is zero throughout, or the curve is a point
  bool is_circular = false;     ///< curvature is constant and not zero
  bool has_hidden_tip = false;  ///< x' and y' vanish where no break is kept, but not at an end of equal control points
};

namespace internal {

/// What is asked of a curve to cut it, but for doubles each when it is first needed.
struct Cut_numbers {
  std::function<const Curve_numbers<Double_double>&()> fine;
  std::function<Root_oracle(Numerator)> exact;
  std::function<bool(bool at_start)> has_double_end;  ///< the two control points there are one
};

/// Calls work(numbers) with the numbers of a curve.
template <class NT, class Work> [[nodiscard]] auto with_cut_numbers(const Bezier_curve_2<NT>& curve, const Work& work) {
  std::optional<Layered_curve<NT>> layered;
  const auto made = [&]() -> Layered_curve<NT>& { return layered ? *layered : layered.emplace(curve); };
  const auto& p = curve.control_points();
  const auto fine = [&made]() -> const Curve_numbers<Double_double>& { return made().fine(); };
  const auto exact = [&made](Numerator which) {
    using Ring = typename Layered_curve<NT>::Ring;
    return Root_oracle(Numerator_builder<Ring>(made().exact())(which));
  };
  const auto has_double_end = [&p](bool at_start) {
    return at_start ? p[0] == p[1] : p[p.size() - 1] == p[p.size() - 2];
  };
  return work(Cut_numbers{fine, exact, has_double_end});
}

class Cubic_roots;  // src/library/spiral/Cubic_roots.h

/// Cuts a curve. \param filter tells roots where it knows them
[[nodiscard]] Spiral_parameters spiral_cuts(const Cut_numbers& curve, const Cubic_roots* filter = nullptr);

template <class NT> void check_finite(const Bezier_curve_2<NT>& curve) {
  if constexpr (std::is_floating_point_v<NT>) {
    const auto& p = curve.control_points();
    const auto& w = curve.weights();
    if (!std::all_of(p.begin(), p.end(), [](const Xy<NT>& q) { return std::isfinite(q.x) && std::isfinite(q.y); }) ||
        !std::all_of(w.begin(), w.end(), [](const NT& x) { return std::isfinite(x); }))
      throw std::invalid_argument(expected("curve", "finite coordinates and weights", "inf or nan"));
  }
}

}  // namespace internal

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
  internal::check_finite(curve);
  return internal::with_cut_numbers(
      curve, [](const internal::Cut_numbers& numbers) { return internal::spiral_cuts(numbers); });
}
template <> Spiral_parameters spiral_parameters(const Bezier_curve_2<double>& curve);

}  // namespace CGAL::Bounding_arcs

#endif
