// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The registers that loops over many pieces are compiled for.

#ifndef BOUNDING_ARCS_LIBRARY_TREE_INSTRUCTION_SETS_H
#define BOUNDING_ARCS_LIBRARY_TREE_INSTRUCTION_SETS_H

#include <CGAL/Bounding_arcs_2/tree/Build_options.h>

namespace CGAL::Bounding_arcs {

struct Base_set {};
struct Avx2_set {};
struct Avx512_set {};
struct One_by_one {};  ///< no registers: for few pieces

/// The compiled function for a set, or for the widest below it that this machine has.
/// \tparam Of what has of<Isa>() for each
template <class Of> [[nodiscard]] auto function_for([[maybe_unused]] Instruction_set set) {
#ifdef __x86_64__
  if (set >= Instruction_set::AVX512 && is_available(Instruction_set::AVX512)) return Of::template of<Avx512_set>();
  if (set >= Instruction_set::AVX2 && is_available(Instruction_set::AVX2)) return Of::template of<Avx2_set>();
#endif
  return Of::template of<Base_set>();
}

}  // namespace CGAL::Bounding_arcs

#endif
