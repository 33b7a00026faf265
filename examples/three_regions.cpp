// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The three regions of C(t) = (t, t^2), 0 <= t <= 1, over a field with square roots: every number is exact.

#include <CGAL/Bounding_arcs_2.h>

#include <CGAL/CORE_Expr.h>
#include <CGAL/Simple_cartesian.h>

#include <cstdio>

using namespace CGAL::Bounding_arcs;
using Expr = CORE::Expr;
using Kernel = CGAL::Circular_kernel_2<CGAL::Simple_cartesian<Expr>, CGAL::Algebraic_kernel_for_circles_2_2<Expr>>;

void print(const char* side, const Boundary_chain_2<Expr>& chain) {
  for (const Boundary_piece_2<Expr>& piece : chain) {
    std::printf("  %s ", side);
    if (piece.is_segment()) {
      std::printf("segment");
    } else {
      const Xy<Expr> center = piece.support.center();
      std::printf("arc, center (%.6f, %.6f), squared radius %.6f", center.x.doubleValue(), center.y.doubleValue(),
                  piece.support.squared_radius().doubleValue());
    }
    std::printf(" to (%.6f, %.6f)\n", piece.to.x.doubleValue(), piece.to.y.doubleValue());
  }
}

template <class Traits> void show(const Chord_frame_2<Expr>& frame, const Expr& thickness) {
  const Traits traits;
  const auto region = traits.construct_bounding_region_2_object()(frame);
  const Expr found = traits.compute_thickness_2_object()(region);
  std::printf("%s: thickness %.9f, %s\n", Traits::Construction::NAME, found.doubleValue(),
              found == thickness ? "equal to the closed form" : "WRONG");
  const auto boundary = traits.construct_region_boundary_2_object()(region);
  print("inner", boundary.inner);
  print("outer", boundary.outer);
}

int main() {
  const Bezier_curve_2<Expr> parabola({{Expr(0), Expr(0)}, {Expr(1) / 2, Expr(0)}, {Expr(1), Expr(1)}});
  const Chord_frame_2<Expr> frame = spiral_segments(parabola).front().frame(0, 1);
  show<Bca_traits_2<Kernel>>(frame, 1 + sqrt(Expr(2)) - sqrt(Expr(5)));

  const Expr corner = sqrt(Expr(19)) - 4, half = Expr(1) / 2;
  show<Spiral_fat_arc_traits_2<Kernel>>(frame, sqrt(corner * corner + half * half) - half);

  // outer radius plus center distance less inner radius, of the two circles that are not osculating
  const Expr root = sqrt(Expr(5)), outer = 3 * (5 * root + 7) / 76, inner = (3 * root + 5) / 4;
  const Expr x = (1 + root) / 2, y = (7 + root) / 4 - outer;
  show<Bilens_traits_2<Kernel>>(frame, outer + sqrt(x * x + y * y) - inner);
}
