// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a shape is thin: stretches of its axis with discs below a limit, without corners, and necks.
//
//     ---------------.                  The axis forks towards the corners of a bar, where radii go to 0. A shape is
//     = = = = = = =<  |                 as thick there as where the fork begins: a corner is no thin place. The taper
//     ---------------'                  of its sides tells it, the angle a: along an axis whose discs touch sides
//                                       with that angle between them radii change by sin(a/2) of the way.
//
// Necks are maximal discs that are smaller than those around them on the axis.
// The discs of an axis are flooded from the smallest one up. A pool begins at each local minimum; where two pools meet,
// the one with the larger minimum ends, and its prominence is by how much the radius has risen (Edelsbrunner, Letscher,
// Zomorodian 2002). Pools that begin at an end of the axis are corners and tips, not necks.

#ifndef CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_THIN_PLACES_H
#define CGAL_BOUNDING_ARCS_2_MEDIAL_AXIS_THIN_PLACES_H

#include <CGAL/Bounding_arcs_2/medial_axis/Medial_axis_2.h>

#include <cstddef>
#include <ostream>
#include <vector>

namespace CGAL::Bounding_arcs {

/// A way along the axis on which a shape, or the room in a frame, is thinner than a limit.
/// \code
/// for (const Medial_axis_2::Thin_stretch& stretch : thin_stretches(axis, 0.5))
///   std::cout << stretch.thickness() << " over a length of " << stretch.length << '\n';
/// \endcode
struct Medial_axis_2::Thin_stretch {
  std::vector<Sample> samples;  ///< one of a shape that is a disc; a way round has its first one again at the end
  std::size_t least = 0;        ///< the sample with the smallest disc
  double length = 0;            ///< of the lines between the samples

  /// The smallest disc, and where it touches both sides.
  [[nodiscard]] const Sample& disc() const { return samples[least]; }
  [[nodiscard]] double thickness() const { return 2 * disc().radius; }

  /// Writes a line for each sample.
  friend std::ostream& operator<<(std::ostream& out, const Thin_stretch& all) {
    for (const Sample& one : all.samples) out << one << '\n';
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
[[nodiscard]] std::vector<Medial_axis_2::Thin_stretch> thin_stretches(const Medial_axis_2& axis, double limit,
                                                                      double corner = THIN_CORNER);

/// A place where a shape, or the room in a frame, is narrower than around it.
/// \code
/// for (const Medial_axis_2::Neck& neck : necks(axis)) std::cout << neck.thickness() << '\n';
/// \endcode
struct Medial_axis_2::Neck {
  Sample disc;           ///< the smallest one, and where it touches both sides
  std::size_t edge = 0;  ///< of the axis
  double prominence =
      0;  ///< the radius rises by that on each way to a narrower place or an end; infinite: none is left

  [[nodiscard]] double thickness() const { return 2 * disc.radius; }

  /// Writes the members in their order, with a blank between.
  friend std::ostream& operator<<(std::ostream& out, const Neck& answer) {
    return out << answer.disc << ' ' << answer.prominence;
  }
};

/// Returns the necks of what an axis is of, the narrowest first.
/// \param least_prominence necks that stand out by no more are left out; at least axis.eps is taken, as samples tell no
///   smaller difference
/// \guarantee the thickness is within 2 axis.eps of the least one there, as good as the axis is; a long neck of one
///   width, or a ring, has one place
/// \complexity n log n in the samples
[[nodiscard]] std::vector<Medial_axis_2::Neck> necks(const Medial_axis_2& axis, double least_prominence = 0);

}  // namespace CGAL::Bounding_arcs

#endif
