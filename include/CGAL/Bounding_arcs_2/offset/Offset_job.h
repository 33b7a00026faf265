// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What an offset is made by: options, and how near it is to be.

#ifndef CGAL_BOUNDING_ARCS_2_OFFSET_OFFSET_JOB_H
#define CGAL_BOUNDING_ARCS_2_OFFSET_OFFSET_JOB_H

#include <CGAL/Bounding_arcs_2/offset/Offset_2.h>

namespace CGAL::Bounding_arcs {

/// The options of an offset, and how near it is to be.
struct Offset_job : Offset_options {
  double eps = 1e-6;    ///< how far a point's distance may be from |d|, in units of the coordinates, positive
  double rounding = 0;  ///< how far the curves are from the ones meant, which counts into the error
};
/// \param rounding of the curves
[[nodiscard]] inline Offset_job offset_job(double eps, const Offset_options& options, double rounding = 0) {
  Offset_job job;
  static_cast<Offset_options&>(job) = options;
  job.eps = eps;
  job.rounding = rounding;
  return job;
}

}  // namespace CGAL::Bounding_arcs

#endif
