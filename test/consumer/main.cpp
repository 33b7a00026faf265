// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The consumers' program.

#include "regions.h"

#include <iostream>

int main() { std::cout << number_of_regions(1e-3) << " regions\n"; }
