// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which loop serves a construction on this machine: the one for the widest registers there are.  The results are the
// same bits for all.  A construction without formulas has none: its pieces are bounded, and its arcs made, one by one.

#ifndef BOUNDING_ARCS_LIBRARY_TREE_BATCH_BATCH_FUNCTIONS_H
#define BOUNDING_ARCS_LIBRARY_TREE_BATCH_BATCH_FUNCTIONS_H

#include <CGAL/Bounding_arcs_2/number/Bracket.h>
#include <CGAL/Bounding_arcs_2/region/Arc_region_2.h>
#include <CGAL/Bounding_arcs_2/region/Bca.h>
#include <CGAL/Bounding_arcs_2/region/Bilens.h>
#include <CGAL/Bounding_arcs_2/region/Spiral_fat_arc.h>
#include <CGAL/Bounding_arcs_2/tree/Build_options.h>
#include "../../tree/Instruction_sets.h"
#include "Batch_questions.h"

#include <cstddef>
#include <cstdint>

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

/// The regions that formulas for arcs make.
template <class Arcs> inline constexpr Region_form FORM = Region_form::BCA;
template <> inline constexpr Region_form FORM<Bilens_arcs> = Region_form::BILENS;
template <> inline constexpr Region_form FORM<Spiral_fat_arc_arcs> = Region_form::SPIRAL_FAT_ARC;

/// The functions that bound thickness, for function_for.
template <class Method> struct Bounds_of_kind {
  using Lookup = Batch_function (*)(int kind);
  template <class Isa> [[nodiscard]] static Lookup of() { return &compiled_batch<Isa, Method>; }
};
/// The functions that decide first levels, for function_for.
template <class Method> struct Tops_of_kind {
  using Lookup = Top_function (*)(int kind);
  template <class Isa> [[nodiscard]] static Lookup of() { return &compiled_top<Isa, Method>; }
};
/// The functions that make arcs, for function_for.
template <class Arcs> struct Arcs_of_kind {
  using Lookup = Arc_function (*)(int kind);
  template <class Isa> [[nodiscard]] static Lookup of() { return &compiled_arcs<Isa, Arcs>; }
};
/// The functions that make arcs of eight segments, for function_for.
template <class Arcs> struct Lanes_of_kind {
  using Lookup = Lanes_function (*)(int kind);
  template <class Isa> [[nodiscard]] static Lookup of() { return &compiled_lanes<Isa, Arcs>; }
};

/// The loops of one method by kinds of curves; null where pieces are to be bounded one by one.
class Batch_functions {
 public:
  template <class Method> [[nodiscard]] static Batch_functions of(Instruction_set set) {
    Batch_functions f;
    if (set == Instruction_set::NONE) return f;
    f.many_ = function_for<Bounds_of_kind<Method>>(set);
    f.one_ = &compiled_one<Method>;
    f.top_ = function_for<Tops_of_kind<Method>>(set);
    return f;
  }
  [[nodiscard]] Batch_function operator()(const Local_curve& curve) const {
    return many_ != nullptr ? many_(curve.kind) : nullptr;
  }
  /// Returns the function for single pieces, where a batch would take longer.
  [[nodiscard]] Bound_function of_one(const Local_curve& curve) const {
    return one_ != nullptr ? one_(curve.kind) : nullptr;
  }
  /// Returns the function for the first levels of eight segments of a kind.
  [[nodiscard]] Top_function of_top(int kind) const { return top_ != nullptr ? top_(kind) : nullptr; }

 private:
  Batch_function (*many_)(int kind) = nullptr;
  Bound_function (*one_)(int kind) = nullptr;
  Top_function (*top_)(int kind) = nullptr;
};

/// The loops that make the arcs of regions, the same bits; null where regions are to be made one by one.
template <class Arcs> class Arc_functions {
 public:
  explicit Arc_functions(Instruction_set set) {
    if (set == Instruction_set::NONE) return;
    many_ = function_for<Arcs_of_kind<Arcs>>(set);
    few_ = &compiled_few<Arcs>;
    lanes_ = function_for<Lanes_of_kind<Arcs>>(set);
  }
  /// Makes arcs in groups of eight pieces.
  [[nodiscard]] Arc_function of_many(int kind) const { return many_ != nullptr ? many_(kind) : nullptr; }
  /// Makes arcs piece by piece, which is quicker for one or two.
  [[nodiscard]] Arc_function of_few(int kind) const { return few_ != nullptr ? few_(kind) : nullptr; }
  /// Makes the arcs of eight segments.
  [[nodiscard]] Lanes_function of_lanes(int kind) const { return lanes_ != nullptr ? lanes_(kind) : nullptr; }

 private:
  Arc_function (*many_)(int kind) = nullptr;
  Arc_function (*few_)(int kind) = nullptr;
  Lanes_function (*lanes_)(int kind) = nullptr;
};

}  // namespace filter
}  // namespace CGAL::Bounding_arcs

#endif
