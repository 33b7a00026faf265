// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A region's boundary of floating numbers over another number type, seen from its start: what proofs about rounded
// regions compare curve pieces with.

#ifndef CGAL_BOUNDING_ARCS_2_VERIFY_INTERNAL_SEEN_BOUNDARY_H
#define CGAL_BOUNDING_ARCS_2_VERIFY_INTERNAL_SEEN_BOUNDARY_H

#include <CGAL/Bounding_arcs_2/number/stable_norm.h>
#include <CGAL/Bounding_arcs_2/region/Contact_circle_2.h>
#include <CGAL/Bounding_arcs_2/verify/internal/Farthest_beyond.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Bounding_arcs::verify {

/// One side of a region, as its circles are seen from the piece's start.
template <class NT> struct Seen_chain {
  std::vector<Seen_circle<NT>> circles;  ///< with normals to the inside of the region, of length about 1
  Xy<NT> joint;                          ///< where there are two
  int side = 1;                          ///< +1 where these are left normals

  /// The way of the piece's points from p along the i-th circle's tangent there, past the normal at p; times weight.
  /// \param allowance a length to be added to the way
  [[nodiscard]] Bernstein_polynomial<NT> past_normal(const Weighted_piece<NT>& piece, std::size_t i, const Xy<NT>& p,
                                                     double allowance = 0) const {
    const Xy<NT> n = circles[i].normal_at(p), along = NT(-side) * perp(n);
    return piece.linear(along, NT(NT(allowance * length_range(n).lower) - dot(along, p)));
  }
};

/// The circles of a boundary, taken as they stand: they need not pass through joints and ends, nor touch each other.
template <class NT> struct Seen_boundary {
  double unit;    ///< of lengths, a power of two
  Xy<NT> origin;  ///< the boundary's start in the plane
  Xy<NT> end;     ///< the boundary's end
  Seen_chain<NT> outer, inner;
  bool has_corner;  ///< the outer joint is a corner and not smooth
  bool is_disc;     ///< both chains are arcs of one circle, which they run along in opposite senses

  template <class FT>
  Seen_boundary(const Region_boundary_2<FT>& boundary, double length_unit)
      : unit(length_unit), origin(number_from<NT>(boundary.inner[0].from)),
        end(seen(boundary.inner[boundary.inner.size() - 1].to)),
        has_corner(boundary.form == Region_form::SPIRAL_FAT_ARC), is_disc(encloses_disc(boundary)) {
    const int turn = turn_of(boundary);
    outer = seen(boundary.outer, turn);
    inner = seen(boundary.inner, -turn);
  }

  /// Some circle has no normal: the region is a point.
  [[nodiscard]] bool is_point() const {
    for (const Seen_chain<NT>* chain : {&outer, &inner})
      for (const Seen_circle<NT>& c : chain->circles)
        if (!(c.length.lower > 0)) return true;
    return false;
  }

 private:
  template <class FT> [[nodiscard]] Xy<NT> seen(const Xy<FT>& p) const {
    return NT(1 / unit) * (number_from<NT>(p) - origin);
  }

  template <class FT> [[nodiscard]] Seen_chain<NT> seen(const Boundary_chain_2<FT>& chain, int side) const {
    Seen_chain<NT> r;
    r.side = side;
    for (const Boundary_piece_2<FT>& p : chain) {
      const auto size = static_cast<double>((std::max)(std::fabs(p.support.normal.x), std::fabs(p.support.normal.y)));
      const double factor = size > 0 ? std::ldexp(side, -std::clamp(std::ilogb(size), -1000, 1000)) : side;
      const Xy<NT> normal = NT(factor) * number_from<NT>(p.support.normal);
      const NT k = p.is_segment()
                       ? NT(0)
                       : NT(NT(unit * factor) * number_from<NT>(p.support.curvature));  // no tiny number on the way
      r.circles.push_back({{seen(p.support.point), normal, k}, length_range(normal)});
    }
    if (chain.size() == 2) r.joint = seen(chain[0].to);
    return r;
  }

  template <class FT> [[nodiscard]] static bool encloses_disc(const Region_boundary_2<FT>& boundary) {
    const Contact_circle_2<FT>&a = boundary.inner[0].support, &b = boundary.outer[0].support;
    return boundary.inner.size() == 1 && boundary.outer.size() == 1 && !a.is_line() && a.point == b.point &&
           a.normal == -b.normal && a.curvature == -b.curvature;
  }

  // +1 for a left turn: the sign of the largest curvature, which is the tight end's.
  template <class FT> [[nodiscard]] static int turn_of(const Region_boundary_2<FT>& boundary) {
    FT largest(0);
    for (const auto* chain : {&boundary.outer, &boundary.inner})
      for (const auto& p : *chain) {
        const FT k = p.support.curvature / stable_norm(p.support.normal);
        if (std::fabs(k) > std::fabs(largest)) largest = k;
      }
    return largest < 0 ? -1 : +1;
  }
};

}  // namespace CGAL::Bounding_arcs::verify

#endif
