// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The batch loops for one instruction set: compiled once for each, with BOUNDING_ARCS_ISA naming its tag.  What is
// inlined into them is always_inline, so that no other code picks up instructions of a wider set.

#include <CGAL/Bounding_arcs_2/filter/Batch_function.h>
#include <CGAL/Bounding_arcs_2/filter/Bca_batch.h>
#include <CGAL/Bounding_arcs_2/filter/Bilens_batch.h>
#include <CGAL/Bounding_arcs_2/filter/Spiral_fat_arc_batch.h>
#include <CGAL/Bounding_arcs_2/internal/approximation/Arc_columns.h>

namespace CGAL::Bounding_arcs::filter {

template <class Isa, class Method, int DEGREE>
Batch_decision compiled_batch(const Batch_curve& curve, const Batch_pieces& pieces, double eps, double* upper) {
  return bound_batch<Isa, Method, DEGREE>(curve, pieces, eps, upper);
}

template <class Isa, class Arcs, int DEGREE>
std::uint64_t compiled_arcs(const Local_curve& curve, const Arc_points& points, const double* breaks, std::size_t count,
                            const Arc_places& to) {
  return arc_batch<Isa, Arcs, DEGREE>(curve, points, breaks, count, to);
}

template std::uint64_t compiled_arcs<BOUNDING_ARCS_ISA, Bca_arcs, 3>(const Local_curve&, const Arc_points&,
                                                                     const double*, std::size_t, const Arc_places&);
template Batch_decision compiled_batch<BOUNDING_ARCS_ISA, Bca_batch, 3>(const Batch_curve&, const Batch_pieces&, double,
                                                                        double*);
template std::uint64_t compiled_arcs<BOUNDING_ARCS_ISA, Bca_arcs, 4>(const Local_curve&, const Arc_points&,
                                                                     const double*, std::size_t, const Arc_places&);
template Batch_decision compiled_batch<BOUNDING_ARCS_ISA, Bca_batch, 4>(const Batch_curve&, const Batch_pieces&, double,
                                                                        double*);
template std::uint64_t compiled_arcs<BOUNDING_ARCS_ISA, Bca_arcs, 5>(const Local_curve&, const Arc_points&,
                                                                     const double*, std::size_t, const Arc_places&);
template Batch_decision compiled_batch<BOUNDING_ARCS_ISA, Bca_batch, 5>(const Batch_curve&, const Batch_pieces&, double,
                                                                        double*);
template std::uint64_t compiled_arcs<BOUNDING_ARCS_ISA, Spiral_fat_arc_arcs, 3>(const Local_curve&, const Arc_points&,
                                                                                const double*, std::size_t,
                                                                                const Arc_places&);
template Batch_decision compiled_batch<BOUNDING_ARCS_ISA, Spiral_fat_arc_batch, 3>(const Batch_curve&,
                                                                                   const Batch_pieces&, double,
                                                                                   double*);
template std::uint64_t compiled_arcs<BOUNDING_ARCS_ISA, Spiral_fat_arc_arcs, 4>(const Local_curve&, const Arc_points&,
                                                                                const double*, std::size_t,
                                                                                const Arc_places&);
template Batch_decision compiled_batch<BOUNDING_ARCS_ISA, Spiral_fat_arc_batch, 4>(const Batch_curve&,
                                                                                   const Batch_pieces&, double,
                                                                                   double*);
template std::uint64_t compiled_arcs<BOUNDING_ARCS_ISA, Spiral_fat_arc_arcs, 5>(const Local_curve&, const Arc_points&,
                                                                                const double*, std::size_t,
                                                                                const Arc_places&);
template Batch_decision compiled_batch<BOUNDING_ARCS_ISA, Spiral_fat_arc_batch, 5>(const Batch_curve&,
                                                                                   const Batch_pieces&, double,
                                                                                   double*);
template std::uint64_t compiled_arcs<BOUNDING_ARCS_ISA, Bilens_arcs, 3>(const Local_curve&, const Arc_points&,
                                                                        const double*, std::size_t, const Arc_places&);
template Batch_decision compiled_batch<BOUNDING_ARCS_ISA, Bilens_batch, 3>(const Batch_curve&, const Batch_pieces&,
                                                                           double, double*);
template std::uint64_t compiled_arcs<BOUNDING_ARCS_ISA, Bilens_arcs, 4>(const Local_curve&, const Arc_points&,
                                                                        const double*, std::size_t, const Arc_places&);
template Batch_decision compiled_batch<BOUNDING_ARCS_ISA, Bilens_batch, 4>(const Batch_curve&, const Batch_pieces&,
                                                                           double, double*);
template std::uint64_t compiled_arcs<BOUNDING_ARCS_ISA, Bilens_arcs, 5>(const Local_curve&, const Arc_points&,
                                                                        const double*, std::size_t, const Arc_places&);
template Batch_decision compiled_batch<BOUNDING_ARCS_ISA, Bilens_batch, 5>(const Batch_curve&, const Batch_pieces&,
                                                                           double, double*);

}  // namespace CGAL::Bounding_arcs::filter

namespace CGAL::Bounding_arcs::internal {

template <class Isa> void compiled_biarcs(Arc_columns& columns) { fit_biarcs<Isa>(columns); }
template <class Isa> void compiled_balanced(Arc_columns& columns) { fit_balanced<Isa>(columns); }

template void compiled_biarcs<filter::BOUNDING_ARCS_ISA>(Arc_columns&);
template void compiled_balanced<filter::BOUNDING_ARCS_ISA>(Arc_columns&);

}  // namespace CGAL::Bounding_arcs::internal
