// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which loop serves a construction on this machine: the one for the widest registers there are.  The results are the
// same bits for all.

#ifndef BOUNDING_ARCS_LIBRARY_TREE_BATCH_BATCH_FUNCTIONS_H
#define BOUNDING_ARCS_LIBRARY_TREE_BATCH_BATCH_FUNCTIONS_H

#include <CGAL/Bounding_arcs_2/number/Bracket.h>
#include <CGAL/Bounding_arcs_2/region/Arc_region_2.h>
#include <CGAL/Bounding_arcs_2/region/Bca.h>
#include <CGAL/Bounding_arcs_2/region/Bilens.h>
#include <CGAL/Bounding_arcs_2/region/Spiral_fat_arc.h>
#include <CGAL/Bounding_arcs_2/tree/Build_options.h>
#include <CGAL/Bounding_arcs_2/tree/internal/Piece_filter.h>
#include "../../tree/Instruction_sets.h"
#include "Batch_questions.h"

#include <cstddef>
#include <cstdint>

namespace CGAL::Bounding_arcs::filter {

/// Formulas of a construction.
template <class Construction> struct Formulas;
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

/// Calls f(Formulas<Construction>()), for a method that has formulas.
/// \return what f does, or without formulas a value of this type
template <class Call> auto with_formulas(Method method, const Call& f) -> decltype(f(Formulas<Bca>())) {
  switch (method) {
    case Method::BCA:
      return f(Formulas<Bca>());
    case Method::BILENS:
      return f(Formulas<Bilens>());
    case Method::SPIRAL_FAT_ARC:
      return f(Formulas<Spiral_fat_arc>());
    default:
      return decltype(f(Formulas<Bca>()))();
  }
}

/// The regions that formulas for arcs make.
template <class Arcs> inline constexpr Region_form FORM = Region_form::BCA;
template <> inline constexpr Region_form FORM<Bilens_arcs> = Region_form::BILENS;
template <> inline constexpr Region_form FORM<Spiral_fat_arc_arcs> = Region_form::SPIRAL_FAT_ARC;

/// The loops of one method by kinds of curves; null for kind 0, whose pieces are to be bounded one by one.
struct Batch_functions {
  /// \pre set is not NONE
  template <class Method> [[nodiscard]] static Batch_functions of(Build_options::Instruction_set set) {
    return {function_for(set, [](auto isa) { return &batch_function<decltype(isa), Method>; }), &one_function<Method>,
            function_for(set, [](auto isa) { return &top_function<decltype(isa), Method>; })};
  }

  Batch_function (*many)(int kind) = nullptr;
  Bound_function (*one)(int kind) = nullptr;  ///< for single pieces, where a batch would take longer
  Top_function (*top)(int kind) = nullptr;    ///< for the first levels of eight segments
};

/// The loops that make arcs of a construction.
struct Arc_functions {
  /// \pre set is not NONE
  template <class Arcs> [[nodiscard]] static Arc_functions of(Build_options::Instruction_set set) {
    return {function_for(set, [](auto isa) { return &arc_function<decltype(isa), Arcs>; }),
            &few_function<Arcs>,
            function_for(set, [](auto isa) { return &lanes_function<decltype(isa), Arcs>; }),
            &arc_room<Arcs>,
            HAS_JOINTS<Arcs>,
            FORM<Arcs>};
  }

  Arc_function (*many)(int kind);  ///< in groups of eight pieces
  Arc_function (*few)(int kind);   ///< piece by piece, which is quicker for one or two
  Lanes_function (*lanes)(int kind);
  Arc_room (*room)(const Local_curve&, const Point_sizes&);
  bool has_joints;
  Region_form form;
};

}  // namespace CGAL::Bounding_arcs::filter

#endif
