// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The registers that loops over many pieces run in.  The library has each loop for every set; the machine tells which
// one is called.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_INSTRUCTION_SET_H
#define CGAL_BOUNDING_ARCS_2_TREE_INSTRUCTION_SET_H

#include <CGAL/Bounding_arcs_2/number/strict_math.h>

namespace CGAL::Bounding_arcs {

/// Registers that the filter runs in, NONE: every piece is bounded by itself. Results do not depend on it.
enum class Instruction_set { NONE, BASE, AVX2, AVX512, BEST };

struct Base_set {};
struct Avx2_set {};
struct Avx512_set {};
struct One_by_one {};  ///< no registers: for few pieces

/// Tells whether this machine has an instruction set.
[[nodiscard]] inline bool is_available(Instruction_set set) {
#ifdef __x86_64__
  __builtin_cpu_init();
  if (set == Instruction_set::AVX2) return __builtin_cpu_supports("avx2");
  if (set == Instruction_set::AVX512)
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl");
#endif
  return set == Instruction_set::BASE;
}

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
