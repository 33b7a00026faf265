// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which batch loop serves a construction on this machine.  With the compiled kernels of src/ (BOUNDING_ARCS_KERNELS,
// set by the CMake target) it is the one for the widest registers there are; without, the same loop as the including
// file's options compile it.  The results are the same bits.

#ifndef CGAL_BOUNDING_ARCS_2_FILTER_BATCH_FUNCTION_H
#define CGAL_BOUNDING_ARCS_2_FILTER_BATCH_FUNCTION_H

#include <CGAL/Bounding_arcs_2/filter/bound_batch.h>
#include <CGAL/Bounding_arcs_2/tree/Build_options.h>

#include <cstddef>

namespace CGAL::Bounding_arcs {

namespace filter {

using Batch_function = Batch_decision (*)(const Batch_curve&, const Batch_pieces& pieces, double eps, double* upper);

struct Base_set {};
struct Avx2_set {};
struct Avx512_set {};

/// bound_batch compiled for one instruction set; defined in src/kernels/batch_kernels.cpp.
template <class Isa, class Method, int DEGREE>
Batch_decision compiled_batch(const Batch_curve& curve, const Batch_pieces& pieces, double eps, double* upper);

[[nodiscard]] inline bool is_available(Instruction_set set) {
#if defined(BOUNDING_ARCS_KERNELS) && defined(__x86_64__)
  __builtin_cpu_init();
  if (set == Instruction_set::AVX2) return __builtin_cpu_supports("avx2");
  if (set == Instruction_set::AVX512)
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl");
#endif
  return set == Instruction_set::BASE;
}

/// \param set where this machine does not have it, the widest below it is taken
template <class Method, int DEGREE> [[nodiscard]] Batch_function batch_function([[maybe_unused]] Instruction_set set) {
#ifdef BOUNDING_ARCS_KERNELS
#ifdef __x86_64__
  if (set >= Instruction_set::AVX512 && is_available(Instruction_set::AVX512))
    return &compiled_batch<Avx512_set, Method, DEGREE>;
  if (set >= Instruction_set::AVX2 && is_available(Instruction_set::AVX2))
    return &compiled_batch<Avx2_set, Method, DEGREE>;
#endif
  return &compiled_batch<Base_set, Method, DEGREE>;
#else
  return &bound_batch<Base_set, Method, DEGREE>;
#endif
}

/// The loops of one method by degree; null where pieces are to be bounded one by one.
class Batch_functions {
 public:
  template <class Method> [[nodiscard]] static Batch_functions of(Instruction_set set) {
    Batch_functions f;
    if (set == Instruction_set::NONE) return f;
    f.function_[3] = batch_function<Method, 3>(set);
    f.function_[4] = batch_function<Method, 4>(set);
    f.function_[5] = batch_function<Method, 5>(set);
    return f;
  }
  [[nodiscard]] Batch_function operator()(const Local_curve& curve) const { return function_[curve.degree]; }

 private:
  Batch_function function_[MAX_LOCAL_DEGREE + 1] = {};
};

}  // namespace filter
}  // namespace CGAL::Bounding_arcs

#endif
