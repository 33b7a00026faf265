// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of verify/outside_bound.h.

#include "Outside_proof.h"

namespace CGAL::Bounding_arcs {
namespace {

using verify::Boundary_origin;

template <class FT> bool is_finite(const Region_boundary_2<FT>& boundary) {
  for (const auto* chain : {&boundary.inner, &boundary.outer})
    for (const Boundary_piece_2<FT>& p : *chain)
      for (const FT x : {p.from.x, p.from.y, p.to.x, p.to.y, p.support.point.x, p.support.point.y, p.support.normal.x,
                         p.support.normal.y, p.support.curvature})
        if (!std::isfinite(x)) return false;
  return true;
}

template <class FT>
double exact_bound(const internal::Proven_piece& piece, const Region_boundary_2<FT>& boundary, double goal,
                   Boundary_origin origin) {
  return verify::Outside_proof<Exact_rational>(piece, boundary, goal, origin).bound();
}

}  // namespace

template <class FT>
double internal::proven_bound(const Proven_piece& piece, const Region_boundary_2<FT>& boundary, double goal,
                              Boundary_origin origin) {
  // Double-doubles whose errors cut no ends off or let no sign be told, as those of high degrees, have bounds far above
  // any distance that is seen.
  constexpr double FAR = 2;
  if (!is_finite(boundary)) return verify::INFINITE;
  const verify::Outside_proof<Double_double> rough(piece, boundary, goal, origin);
  const auto [most, seen] = rough.bounds();
  if (most <= goal || (std::isfinite(most) && rough.is_significant(most) && most <= FAR * seen)) return most;
  return exact_bound(piece, boundary, goal, origin);
}

template <class FT>
bool internal::is_proven_within(const Proven_piece& piece, const Region_boundary_2<FT>& boundary, double widening) {
  // A search that ends at the widening leaves no room for what joints add to it. What ends are cut off by depends on
  // the goal in steps, so that a lower one may tell less: the middle one is near to where a widening was found.
  for (const double goal : {widening, 0.64 * widening, 0.5 * widening})
    if (proven_bound(piece, boundary, goal, Boundary_origin::PLANE) <= widening) return true;
  return is_finite(boundary) && exact_bound(piece, boundary, widening / 2, Boundary_origin::PLANE) <= widening;
}

template double internal::proven_bound(const Proven_piece&, const Region_boundary_2<float>&, double, Boundary_origin);
template bool internal::is_proven_within(const Proven_piece&, const Region_boundary_2<float>&, double);
template double internal::proven_bound(const Proven_piece&, const Region_boundary_2<double>&, double, Boundary_origin);
template bool internal::is_proven_within(const Proven_piece&, const Region_boundary_2<double>&, double);
template double internal::proven_bound(const Proven_piece&, const Region_boundary_2<long double>&, double,
                                       Boundary_origin);
template bool internal::is_proven_within(const Proven_piece&, const Region_boundary_2<long double>&, double);

}  // namespace CGAL::Bounding_arcs
