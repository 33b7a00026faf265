// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Joins open curves whose ends meet to chains and loops: outlines that are drawn as loose lines and arcs get an inside.
//
//   line1 ------. .-- arc2         ends at most eps apart, and no third one beside them: one place
//               ' '                where more than two meet: those two that go on straight
//                |                   but first of all loops whose curves follow each other, where all ends are in such

#ifndef CGAL_BOUNDING_ARCS_2_CURVE_JOIN_CURVES_H
#define CGAL_BOUNDING_ARCS_2_CURVE_JOIN_CURVES_H

#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>
#include <CGAL/Bounding_arcs_2/number/Xy.h>

#include <cstddef>
#include <vector>

namespace CGAL::Bounding_arcs {

/// A drawing whose open curves are joined, and what was done.
/// \code
/// const Joined_curves joined = join_curves(drawing, 1e-6);
/// std::cout << joined.joints << " joints, ends moved by at most " << joined.moved << '\n';
/// \endcode
struct Joined_curves {
  /// A curve that became a part of a joined one.
  struct Part {
    std::size_t curve;  ///< its number in the drawing that was given
    bool is_reversed;   ///< it runs the other way there
  };

  Drawing_2<double> drawing;             ///< a joined curve stands where the first of its parts did
  std::vector<std::vector<Part>> parts;  ///< of each of its curves, in their order along it
  std::vector<std::size_t> joined;       ///< the numbers of its curves that were joined or closed
  std::size_t joints = 0;                ///< how many pairs of ends became one
  double moved = 0;                      ///< how far an end was moved at most
  std::vector<Xy<double>> crowded;       ///< places where more than two ends were left apart: ambiguous

  /// Returns how far ends of curves may be apart that are the same but for rounding to double: 2^-40 of the largest
  /// coordinate. Ends of arcs come from centers, angles and transforms, each rounded. Ten times less leaves some of
  /// them apart; ten times more is still far below what anything is drawn for.
  [[nodiscard]] static double rounding_of_ends(double largest_coordinate);
};

/// Joins open curves to chains and loops where exactly two ends meet, or two of several go on straight.
///
/// Loops go first whose curves follow each other in the drawing, on one layer, each from the end of the one before it,
/// in either direction, unless one of these goes on straight in another curve: outlines that touch are told apart so.
///
/// Two ends meet if they are at most eps apart. They are joined if no third end meets one of them. Ends that are the
/// same go first, then those that rounding parts (2^-40 of the largest coordinate), then those within eps, then those
/// whose own errors reach farther. What was joined counts no more. A chain whose own two ends meet is closed, whatever
/// else ends there. Where more than two are left then, two are joined that go on straight: within 0.9 degrees, by
/// however much ends were moved, and no third one within 3.6 degrees. Where layers are told, all this is done first
/// with ends of one layer.
///
/// * A joined curve has the name and the direction of the first of its parts; a loop begins with it. Other parts are
///   reversed where they have to be.
/// * Of two ends that differ that of the piece with the lower degree moves: lines stay lines, and arcs stay arcs. For
///   the same degree that of the later curve moves.
/// * Closed curves stay as they are. So do curves that nothing is joined to, B-splines with their knots.
/// * Left apart, too, are the ends of a curve or loop that closing would move into a point, and two curves that lie one
///   upon the other.
/// \code
/// Drawing_2<double> loose;
/// loose.add(Bezier_curve_2<double>({{0, 0}, {4, 0}}), "floor");
/// loose.add(Bezier_curve_2<double>({{0, 1e-9}, {2, 3}}), "left");
/// loose.add(Bezier_curve_2<double>({{2, 3}, {4, 0}}), "right");
/// const Joined_curves joined = join_curves(loose, 1e-6);  // one closed curve, "floor"
/// \endcode
/// \param eps at least 0, in units of the coordinates; with 0 only ends that are the same are joined
/// \param layers a number a curve, or none
/// \param errors by how much farther than others the ends of each curve may be off, at least 0; or none
/// \guarantee pieces share their ends bit for bit. A point of a curve moves by no more than an end of its piece: at
///   most eps and its errors, apart from rounding. No other control point moves, and no weight. The result is the same
///   for curves in another order, but for loops that the order tells, its order, directions and which end is moved
/// \complexity n log n for n curves, unless many ends are within eps of each other
/// \throws std::invalid_argument for an eps or error that is no number or below 0, and for a wrong number of layers or
///   errors
[[nodiscard]] Joined_curves join_curves(const Drawing_2<double>& drawing, double eps,
                                        const std::vector<std::size_t>& layers = {},
                                        const std::vector<double>& errors = {});

}  // namespace CGAL::Bounding_arcs

#endif
