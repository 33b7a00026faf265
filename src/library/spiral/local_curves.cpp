// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Local curves with their error bounds, once for all programs; apart from spirals.cpp, where so much code would keep
// that for cubics from being inlined.

#include <CGAL/Bounding_arcs_2/spiral/make_local_curve.h>

template CGAL::Bounding_arcs::Local_curve CGAL::Bounding_arcs::make_local_curve(const Taylor_table<Double_double>&,
                                                                                double, double);
