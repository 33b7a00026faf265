// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of verify/verify_axis.h.

#include <CGAL/Bounding_arcs_2/curve/Unit.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/verify/verify_axis.h>
#include "Axis_checker.h"

#include <stdexcept>

namespace CGAL::Bounding_arcs {

const char* name_of(Axis_verification::Fault fault) {
  switch (fault) {
    case Axis_verification::Fault::FORM:
      return "FORM";
    case Axis_verification::Fault::END:
      return "END";
    case Axis_verification::Fault::EULER:
      return "EULER";
    case Axis_verification::Fault::TOUCH:
      return "TOUCH";
    case Axis_verification::Fault::FOOT:
      return "FOOT";
    case Axis_verification::Fault::TILING:
      return "TILING";
    case Axis_verification::Fault::CELL:
      return "CELL";
    case Axis_verification::Fault::DISC:
      return "DISC";
    case Axis_verification::Fault::BOUND:
      return "BOUND";
  }
  return "";
}

Axis_verification verify_axis(const Drawing_2<double>& curves, const Medial_axis_2& axis,
                              const Axis_verification::Options& options) {
  if (!options.bounds.empty() && options.bounds.size() != axis.edges.size())
    throw std::invalid_argument(
        expected("bounds", "one for each edge, " + text_of(axis.edges.size()), options.bounds.size()));
  const Unit unit = Unit::of_size(coordinate_size(curves));
  if (unit.is_one()) return verify::Axis_checker(curves, axis, options).check();
  Medial_axis_2 scaled_axis = axis;
  Axis_verification::Options scaled_options = options;
  const auto scale = [&](auto& disc) { disc.center = unit.in(disc.center), disc.radius = unit.in(disc.radius); };
  for (Medial_axis_2::Vertex& v : scaled_axis.vertices) scale(v);
  for (Medial_axis_2::Edge& e : scaled_axis.edges)
    for (Medial_axis_2::Sample& s : e.samples) scale(s);
  for (double& b : scaled_options.bounds) b = unit.in(b);
  scaled_axis.eps = unit.in(axis.eps), scaled_axis.error = unit.in(axis.error);
  scaled_axis.moved = unit.in(axis.moved);
  const Drawing_2<double> scaled_curves = internal::scaled(curves, unit);
  Axis_verification result = verify::Axis_checker(scaled_curves, scaled_axis, scaled_options).check();
  for (double* length : {&result.miss, &result.aside, &result.gap, &result.deviation}) *length = unit.out(*length);
  for (Axis_verification::Finding& f : result.findings) f.amount = unit.out(f.amount);
  return result;
}

}  // namespace CGAL::Bounding_arcs
