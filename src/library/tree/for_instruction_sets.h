// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which instruction sets a source of loops is compiled for: one, whose tag BOUNDING_ARCS_ISA names, or all.

#ifndef BOUNDING_ARCS_LIBRARY_TREE_FOR_INSTRUCTION_SETS_H
#define BOUNDING_ARCS_LIBRARY_TREE_FOR_INSTRUCTION_SETS_H

#include "Instruction_sets.h"

#ifdef BOUNDING_ARCS_ISA
#define BOUNDING_ARCS_FOR_SETS(INSTANTIATE) INSTANTIATE(BOUNDING_ARCS_ISA);
#else  // all of them, for builds whose time is in reading headers
#define BOUNDING_ARCS_FOR_SETS(INSTANTIATE)   \
  INSTANTIATE(CGAL::Bounding_arcs::Base_set); \
  INSTANTIATE(CGAL::Bounding_arcs::Avx2_set); \
  INSTANTIATE(CGAL::Bounding_arcs::Avx512_set);
#endif

#endif
