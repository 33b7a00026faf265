// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The areas of faces of arrangements.

#ifndef CGAL_BOUNDING_ARCS_2_ARRANGEMENT_FACE_AREA_H
#define CGAL_BOUNDING_ARCS_2_ARRANGEMENT_FACE_AREA_H

#include <CGAL/Arr_enums.h>
#include <CGAL/Bounding_arcs_2/arrangement/internal/arr_predicates.h>
#include <CGAL/Bounding_arcs_2/number/Bracket.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>

#include <stdexcept>
#include <vector>

namespace CGAL::Bounding_arcs {

/// Returns the area of a face of an arrangement over Arr_curve_traits_2, without what lies in its holes.
/// \code
/// for (auto face = arrangement.faces_begin(); face != arrangement.faces_end(); ++face)
///   if (!face->is_unbounded()) std::cout << face_area(face, 1e-9).lower << '\n';
/// \endcode
/// \param face a handle of a face, bounded
/// \param eps how far the bounds may be apart; they are farther where doubles tell no more of rational curves
/// \guarantee certified; for polynomial curves the nearest doubles, but for what parameters of vertices leave open
/// \complexity some tens of microseconds an edge
/// \throws std::invalid_argument if the face is unbounded, or eps below 0
template <class Face_handle> [[nodiscard]] Measure_bounds face_area(Face_handle face, double eps) {
  if (face->is_unbounded()) throw std::invalid_argument(expected("face", "a bounded face", "the unbounded one"));
  std::vector<std::vector<internal::Boundary_part>> boundaries;
  const auto add = [&](auto first) {
    boundaries.emplace_back();
    auto edge = first;
    do {
      const auto& part = edge->curve();
      const bool is_to_right = edge->direction() == CGAL::ARR_LEFT_TO_RIGHT;
      const Bracket &left = part.left_parameter(), &right = part.right_parameter();
      boundaries.back().push_back({&part.data()->bezier(), is_to_right ? left : right, is_to_right ? right : left});
    } while (++edge != first);
  };
  for (auto outer = face->outer_ccbs_begin(); outer != face->outer_ccbs_end(); ++outer) add(*outer);
  for (auto inner = face->inner_ccbs_begin(); inner != face->inner_ccbs_end(); ++inner) add(*inner);
  return internal::boundary_area(boundaries, eps);
}

}  // namespace CGAL::Bounding_arcs

#endif
