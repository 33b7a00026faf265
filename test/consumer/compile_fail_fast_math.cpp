// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Must not compile with options that void error bounds, and must without: any header refuses them.

#include <CGAL/Bounding_arcs_2/number/Xy.h>

int main() { return CGAL::Bounding_arcs::Xy<double>{1, 2}.x < 1 ? 1 : 0; }
