// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Exact intersections of pieces, once for all programs: no other one reads the algebra behind them.

#if defined(__GNUC__) && !defined(__clang__) && __GNUC__ >= 12
// GCC takes the last owner of one of CGAL's shared polynomials for one of several, and warns
#pragma GCC diagnostic ignored "-Wuse-after-free"
#endif

#include <CGAL/Bounding_arcs_2/query/internal/exact_intersections_impl.h>

namespace CGAL::Bounding_arcs {

template Piece_intersections exact_intersections(const Bezier_curve_2<Exact_rational>&,
                                                 const Bezier_curve_2<Exact_rational>&);
template Piece_intersections exact_self_intersections(const Bezier_curve_2<Exact_rational>&);
template std::vector<Parameter_range> exact_parameters_at(const Bezier_curve_2<Exact_rational>&,
                                                          const Xy<Exact_rational>&);
template Ray_crossings exact_ray_crossings(const Bezier_curve_2<Exact_rational>&, const Xy<Exact_rational>&);

}  // namespace CGAL::Bounding_arcs
