// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Spiral segments of Bezier curves over double, once for all programs.

#include <CGAL/Bounding_arcs_2/spiral/Bezier_spiral_2.h>

namespace CGAL::Bounding_arcs {

template void check_served(const Bezier_curve_2<double>&);
template Spiral_parameters spiral_parameters(const Bezier_curve_2<double>&);

template class Tabulated_bezier<double>;
template const Taylor_table<double>& Tabulated_bezier<double>::table() const;
template const Taylor_table<Bounded_double>& Tabulated_bezier<double>::table() const;
template const Taylor_table<Double_double>& Tabulated_bezier<double>::table() const;
template const Taylor_table<Exact_rational>& Tabulated_bezier<double>::table() const;

template class Bezier_spiral_2<double>;
template Chord_shape_2<double> Bezier_spiral_2<double>::shape_from_table(double, double, const Shape_parts&) const;
template Chord_shape_2<Bounded_double> Bezier_spiral_2<double>::shape_from_table(double, double,
                                                                                 const Shape_parts&) const;
template Chord_shape_2<Double_double> Bezier_spiral_2<double>::shape_from_table(double, double,
                                                                                const Shape_parts&) const;
template Chord_shape_2<Exact_rational> Bezier_spiral_2<double>::shape_from_table(double, double,
                                                                                 const Shape_parts&) const;
template std::vector<Bezier_spiral_2<double>> spiral_segments(const Bezier_curve_2<double>&, const Segment_place&);
template std::vector<Bezier_spiral_2<double>> spiral_segments(const Drawing_2<double>&, std::size_t, std::size_t);

}  // namespace CGAL::Bounding_arcs
