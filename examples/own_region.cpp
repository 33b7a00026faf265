// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A bounding region of one's own: the triangle of the chord and the tangents at both ends.  Written as formulas of the
// chord frame it becomes traits, and a tree takes it as any other.  A check tells of a boundary that is not there, of
// one that does not hold the curve, and of a thickness that is too small: proofs, not samples.

#include <CGAL/Bounding_arcs_2.h>
#include <CGAL/Bounding_arcs_2/verify/verify_region.h>
#include <CGAL/Simple_cartesian.h>

#include <iostream>

using namespace CGAL::Bounding_arcs;
using Spiral = Bezier_spiral_2<double>;

// A model of Construction; straight pieces step back to bounding circular arcs.
struct Tangent_triangle {
  static constexpr const char* NAME = "triangle";
  static constexpr int ARCS_PER_REGION = 0;
  static constexpr bool NEEDS_CURVATURE = false, NEEDS_CONTROL_POINTS = false, NEEDS_CERTAIN_TURN = true,
                        BOUNDARY_NEEDS_SQUARE_ROOT = false;

  // The distance of the apex from the chord. It is share() of the first tangent away from the start.
  template <class NT> static NT thickness(const Chord_shape_2<NT>& f) {
    if (!f.turns_one_way) return Bca::thickness(f);
    return NT(f.unit * absolute(NT(share(f) * f.cross0)) / square_root(dot(f.chord, f.chord)));
  }
  template <class NT> static Region_outline_2<NT> boundary(const Chord_frame_2<NT>& frame) {
    const Chord_shape_2<NT>& f = frame.shape;
    if (!f.turns_one_way) return outline_of(Bca::boundary(frame), f.turn);
    const auto chord = chain_through<NT>({frame.p0, frame.p1});
    const auto tangents = chain_through<NT>({frame.p0, frame.p0 + NT(f.unit * share(f)) * f.tangent0, frame.p1});
    return f.turn > 0 ? outline_between(chord, tangents, Outline_form::POLYGON, f.turn)
                      : outline_between(tangents, chord, Outline_form::POLYGON, f.turn);
  }
  template <class NT> static NT share(const Chord_shape_2<NT>& f) {
    return NT(f.cross1 / cross(f.tangent0, f.tangent_change));
  }
};
// Two mistakes.
struct Too_thin : Tangent_triangle {
  template <class NT> static NT thickness(const Chord_shape_2<NT>& f) {
    return NT(Tangent_triangle::thickness(f) / NT(2));
  }
};
struct Empty : Tangent_triangle {
  template <class NT> static Region_outline_2<NT> boundary(const Chord_frame_2<NT>&) {
    return {{}, {}, Outline_form::POLYGON};
  }
};

template <class Construction> const char* verdict(const Spiral& s) {
  constexpr double ROUNDING = 1e-12;  // of a thickness in doubles
  if (!verify_region<Construction>(s, s.first(), s.last()).holds()) return "does not hold the curve";
  const double told = Construction::thickness(s.shape<double>(s.first(), s.last()));
  return verify_thickness<Construction>(s, s.first(), s.last(), told * (1 + ROUNDING)) ? "is right" : "is thicker";
}

int main() {
  using Kernel =
      CGAL::Circular_kernel_2<CGAL::Simple_cartesian<double>, CGAL::Algebraic_kernel_for_circles_2_2<double>>;
  const Bounding_arc_tree_2 tree(Bezier_curve_2<double>({{0, 0.6}, {6.4, 3}, {-2.4, 3.4}, {3, 0}}));
  const Region_hierarchy_2<Bounding_region_traits_2<Kernel, Tangent_triangle>> triangles(tree, 1e-3);
  std::cout << triangles.number_of_leaves() << " triangles\n";
  const Spiral& spiral = triangles.spirals().front();
  std::cout << "a triangle " << verdict<Tangent_triangle>(spiral) << "\nhalf as thick it " << verdict<Too_thin>(spiral)
            << "\nnothing " << verdict<Empty>(spiral) << '\n';
}
