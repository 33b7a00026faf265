// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Chord shapes rounded to double from double-doubles, or from exact numbers where those do not suffice (next to a
// vertex, where the slope of curvature itself is a difference of nearly equal numbers).

#ifndef CGAL_BOUNDING_ARCS_2_FRAME_ACCURATE_SHAPE_H
#define CGAL_BOUNDING_ARCS_2_FRAME_ACCURATE_SHAPE_H

#include <CGAL/Bounding_arcs_2/frame/Chord_frame_2.h>
#include <CGAL/Bounding_arcs_2/number/Double_double.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <type_traits>

namespace CGAL::Bounding_arcs {

/// A double-double closer to the true value than this share of itself rounds to a double within 0.51 ulp of it.
inline constexpr double ENOUGH = 0x1p-59;

[[nodiscard]] inline bool is_accurate(const Double_double& x) { return x.err <= ENOUGH * std::fabs(x.hi); }
[[nodiscard]] inline bool is_accurate(const Xy<Double_double>& v) {
  return (std::max)(v.x.err, v.y.err) <= ENOUGH * (std::max)(std::fabs(v.x.hi), std::fabs(v.y.hi));
}

/// Whether every member of the shape is so close, vectors by their larger coordinate, and every sign is certain.
[[nodiscard]] inline bool is_accurate(const Chord_shape_2<Double_double>& f, bool with_curvature) {
  const bool common = is_accurate(f.chord) && is_accurate(f.tangent0) && is_accurate(f.tangent1) &&
                      is_accurate(f.tangent_change) && is_accurate(f.cross0) && is_accurate(f.cross1) &&
                      is_accurate(f.square_change) && is_accurate(f.sine_change) && is_accurate(f.unit) &&
                      (f.cross0 + f.cross1).sign().has_value() && f.square_change.sign().has_value() &&
                      dot(f.tangent0, f.chord).sign().has_value() && dot(f.tangent1, f.chord).sign().has_value();
  if (!common || !with_curvature) return common;
  return is_accurate(f.curvature0) && is_accurate(f.curvature1) && is_accurate(f.kneser0) && is_accurate(f.kneser1);
}

/// The shape in a unit near its longest vector where products of six of them would leave the range of double.
template <class NT> [[nodiscard]] Chord_shape_2<NT> in_range(Chord_shape_2<NT> f) {
  constexpr int ORDINARY = 100, LARGEST = 1000;  // exponents
  double longest = 0;
  const auto number = [](const NT& x) {
    if constexpr (std::is_same_v<NT, Double_double>) return x.hi;
    else return CGAL::to_double(x);
  };
  for (const Xy<NT>* v : {&f.chord, &f.tangent0, &f.tangent1})
    longest = (std::max)({longest, std::fabs(number(v->x)), std::fabs(number(v->y))});
  if (!(longest > 0) || std::abs(std::ilogb(longest)) <= ORDINARY) return f;
  const int exponent = std::clamp(std::ilogb(longest), -LARGEST, LARGEST);
  const NT scale(std::ldexp(1.0, -exponent)), square = scale * scale, fourth = square * square;
  for (Xy<NT>* v : {&f.chord, &f.tangent0, &f.tangent1, &f.tangent_change}) *v = scale * *v;
  for (Xy<NT>& q : f.control_points) q = scale * q;
  for (NT* x : {&f.cross0, &f.cross1, &f.cross_change, &f.curvature0, &f.curvature1}) *x = square * *x;
  for (NT* x : {&f.square_change, &f.sine_change, &f.kneser0, &f.kneser1}) *x = fourth * *x;
  f.unit = NT(std::ldexp(1.0, exponent)) * f.unit;
  return f;
}

}  // namespace CGAL::Bounding_arcs

#endif
