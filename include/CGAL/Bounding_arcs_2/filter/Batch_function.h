// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which batch loop serves a construction on this machine.  With the compiled kernels of src/ (BOUNDING_ARCS_KERNELS,
// set by the CMake target) it is the one for the widest registers there are; without, the same loop as the including
// file's options compile it.  The results are the same bits.

#ifndef CGAL_BOUNDING_ARCS_2_FILTER_BATCH_FUNCTION_H
#define CGAL_BOUNDING_ARCS_2_FILTER_BATCH_FUNCTION_H

#include <CGAL/Bounding_arcs_2/filter/arc_batch.h>
#include <CGAL/Bounding_arcs_2/filter/bound_batch.h>
#include <CGAL/Bounding_arcs_2/tree/Build_options.h>

#include <cstddef>
#include <cstdint>

namespace CGAL::Bounding_arcs {

namespace filter {

using Bound_function = Batch_bounds (*)(const Local_curve&, double begin, double end, double eps, bool is_long);
using Batch_function = Batch_decision (*)(const Batch_curve&, const Batch_pieces& pieces, double eps, double* upper);

struct Base_set {};
struct Avx2_set {};
struct Avx512_set {};
struct One_by_one {};  ///< no registers: for few pieces

/// bound_batch compiled for one instruction set; defined in src/kernels/batch_kernels.cpp.
template <class Isa, class Method, int DEGREE>
Batch_decision compiled_batch(const Batch_curve& curve, const Batch_pieces& pieces, double eps, double* upper);

using Arc_function = std::uint64_t (*)(const Local_curve&, const Arc_points&, const double* breaks, std::size_t count,
                                       const Arc_places&);
/// arc_batch compiled for one instruction set.
template <class Isa, class Arcs, int DEGREE>
std::uint64_t compiled_arcs(const Local_curve& curve, const Arc_points& points, const double* breaks, std::size_t count,
                            const Arc_places& to);

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

/// The compiled function for a set, or for the widest below it that this machine has; without compiled ones the plain.
/// \tparam Of what has of<Isa>() for each, and plain()
template <class Of> [[nodiscard]] auto function_for([[maybe_unused]] Instruction_set set) {
#ifdef BOUNDING_ARCS_KERNELS
#ifdef __x86_64__
  if (set >= Instruction_set::AVX512 && is_available(Instruction_set::AVX512)) return Of::template of<Avx512_set>();
  if (set >= Instruction_set::AVX2 && is_available(Instruction_set::AVX2)) return Of::template of<Avx2_set>();
#endif
  return Of::template of<Base_set>();
#else
  return Of::plain();
#endif
}

template <class Method, int DEGREE> struct Bounds_of_degree {
  template <class Isa> [[nodiscard]] static Batch_function of() { return &compiled_batch<Isa, Method, DEGREE>; }
  [[nodiscard]] static Batch_function plain() { return &bound_batch<Base_set, Method, DEGREE>; }
};
template <class Arcs, int DEGREE> struct Arcs_of_degree {
  template <class Isa> [[nodiscard]] static Arc_function of() { return &compiled_arcs<Isa, Arcs, DEGREE>; }
  [[nodiscard]] static Arc_function plain() { return &arc_batch<Base_set, Arcs, DEGREE>; }
  [[nodiscard]] static Arc_function of_few() { return &arc_batch<One_by_one, Arcs, DEGREE, 1>; }
};

/// The loops of one method by degree; null where pieces are to be bounded one by one.
class Batch_functions {
 public:
  template <class Method> [[nodiscard]] static Batch_functions of(Instruction_set set) {
    Batch_functions f;
    if (set == Instruction_set::NONE) return f;
    f.function_[3] = function_for<Bounds_of_degree<Method, 3>>(set);
    f.function_[4] = function_for<Bounds_of_degree<Method, 4>>(set);
    f.function_[5] = function_for<Bounds_of_degree<Method, 5>>(set);
    f.of_one_[3] = &bound_one<Method, 3>;
    f.of_one_[4] = &bound_one<Method, 4>;
    f.of_one_[5] = &bound_one<Method, 5>;
    return f;
  }
  [[nodiscard]] Batch_function operator()(const Local_curve& curve) const { return function_[curve.degree]; }
  /// Of single pieces, where a batch would take longer.
  [[nodiscard]] Bound_function of_one(const Local_curve& curve) const { return of_one_[curve.degree]; }

 private:
  Batch_function function_[MAX_LOCAL_DEGREE + 1] = {};
  Bound_function of_one_[MAX_LOCAL_DEGREE + 1] = {};
};

/// The loops that make the arcs of regions, the same bits; null where regions are to be made one by one.
struct Arc_functions {
  Arc_function of_many = nullptr;  ///< in groups of eight
  Arc_function of_few = nullptr;   ///< piece by piece, which is quicker for one or two
};
template <class Arcs> [[nodiscard]] Arc_functions arc_functions(Instruction_set set, const Local_curve& curve) {
  const auto of = [set](auto degree) -> Arc_functions {
    return {function_for<decltype(degree)>(set), degree.of_few()};
  };
  if (set == Instruction_set::NONE) return {};
  switch (curve.degree) {
    case 3:
      return of(Arcs_of_degree<Arcs, 3>());
    case 4:
      return of(Arcs_of_degree<Arcs, 4>());
    case 5:
      return of(Arcs_of_degree<Arcs, 5>());
    default:
      return {};
  }
}

}  // namespace filter
}  // namespace CGAL::Bounding_arcs

#endif
