// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A check of a medial axis from its samples and the curves alone. It shares no code but that of units with what makes
// axes, and with the proof of their edges (medial_axis/axis_certificate.h).

#ifndef CGAL_BOUNDING_ARCS_2_VERIFY_VERIFY_AXIS_H
#define CGAL_BOUNDING_ARCS_2_VERIFY_VERIFY_AXIS_H

#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>
#include <CGAL/Bounding_arcs_2/curve/Fill_rule.h>
#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL::Bounding_arcs {

/// What a check of an axis has found.
struct Axis_verification {
  /// What is wrong with an axis.
  enum class Fault : std::uint8_t {
    FORM,    ///< a number is not finite, a place is on no curve, or an edge has fewer than two samples
    END,     ///< an edge's end is not the disc, or does not touch the places, of its vertex
    EULER,   ///< vertices less edges, or parts that hang together, are not what regions and holes say
    TOUCH,   ///< a vertex is not as far from a place that it touches as its radius
    FOOT,    ///< a sample is not as far from a foot as its radius, or not on the normal there
    TILING,  ///< feet leave a part of the boundary out, or cover it twice, or two discs have no common foot
    CELL,    ///< what is between two samples and their feet is turned inside out
    DISC,    ///< a curve is in a disc
    BOUND    ///< the axis is farther from the line between two samples than told
  };

  /// One thing that is wrong with an axis.
  struct Finding {
    Fault fault;
    std::string place;  ///< as "edge 3, sample 17"
    double amount = 0;  ///< by how much, in units of the coordinates; 0 where it is no length
  };

  /// How an axis is checked.
  struct Options {
    Fill_rule rule = Fill_rule::NONZERO;  ///< which points are inside
    bool is_framed = false;               ///< the last curve is a frame
    std::vector<double> bounds;           ///< of each edge, what it tells of its distance from the axis; empty: eps
  };

  std::size_t vertices = 0, edges = 0, samples = 0;
  std::size_t tiles = 0;          ///< parts of the boundary, each with the line between two samples that is its own
  std::size_t discs = 0;          ///< that were searched for curves
  double miss = 0;                ///< the largest difference of a radius and the distance of a foot
  double aside = 0;               ///< the largest distance of a center from the normal in a foot
  double gap = 0;                 ///< the largest gap between feet that follow each other
  double deviation = 0;           ///< the largest distance that was measured between the axis and its lines
  std::size_t faults = 0;         ///< how many
  std::vector<Finding> findings;  ///< the first 100 of them

  [[nodiscard]] bool is_right() const { return faults == 0; }
  /// Returns the fault's name in capitals.
  [[nodiscard]] static const char* name_of(Fault fault);
};

/// Checks an axis of closed curves that do not cross, or of all curves in a frame.
///
/// Between two samples are their lines to the feet on one side, a part of the boundary and the line between the
/// centers. These are cells. Lines to feet are sides of two cells each, and lines between centers, too: so the sum of
/// all cells' boundaries is the boundary of the regions. Where none is turned inside out each point inside is in one
/// cell alone. Then no branch is missing, and no disc is too much.
/// \param axis with feet in all samples
/// \guarantee tiles, common feet and Euler's relation are exact; feet, normals and cells are told in intervals, within
///   2^-40 of the size and what the axis tells as moved, which counts up to as much. In a tip parts of both sides may
///   have no tile where they are that near to each other, which 8 places for each degree tell. Discs of samples, and of
///   one place between any two, are searched for curves within 1/32 of eps; there the distance from the line is
///   measured, which is no proof. Where walls in a frame run along each other within that, tiles are on either of them,
///   but for 2^-8 of the size on one alone
/// \complexity linear in the samples, times log n and some microseconds
[[nodiscard]] Axis_verification verify_axis(const Drawing_2<double>& curves, const Medial_axis_2& axis,
                                            const Axis_verification::Options& options = {});

}  // namespace CGAL::Bounding_arcs

#endif
