// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A curve type of one's own: the involute of the unit circle, the curve of gear teeth, by its jets.
// Its curvature is 1 / t and its tangent angle t, so [0.5, 1.5] is one spiral segment.

#include <CGAL/Bounding_arcs_2.h>

#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <cstdio>

using namespace CGAL::Bounding_arcs;
using Kernel = CGAL::Circular_kernel_2<CGAL::Simple_cartesian<double>, CGAL::Algebraic_kernel_for_circles_2_2<double>>;

// A model of BoundableCurve_2. Derivatives may be by any parameter; those by arc length have no coordinate that
// cancels.
struct Involute {
  [[nodiscard]] End_jet_2<double> jet(double t) const {
    const double c = std::cos(t), s = std::sin(t);
    return {{c + t * s, s - t * c}, {c, s}, {-s / t, c / t}};
  }
};

template <class Traits> void report(double eps) {
  constexpr double RELATIVE_ERROR = 1e-14;  // s - t c loses a factor of about ten at t = 0.5
  const Jet_spiral_2<Involute> spiral(Involute(), 0.5, 1.5, RELATIVE_ERROR);
  const Bounding_arc_tree_2<Traits, Jet_spiral_2<Involute>> tree({spiral}, eps);
  std::printf("%-6s %g: %zu regions%s\n", Traits::Construction::NAME, eps, tree.number_of_leaves(),
              tree.status() == Build_status::COMPLETE ? "" : ", eps not reached");
}

int main() {
  for (const double eps : {1e-3, 1e-6, 1e-9}) {
    report<Bca_traits_2<Kernel>>(eps);
    report<Spiral_fat_arc_traits_2<Kernel>>(eps);
    report<Bilens_traits_2<Kernel>>(eps);
  }
}
