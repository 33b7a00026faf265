// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The names of the tree and of its default traits, for functions that take a tree: these compile without CGAL's
// circular kernel.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_TREE_DECLARATION_H
#define CGAL_BOUNDING_ARCS_2_TREE_TREE_DECLARATION_H

#include <CGAL/Bounding_arcs_2/number/strict_math.h>

namespace CGAL::Bounding_arcs {

class Default_traits_2;  // region/Default_traits_2.h
template <class Traits, class Spiral, class Decider> class Bounding_arc_tree_2;

}  // namespace CGAL::Bounding_arcs

#endif
