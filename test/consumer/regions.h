// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the consumers' library offers to their program, which does not see Bounding Arcs.

#ifndef BOUNDING_ARCS_CONSUMER_REGIONS_H
#define BOUNDING_ARCS_CONSUMER_REGIONS_H

#include <cstddef>

/// The number of regions of a looping cubic's hierarchy, or 0 if eps was not reached.
std::size_t number_of_regions(double eps);

#endif
