// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which formulas serve a construction's regions in batches, for thickness and for arcs.  A construction without any
// needs none: its pieces are bounded, and its arcs made, one by one.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_INTERNAL_BATCH_FORMULAS_H
#define CGAL_BOUNDING_ARCS_2_TREE_INTERNAL_BATCH_FORMULAS_H

#include <CGAL/Bounding_arcs_2/region/Bca.h>
#include <CGAL/Bounding_arcs_2/region/Bilens.h>
#include <CGAL/Bounding_arcs_2/region/Spiral_fat_arc.h>
#include <CGAL/Bounding_arcs_2/tree/internal/batch/Bca_arcs.h>
#include <CGAL/Bounding_arcs_2/tree/internal/batch/Bca_batch.h>
#include <CGAL/Bounding_arcs_2/tree/internal/batch/Bilens_arcs.h>
#include <CGAL/Bounding_arcs_2/tree/internal/batch/Bilens_batch.h>
#include <CGAL/Bounding_arcs_2/tree/internal/batch/Spiral_fat_arc_arcs.h>
#include <CGAL/Bounding_arcs_2/tree/internal/batch/Spiral_fat_arc_batch.h>

namespace CGAL::Bounding_arcs {

template <class Construction> struct With_algebraic_boundary;

namespace filter {

/// Formulas of a construction, void where there are none.
template <class Construction> struct Formulas {
  using Type = void;
  using Arcs = void;
};
/// The formulas of BCA.
template <> struct Formulas<Bca> {
  using Type = Bca_batch;
  using Arcs = Bca_arcs;
};
/// The formulas of bilens.
template <> struct Formulas<Bilens> {
  using Type = Bilens_batch;
  using Arcs = Bilens_arcs;
};
/// The formulas of SFA.
template <> struct Formulas<Spiral_fat_arc> {
  using Type = Spiral_fat_arc_batch;
  using Arcs = Spiral_fat_arc_arcs;
};
template <class Construction> struct Formulas<With_algebraic_boundary<Construction>> : Formulas<Construction> {};

}  // namespace filter
}  // namespace CGAL::Bounding_arcs

#endif
