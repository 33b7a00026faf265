// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A curve type of one's own: a clothoid, the curve of railways, by its jets. At the length s its tangent angle is
// s^2 / 2 and its curvature s, so that [0, 1.5] is one spiral segment that starts with an inflection.

#include <CGAL/Bounding_arcs_2.h>

#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <cstdio>

using namespace CGAL::Bounding_arcs;
using Kernel = CGAL::Circular_kernel_2<CGAL::Simple_cartesian<double>, CGAL::Algebraic_kernel_for_circles_2_2<double>>;

// A model of BoundableCurve_2. The coordinates are the integrals of cos(s^2 / 2) and sin(s^2 / 2), term by term.
struct Clothoid {
  [[nodiscard]] End_jet_2<double> jet(double s) const {
    constexpr int TERMS = 24;  // the last one is below 1e-20 for s up to 1.5
    const double angle = s * s / 2;
    Xy<double> point;
    double term = s;
    for (int n = 0; n < TERMS; ++n) {
      (n % 2 == 0 ? point.x : point.y) += (n % 4 < 2 ? term : -term) / (2 * n + 1);
      term *= angle / (n + 1);
    }
    const double c = std::cos(angle), d = std::sin(angle);
    return {point, {c, d}, {-s * d, s * c}};
  }
};

template <class Traits> void report(double eps) {
  constexpr double RELATIVE_ERROR = 1e-15;
  const Jet_spiral_2<Clothoid> spiral(Clothoid(), 0, 1.5, RELATIVE_ERROR);
  const Region_hierarchy_2<Traits, Jet_spiral_2<Clothoid>> regions({spiral}, eps);
  std::printf("%-6s %g: %zu regions%s\n", Traits::Construction::NAME, eps, regions.number_of_leaves(),
              regions.status() == Build_status::COMPLETE ? "" : ", eps not reached");
}

int main() {
  for (const double eps : {1e-3, 1e-6, 1e-9}) {
    report<Bca_traits_2<Kernel>>(eps);
    report<Spiral_fat_arc_traits_2<Kernel>>(eps);
    report<Bilens_traits_2<Kernel>>(eps);
  }
  const Region_hierarchy_2<Bca_traits_2<Kernel>, Jet_spiral_2<Clothoid>> regions({{Clothoid(), 0, 1.5, 1e-15}}, 1e-3);
  const auto found = closest_point(regions, {1, 0}, 1e-9);
  std::printf("(1, 0) is %.6f from the point at the length %.4f\n", found->distance.upper, found->t);
  std::printf("%zu arcs follow the curve within 1e-6\n", arc_chain(regions, 1e-6).arcs.size());
}
