// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the library has compiled of medial axes, in doubles.

#ifndef CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_INTERNAL_COMPILED_AXES_H
#define CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_INTERNAL_COMPILED_AXES_H

#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>
#include <CGAL/Bounding_arcs_2/medial_axis/internal/Axis_job.h>
#include <CGAL/Bounding_arcs_2/tree/Drawing_hierarchy.h>

#include <optional>
#include <vector>

namespace CGAL::Bounding_arcs {

struct Axis_certificate;
struct Axis_conic;
struct Feet_apart;
struct Inscribed_disc;
struct Voronoi_cell;

namespace internal {

[[nodiscard]] Medial_axis_2 medial_axis(const Drawing_hierarchy& curves, const Axis_job& job = {});

[[nodiscard]] std::optional<Clearance_path> clearance_path(const Drawing_hierarchy& curves, const Medial_axis_2& axis,
                                                           const Xy<double>& from, const Xy<double>& to);

[[nodiscard]] Medial_axis_2 trimmed(Medial_axis_2 axis, const Drawing_hierarchy& curves, const Feet_apart& apart);

[[nodiscard]] std::optional<Inscribed_disc> largest_inscribed_disc(const Drawing_hierarchy& curves,
                                                                   const Medial_axis_2& axis);

[[nodiscard]] Axis_certificate axis_certificate(const Drawing_hierarchy& curves, const Medial_axis_2& axis);

[[nodiscard]] std::vector<std::vector<Axis_conic>> axis_conics(const Drawing_hierarchy& curves,
                                                               const Medial_axis_2& axis, double eps);

[[nodiscard]] std::vector<Voronoi_cell> voronoi_cells(const Drawing_hierarchy& curves, const Medial_axis_2& axis);
[[nodiscard]] std::vector<Xy<double>> cell_polygon(const Drawing_hierarchy& curves, const Medial_axis_2& axis,
                                                   const Voronoi_cell& cell, int per_piece);

}  // namespace internal

}  // namespace CGAL::Bounding_arcs

#endif
