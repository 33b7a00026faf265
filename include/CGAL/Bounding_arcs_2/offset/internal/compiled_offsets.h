// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Offsets that the library has compiled, of drawings in doubles.

#ifndef CGAL_BOUNDING_ARCS_2_OFFSET_INTERNAL_COMPILED_OFFSETS_H
#define CGAL_BOUNDING_ARCS_2_OFFSET_INTERNAL_COMPILED_OFFSETS_H

#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>
#include <CGAL/Bounding_arcs_2/offset/Offset_2.h>
#include <CGAL/Bounding_arcs_2/offset/Offset_job.h>

#include <vector>

namespace CGAL::Bounding_arcs {

struct Offset_bracket;
struct Offset_twice;

namespace internal {

[[nodiscard]] Offset_bracket offset_bracket(const Drawing_2<double>& drawing, double d, Offset_job job = {});
[[nodiscard]] std::vector<Offset> insets(const Drawing_2<double>& drawing, double step, const Offset_job& job = {});
[[nodiscard]] Offset_twice offset_twice(const Drawing_2<double>& drawing, double first, double second,
                                        Offset_job job = {});
[[nodiscard]] Offset opening(const Drawing_2<double>& drawing, double radius, const Offset_job& job = {});
[[nodiscard]] Offset closing(const Drawing_2<double>& drawing, double radius, const Offset_job& job = {});

}  // namespace internal

}  // namespace CGAL::Bounding_arcs

#endif
