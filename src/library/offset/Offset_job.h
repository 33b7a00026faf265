// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What an offset is made by: options, and how near it is to be.

#ifndef BOUNDING_ARCS_LIBRARY_OFFSET_OFFSET_JOB_H
#define BOUNDING_ARCS_LIBRARY_OFFSET_OFFSET_JOB_H

#include <CGAL/Bounding_arcs_2/offset/Offset_2.h>

namespace CGAL::Bounding_arcs::internal {

/// The options of an offset, and how near it is to be.
struct Offset_job : Offset_options {
  double eps = 1e-6;        ///< how far a point's distance may be from |d|, in units of the coordinates, positive
  bool drops_open = false;  ///< leaves out open curves and points
};
/// Returns options with how near an offset is to be.
[[nodiscard]] inline Offset_job offset_job(double eps, const Offset_options& options) {
  Offset_job job;
  static_cast<Offset_options&>(job) = options;
  job.eps = eps;
  return job;
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
