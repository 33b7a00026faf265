// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A region's boundary as Circular_arc_2 and Line_arc_2 of a circular kernel.

#ifndef CGAL_BOUNDING_ARCS_2_REGION_KERNEL_BOUNDARY_H
#define CGAL_BOUNDING_ARCS_2_REGION_KERNEL_BOUNDARY_H

#include <CGAL/Bounding_arcs_2/region/Contact_circle_2.h>
#include <CGAL/Bounding_arcs_2/region/internal/Rounded_arc_2.h>

#include <CGAL/enum.h>

#include <type_traits>
#include <variant>
#include <vector>

namespace CGAL::Bounding_arcs {

/// A tangent segment whose end points are algebraic and whose supporting line is not rational, so that a rational
/// kernel has no Line_arc_2 for it.
template <class CircularKernel> struct Algebraic_segment_2 {
  typename CircularKernel::Circular_arc_point_2 source, target;
};

/// One boundary piece in the kernel's types. Circular_arc_2 always runs counterclockwise; `reversed` is true when the
/// boundary runs through it from target to source.
/// Over floating numbers an arc's circle does not pass through its source and target, and an arc too flat for a circle
/// in these numbers is a Line_arc_2: `deviation` tells what either makes out.
template <class CircularKernel> struct Kernel_piece_2 {
  std::variant<typename CircularKernel::Circular_arc_2, typename CircularKernel::Line_arc_2,
               Algebraic_segment_2<CircularKernel>>
      curve;
  bool reversed = false;
  /// An upper bound of the Hausdorff distance between `curve`, a Line_arc_2 taken for the segment from its source to
  /// its target, and the piece of the Region_boundary_2 that it stands for. It is 0 over exact number types. Over
  /// floating ones it is some ulp of the coordinates, but it grows with the radius r, like u r, up to about sqrt(u)
  /// times the chord (2^-26 of it over double). Flatter arcs are segments, and nearer again.
  double deviation = 0;
};

/// A region's boundary in pieces of the kernel, from the start of the curve piece to its end.
template <class CircularKernel> struct Kernel_boundary_2 { std::vector<Kernel_piece_2<CircularKernel>> inner, outer; };

/// A point as the kernel has it.
template <class CK, class FT> [[nodiscard]] typename CK::Point_2 kernel_point(const Xy<FT>& p) {
  return typename CK::Point_2(p.x, p.y);
}

/// A circle as the kernel has it. \pre not a line
template <class CK, class FT>
[[nodiscard]] typename CK::Circle_2 kernel_circle(const Contact_circle_2<FT>& c,
                                                  CGAL::Orientation orientation = CGAL::COUNTERCLOCKWISE) {
  return typename CK::Circle_2(kernel_point<CK>(c.center()), c.squared_radius(), orientation);
}

/// The arc of a circle from source to target in the direction given, as the kernel's counterclockwise arc.
template <class CK>
[[nodiscard]] Kernel_piece_2<CK> kernel_arc(const typename CK::Circle_2& circle,
                                            const typename CK::Circular_arc_point_2& source,
                                            const typename CK::Circular_arc_point_2& target, bool ccw) {
  using Arc = typename CK::Circular_arc_2;
  return ccw ? Kernel_piece_2<CK>{Arc(circle, source, target), false}
             : Kernel_piece_2<CK>{Arc(circle, target, source), true};
}

/// A piece of a boundary as the kernel has it, with its deviation.
template <class CK, class FT> [[nodiscard]] Kernel_piece_2<CK> kernel_piece(const Boundary_piece_2<FT>& p) {
  using Arc_point = typename CK::Circular_arc_point_2;
  const auto from = kernel_point<CK>(p.from), to = kernel_point<CK>(p.to);
  const auto segment = [&](double deviation) {
    return Kernel_piece_2<CK>{typename CK::Line_arc_2(from, to), false, deviation};
  };
  if constexpr (std::is_floating_point_v<FT>) {
    const Rounded_arc_2<FT> r = rounded_arc(p);
    if (r.is_segment) return segment(r.deviation);
    auto piece = kernel_arc<CK>(typename CK::Circle_2(kernel_point<CK>(r.center), r.squared_radius), Arc_point(from),
                                Arc_point(to), p.is_ccw());
    piece.deviation = r.deviation;
    return piece;
  } else if (p.is_segment()) {
    return segment(0);
  } else {
    return kernel_arc<CK>(kernel_circle<CK>(p.support), Arc_point(from), Arc_point(to), p.is_ccw());
  }
}

/// A chain, a range of Boundary_piece_2, in pieces of the kernel.
template <class CK, class Chain> [[nodiscard]] std::vector<Kernel_piece_2<CK>> kernel_chain(const Chain& chain) {
  std::vector<Kernel_piece_2<CK>> pieces;
  for (const auto& p : chain) pieces.push_back(kernel_piece<CK>(p));
  return pieces;
}

}  // namespace CGAL::Bounding_arcs

#endif
