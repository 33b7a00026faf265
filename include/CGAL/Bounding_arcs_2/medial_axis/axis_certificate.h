// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A proof of a medial axis: that no branch is missing, and how far each edge may be from the true axis.

#ifndef CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_AXIS_CERTIFICATE_H
#define CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_AXIS_CERTIFICATE_H

#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>

#include <cstdint>
#include <vector>

namespace CGAL::Bounding_arcs {

/// What is proven of an axis.
/// \code
/// const Medial_axis_2::Certificate proof = axis_certificate(closed, axis);
/// if (proof.is_proven()) std::cout << "within " << proof.bound << '\n';
/// \endcode
struct Medial_axis_2::Certificate {
  /// Whether an edge's bound is proven.
  enum class Status : std::uint8_t { PROVEN, ESTIMATED };

  /// Why an edge is not proven.
  enum class Reason : std::uint8_t {
    NONE,       ///< it is
    FEET,       ///< two feet that follow each other are on no common spiral segment
    CELL,       ///< what is between two samples and their feet is turned inside out
    BAND,       ///< the bound is above the tolerance
    ELSEWHERE,  ///< another edge has no bound, or feet do not tile the boundary
  };

  /// How far an edge is from the true axis.
  struct Edge {
    Status status = Status::ESTIMATED;
    Reason reason = Reason::NONE;
    /// Centers and radii together: each disc of the true axis there has its center within a, and its radius within b,
    /// of a place of the edge, and a + b is at most that. Infinite where there is no bound.
    double bound = 0;
  };

  bool is_tiled = false;    ///< feet tile each side of a curve that they are on once, and all curves
  bool is_euler = false;    ///< vertices less edges are regions less holes
  double bound = 0;         ///< the largest of the edges
  std::vector<Edge> edges;  ///< as the axis has them

  [[nodiscard]] bool is_proven() const;
  /// Returns the reason's name in capitals.
  [[nodiscard]] static const char* name_of(Reason reason);
};

/// Proves an axis of closed curves, or of curves in a frame: that of the drawing within axis.moved that it is of. Which
/// parts of curves bound regions the overlay has decided.
///
/// Between two samples each foot runs along a spiral segment. Feet, centers and the boundary between make two cells;
/// their boundaries cancel but for the curves, so that cells in order are all that is inside. A disc of the true axis
/// touches some cell's part of the boundary. It ends at most as far beyond the line between the centers as the band
/// about the bisector of both fat arcs does; and no more before it, as what is there belongs to no other cell.
/// \param axis not pruned nor trimmed; its places are of the tree's curves
/// \guarantee the geometry is proven (doc/medial_axis.md), in doubles with bounds of their errors; margins for cells
///   thinner than 2^-40 of the size are not derived for each rounding. In tests a bound is at most twice the distance
///   that there is, or 2^-40 of the size
/// \complexity linear in the samples
[[nodiscard]] Medial_axis_2::Certificate axis_certificate(const Bounding_arc_tree_2& tree, const Medial_axis_2& axis);

}  // namespace CGAL::Bounding_arcs

#endif
