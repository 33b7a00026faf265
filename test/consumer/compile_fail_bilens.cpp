// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Must not compile: bilens over a number type without square roots.  The compiler's message is to name the way out:
// "Use a Circular_kernel_2 over a number type with square roots".

#include <CGAL/Algebraic_kernel_for_circles_2_2.h>
#include <CGAL/Bounding_arcs_2/region/Bilens_traits_2.h>
#include <CGAL/Circular_kernel_2.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

int main() {
  using Number_type = CGAL::Exact_rational;
  using Kernel =
      CGAL::Circular_kernel_2<CGAL::Simple_cartesian<Number_type>, CGAL::Algebraic_kernel_for_circles_2_2<Number_type>>;
  const CGAL::Bounding_arcs::Bilens_traits_2<Kernel> traits;
  return traits.construction().NEEDS_CURVATURE ? 0 : 1;
}
