// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Who decides the pieces of a tree: the filter where it serves traits and segments, else each piece by itself.  With
// BOUNDING_ARCS_WITHOUT_FILTER nothing of the filter is included.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_INTERNAL_BATCH_DEFAULT_DECIDER_H
#define CGAL_BOUNDING_ARCS_2_TREE_INTERNAL_BATCH_DEFAULT_DECIDER_H

#include <CGAL/Bounding_arcs_2/tree/Plain_decider.h>
#ifndef BOUNDING_ARCS_WITHOUT_FILTER
#include <CGAL/Bounding_arcs_2/tree/internal/batch/Filtered_decider.h>

#include <type_traits>
#endif

namespace CGAL::Bounding_arcs {

#ifdef BOUNDING_ARCS_WITHOUT_FILTER
template <class Traits, class Spiral> using Default_decider = Plain_decider<Traits, Spiral>;
#else
template <class Traits, class Spiral>
using Default_decider = std::conditional_t<filter::serves_v<Traits, Spiral>, filter::Filtered_decider<Traits, Spiral>,
                                           Plain_decider<Traits, Spiral> >;
#endif

}  // namespace CGAL::Bounding_arcs

#endif
