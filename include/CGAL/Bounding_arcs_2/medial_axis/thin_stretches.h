// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a shape is thinner than a limit: the stretches of its axis with discs that are too small, without corners.
//
//     ---------------.                  The axis forks towards the corners of a bar, where radii go to 0. A shape is
//     = = = = = = =<  |                 as thick there as where the fork begins: a corner is no thin place. The taper
//     ---------------'                  of its sides tells it, the angle a: along an axis whose discs touch sides
//                                       with that angle between them radii change by sin(a/2) of the way.

#ifndef CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_THIN_STRETCHES_H
#define CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_THIN_STRETCHES_H

#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>

#include <cstddef>
#include <ostream>
#include <vector>

namespace CGAL::Bounding_arcs {

/// A way along the axis on which a shape, or the room in a frame, is thinner than a limit.
/// \code
/// for (const Thin_stretch& stretch : thin_stretches(axis, 0.5))
///   std::cout << stretch.thickness() << " over a length of " << stretch.length << '\n';
/// \endcode
struct Thin_stretch {
  std::vector<Medial_sample>
      samples;            ///< one of a shape that is a disc; a way round has its first one again at the end
  std::size_t least = 0;  ///< the sample with the smallest disc
  double length = 0;      ///< of the lines between the samples

  /// The smallest disc, and where it touches both sides.
  [[nodiscard]] const Medial_sample& disc() const { return samples[least]; }
  [[nodiscard]] double thickness() const { return 2 * disc().radius; }

  /// Writes a line for each sample.
  friend std::ostream& operator<<(std::ostream& out, const Thin_stretch& all) {
    for (const Medial_sample& one : all.samples) out << one << '\n';
    return out;
  }
};

/// A corner or wedge of a smaller angle is a thin place, in radians: 60 degrees.
constexpr double THIN_CORNER = 1.0471975511965976;

/// Returns all stretches of an axis whose discs have a diameter below a limit, the thinnest first. A stretch ends where
/// the limit is reached, where the axis branches, or where it ends.
///
/// What runs into a corner is left out: from each end of the axis the steps along which sides have an angle of `corner`
/// or more between them, within 2^-20. So is what is left then, where the axis branches, and so on. The largest disc
/// stays of an axis that is all corners, as that of a square is.
/// \param limit above 0, in units of the coordinates; infinity: all stretches
/// \param corner in radians, above 0 and at most pi
/// \return ends of a stretch may be between two samples of the axis; their feet are about there
/// \guarantee all discs of a stretch are below the limit, by more than 2^-40 of the largest coordinate. No others
///   outside of corners are below it by more than 2 axis.eps, as good as the axis is
/// \throws std::invalid_argument for a limit or a corner that is not as said
/// \complexity n log n in the samples
[[nodiscard]] std::vector<Thin_stretch> thin_stretches(const Medial_axis_2& axis, double limit,
                                                       double corner = THIN_CORNER);

}  // namespace CGAL::Bounding_arcs

#endif
