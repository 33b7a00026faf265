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
/// \param of of(tag) returns that for the set of a tag
template <class Of> [[nodiscard]] auto function_for([[maybe_unused]] Build_options::Instruction_set set, const Of& of) {
#ifdef __x86_64__
  if (set >= Build_options::Instruction_set::AVX512 &&
      Build_options::is_available(Build_options::Instruction_set::AVX512))
    return of(Avx512_set());
  if (set >= Build_options::Instruction_set::AVX2 && Build_options::is_available(Build_options::Instruction_set::AVX2))
    return of(Avx2_set());
#endif
  return of(Base_set());
}

}  // namespace CGAL::Bounding_arcs

// Which sets a source of loops is compiled for: one, whose tag BOUNDING_ARCS_ISA names, or all.
#ifdef BOUNDING_ARCS_ISA
#define BOUNDING_ARCS_FOR_SETS(INSTANTIATE) INSTANTIATE(BOUNDING_ARCS_ISA);
#else  // all of them, for builds whose time is in reading headers
#define BOUNDING_ARCS_FOR_SETS(INSTANTIATE)   \
  INSTANTIATE(CGAL::Bounding_arcs::Base_set); \
  INSTANTIATE(CGAL::Bounding_arcs::Avx2_set); \
  INSTANTIATE(CGAL::Bounding_arcs::Avx512_set);
#endif

#endif
