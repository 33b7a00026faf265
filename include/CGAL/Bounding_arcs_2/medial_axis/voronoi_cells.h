// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The Voronoi diagram of curves: which places are nearest to each of them.
//
// The feet of all discs of an axis run once along the boundary of its regions. While they run along one curve, the
// lines from feet to centers sweep the places that are nearest to it there (Alt, Cheong, Vigneron 2005).
//
//     first ----- run of the curve -----> last
//       |                                  |       lines from feet to centers; none where curves meet in a corner
//     center ------- rim, of edges ----> center
//
// Where a disc touches an arc of the boundary, feet run along that while the center stays.

#ifndef CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_VORONOI_CELLS_H
#define CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_VORONOI_CELLS_H

#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Bounding_arcs {

/// Places that are nearest to one curve, between a run of it and edges of the axis. A curve has one for each run on
/// each of its sides.
/// \code
/// for (const Medial_axis_2::Cell& cell : voronoi_cells(closed, axis))
///   for (const Medial_axis_2::Cell::Rim& part : cell.rim)
///     if (part.beyond != cell.curve) std::cout << cell.curve << " is next to " << part.beyond << '\n';
/// \endcode
struct Medial_axis_2::Cell {
  /// A part of an edge of the axis, from sample to sample.
  struct Rim {
    std::size_t edge = 0;
    std::size_t first = 0, last = 0;  ///< samples; the edge is run backwards where the last one is smaller
    std::uint32_t beyond = 0;         ///< the curve on the other side, which may be the same one
  };

  std::uint32_t curve = 0;
  Curve_place first{}, last{};  ///< the run of the curve, with the cell on its left
  bool is_reversed = false;     ///< the run is against the direction of the curve
  bool is_whole = false;        ///< the run goes once round a closed curve, from `first` back to it, or is a point
  std::vector<Rim> rim;         ///< from the disc that touches at `first` to that at `last`
  std::size_t vertex = 0;       ///< where there is no rim: one disc touches all of the run, and this is its vertex

  /// Returns the cell's polygon, counterclockwise, for pictures.
  /// \param per_piece points of each Bezier piece that the run has
  [[nodiscard]] std::vector<Xy<double>> polygon(const Bounding_arc_tree_2& tree, const Medial_axis_2& axis,
                                                int per_piece = 16) const;
};

/// Returns the cells of an axis's regions, by their curves. A cell without a rim is a sector between an arc and its
/// center. A circle has all of its disc; of a disc that several curves enclose each has a sector.
/// \param tree of the curves that the axis is of
/// \pre the axis is complete
/// \guarantee rims are within axis.eps of those of the curves, as good as the axis is; cells share rims, and together
///   they are the regions
/// \complexity n log n in the samples, and the square of the number of edges at each vertex
[[nodiscard]] std::vector<Medial_axis_2::Cell> voronoi_cells(const Bounding_arc_tree_2& tree,
                                                             const Medial_axis_2& axis);

}  // namespace CGAL::Bounding_arcs

#endif
