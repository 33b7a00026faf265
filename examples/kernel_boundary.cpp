// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Boundaries as Circular_arc_2 and Line_arc_2 of a rational kernel: what other CGAL packages take.
// Circular_arc_2 always runs counterclockwise; `reversed` tells when the boundary runs through it backwards.

#include <CGAL/Bounding_arcs_2.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <iostream>
#include <variant>

using namespace CGAL::Bounding_arcs;
using FT = CGAL::Exact_rational;
using Kernel = CGAL::Circular_kernel_2<CGAL::Simple_cartesian<FT>, CGAL::Algebraic_kernel_for_circles_2_2<FT>>;

void print(const Kernel_piece_2<Kernel>& piece) {
  if (const auto* arc = std::get_if<Kernel::Circular_arc_2>(&piece.curve))
    std::cout << "  arc, center " << arc->supporting_circle().center() << ", squared radius "
              << arc->supporting_circle().squared_radius()
              << (piece.reversed ? ", clockwise\n" : ", counterclockwise\n");
  else if (std::holds_alternative<Kernel::Line_arc_2>(piece.curve)) std::cout << "  segment on a rational line\n";
  else std::cout << "  tangent segment between algebraic points; its line is not rational\n";
}

template <class Traits> void show(const Chord_frame_2<FT>& frame) {
  const Traits traits;
  const auto boundary = traits.construct_boundary_2_object()(traits.construct_bounding_region_2_object()(frame));
  std::cout << Traits::Construction::NAME << ", inner:\n";
  for (const auto& piece : boundary.inner) print(piece);
  std::cout << Traits::Construction::NAME << ", outer:\n";
  for (const auto& piece : boundary.outer) print(piece);
}

int main() {
  // (t, -t^2) turns right: clockwise arcs
  const Bezier_curve_2<FT> parabola({{FT(0), FT(0)}, {FT(1) / FT(2), FT(0)}, {FT(1), FT(-1)}});
  const Chord_frame_2<FT> frame = spiral_segments(parabola).front().frame(0, 1);
  show<Bca_traits_2<Kernel>>(frame);
  show<Spiral_fat_arc_traits_2<Kernel>>(frame);
}
