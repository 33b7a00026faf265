// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What an axis is made by: options, and how near it is to be.

#ifndef CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_INTERNAL_AXIS_JOB_H
#define CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_INTERNAL_AXIS_JOB_H

#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>

namespace CGAL::Bounding_arcs::internal {

struct Axis_job : Medial_axis_options {
  double eps = 1e-6;  ///< how far the axis, and its radius together, may be from the lines between samples
};
[[nodiscard]] inline Axis_job axis_job(double eps, const Medial_axis_options& options) {
  Axis_job job;
  static_cast<Medial_axis_options&>(job) = options;
  job.eps = eps;
  return job;
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
