// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Offsets of few pieces: neighbours on one circle or line are put together, and short pieces are left out.
//
// Both replace pieces by an arc between the same two points. Its points are no farther than some way from those that
// were there, so that the error of an offset grows by that. What was left of eps is not exceeded.

#ifndef BOUNDING_ARCS_FEW_PIECES_H
#define BOUNDING_ARCS_FEW_PIECES_H

#include <CGAL/Bounding_arcs_2/offset/Offset_2.h>

namespace CGAL::Bounding_arcs {

/// Lets neighbours on one circle or line be one piece, of at most half a circle: a whole circle is two. They are of one
/// curve and one kind, and no other piece ends between them; a line and what leads it on in a miter or a square cap are
/// one, too.
/// \param room what rounding may move points by; pieces that are within 64 times that of one circle are on it
/// \return how far points were moved at most
/// \complexity linear in the pieces, but n log n for n pieces that become fewer
[[nodiscard]] double put_together(Offset& offset, double most, double room);

/// Leaves out pieces that are shorter than eps / 16, and less beside thin chains: a neighbour is led on instead, where
/// that moves no point by more than `most` and nothing crosses.
/// \return how far points were moved at most
[[nodiscard]] double leave_out_short(Offset& offset, double eps, double most, double room);

/// Does both, and adds what points were moved by to the error.
void make_few(Offset& offset, double eps, double room);

}  // namespace CGAL::Bounding_arcs

#endif
