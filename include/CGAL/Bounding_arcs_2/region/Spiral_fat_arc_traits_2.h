// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Spiral fat arcs as CGAL traits; over kernels without square roots the joints are Circular_arc_point_2.

#ifndef CGAL_BOUNDING_ARCS_2_REGION_SPIRAL_FAT_ARC_TRAITS_2_H
#define CGAL_BOUNDING_ARCS_2_REGION_SPIRAL_FAT_ARC_TRAITS_2_H

#include <CGAL/Bounding_arcs_2/frame/Chord_frame_2.h>
#include <CGAL/Bounding_arcs_2/number/Root_number.h>
#include <CGAL/Bounding_arcs_2/region/Bounding_region_traits_2.h>
#include <CGAL/Bounding_arcs_2/region/Kernel_boundary.h>
#include <CGAL/Bounding_arcs_2/region/Spiral_fat_arc.h>
#include <CGAL/Bounding_arcs_2/region/variant.h>

#include <CGAL/Circular_kernel_intersections.h>

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

// Spiral fat arcs over a rational kernel: the circles are rational, the corner i and the touching point j are
// algebraic points of degree two, found as line-circle intersections; j lies on the rational polar line of the flat
// end.

namespace CGAL::Bounding_arcs::internal {

// Intersections of the circular kernel, in whichever variant the CGAL version at hand returns them.

/// The points a line and a circle share, in lexicographic order; none, one or two.
template <class CK>
[[nodiscard]] std::vector<typename CK::Circular_arc_point_2> intersection_points(const typename CK::Line_2& line,
                                                                                 const typename CK::Circle_2& circle) {
  using Point = std::pair<typename CK::Circular_arc_point_2, unsigned>;
  using Line_2 = typename CK::Line_2;
  using Circle_2 = typename CK::Circle_2;
  std::vector<typename CGAL::CK2_Intersection_traits<CK, Line_2, Circle_2>::type> found;
  CK().intersect_2_object()(line, circle, std::back_inserter(found));
  std::vector<typename CK::Circular_arc_point_2> points;
  for (const auto& object : found)
    if (const Point* p = get_if<Point>(object)) points.push_back(p->first);
  return points;
}

/// The osculating circle at an end, free of square roots: normal perp(T) |T|^2, curvature 2 k / unit.
template <class FT>
[[nodiscard]] Contact_circle_2<FT> osculating_circle(const Chord_frame_2<FT>& frame, bool at_start) {
  const Chord_shape_2<FT>& f = frame.shape;
  const Xy<FT>& t = at_start ? f.tangent0 : f.tangent1;
  return {at_start ? frame.p0 : frame.p1, FT(dot(t, t) * f.unit) * perp(t),
          FT(FT(2) * (at_start ? f.curvature0 : f.curvature1))};
}

// The intersection of a line with a circle that is farther along `direction`, of two.
template <class CK, class FT>
[[nodiscard]] typename CK::Circular_arc_point_2 farther_intersection(const Xy<FT>& point, const Xy<FT>& direction,
                                                                     const typename CK::Circle_2& circle) {
  const typename CK::Line_2 line(kernel_point<CK>(point), typename CK::Vector_2(direction.x, direction.y));
  auto points = intersection_points<CK>(line, circle);  // two for a strict spiral, by the nesting of its circles
  const bool rising = direction.x > FT(0) || (direction.x == FT(0) && direction.y > FT(0));
  const auto less = [](const auto& p, const auto& q) { return CK().compare_xy_2_object()(p, q) == CGAL::SMALLER; };
  std::sort(points.begin(), points.end(), less);
  return rising ? points.back() : points.front();
}

// The inner chain: the tight end's circle to j, then the segment to the flat end.
// The polar line of the flat end q is (x - z)(q - z) = r^2, and j is its intersection on the right of z -> q where the
// tight circle is run through counterclockwise from the tight end.
template <class CK, class FT>
[[nodiscard]] std::vector<Kernel_piece_2<CK>> algebraic_inner_chain(const Chord_frame_2<FT>& frame) {
  using Arc_point = typename CK::Circular_arc_point_2;
  const bool first = frame.shape.tight_first, ccw = frame.shape.turn > 0;
  const auto p0 = kernel_point<CK>(frame.p0), p1 = kernel_point<CK>(frame.p1);
  if (first ? frame.shape.infinite0 : frame.shape.infinite1) return {{typename CK::Line_arc_2(p0, p1), false}};
  const Contact_circle_2<FT> osculating = osculating_circle(frame, first);
  const Xy<FT> z = osculating.center(), to_flat = (first ? frame.p1 : frame.p0) - z;
  const Xy<FT> foot = z + FT(osculating.squared_radius() / dot(to_flat, to_flat)) * to_flat;
  const auto circle = kernel_circle<CK>(osculating);
  const Arc_point j = farther_intersection<CK>(foot, FT(ccw == first ? -1 : 1) * perp(to_flat), circle);
  if (first) return {kernel_arc<CK>(circle, Arc_point(p0), j, ccw), {Algebraic_segment_2<CK>{j, Arc_point(p1)}, false}};
  return {{Algebraic_segment_2<CK>{Arc_point(p0), j}, false}, kernel_arc<CK>(circle, j, Arc_point(p1), ccw)};
}

// The outer chain: the tight end's tangent to i, then the flat end's osculating circle or, for curvature 0, line.
template <class CK, class FT>
[[nodiscard]] std::vector<Kernel_piece_2<CK>> algebraic_outer_chain(const Chord_frame_2<FT>& frame) {
  using Arc_point = typename CK::Circular_arc_point_2;
  using Line_arc = typename CK::Line_arc_2;
  const Chord_shape_2<FT>& f = frame.shape;
  const bool first = f.tight_first, ccw = f.turn > 0;
  const auto p0 = kernel_point<CK>(frame.p0), p1 = kernel_point<CK>(frame.p1);
  const Xy<FT>&tight = first ? frame.p0 : frame.p1, &flat = first ? frame.p1 : frame.p0;
  const Xy<FT> along = first ? f.tangent0 : -f.tangent1;
  const Contact_circle_2<FT> osculating = osculating_circle(frame, !first);
  if (osculating.is_line()) {  // two segments, and the corner is rational
    const Xy<FT> direction = first ? f.tangent1 : f.tangent0;
    const FT s = cross(Xy<FT>(flat - tight), direction) / cross(along, direction);
    const auto corner = kernel_point<CK>(Xy<FT>(tight + s * along));
    return {{Line_arc(p0, corner), false}, {Line_arc(corner, p1), false}};
  }
  const auto circle = kernel_circle<CK>(osculating);
  const typename CK::Line_2 tangent(kernel_point<CK>(tight), typename CK::Vector_2(along.x, along.y));
  const Arc_point i = farther_intersection<CK>(tight, along, circle);
  if (first) return {{Line_arc(tangent, Arc_point(p0), i), false}, kernel_arc<CK>(circle, i, Arc_point(p1), ccw)};
  return {kernel_arc<CK>(circle, Arc_point(p0), i, ccw), {Line_arc(tangent, i, Arc_point(p1)), false}};
}

/// \pre the frame is a strict spiral (shape.proper)
/// \source Barton and Elber 2011; j by pole and polar instead of two distances and a projection
template <class CK, class FT>
[[nodiscard]] Kernel_boundary_2<CK> algebraic_spiral_fat_arc(const Chord_frame_2<FT>& frame) {
  return {algebraic_inner_chain<CK>(frame), algebraic_outer_chain<CK>(frame)};
}

}  // namespace CGAL::Bounding_arcs::internal

namespace CGAL::Bounding_arcs {

namespace internal {
/// The construction with its boundary over rational kernels, which needs the circular kernel's intersections.
template <class Construction> struct With_algebraic_boundary : Construction {
  With_algebraic_boundary(const Construction& c = {}) : Construction(c) {}  // NOLINT: the same construction
  template <class CK, class FT>
  [[nodiscard]] Kernel_boundary_2<CK> algebraic_boundary(const Chord_frame_2<FT>& frame) const {
    // the form is the one that the construction takes where there are square roots
    const Chord_frame_2<Root_number> root_frame{{}, {}, frame.shape.template over<Root_number>()};
    if (Construction::boundary(root_frame).form == Region_form::SPIRAL_FAT_ARC)
      return algebraic_spiral_fat_arc<CK>(frame);
    const Region_boundary_2<FT> b = Bca::boundary(frame);
    return {internal::kernel_chain<CK>(b.inner), internal::kernel_chain<CK>(b.outer)};
  }
};
}  // namespace internal

/// Spiral fat arcs: regions between an arc with a segment and another segment with an arc. Over kernels without square
/// roots joints are Circular_arc_point_2.
/// \tparam Construction Spiral_fat_arc, or Near_circular_to_bca<Spiral_fat_arc>
/// \code
/// using Linear = CGAL::Simple_cartesian<double>;
/// using Kernel = CGAL::Circular_kernel_2<Linear, CGAL::Algebraic_kernel_for_circles_2_2<double>>;
/// const Region_hierarchy_2<Spiral_fat_arc_traits_2<Kernel>> regions(tree, 1e-6);
/// std::cout << regions.number_of_leaves() << " regions\n";
/// \endcode
/// \cgalModels{BoundingRegionTraits_2}
template <class CircularKernel, class Construction = Spiral_fat_arc>
class Spiral_fat_arc_traits_2
    : public Bounding_region_traits_2<CircularKernel, internal::With_algebraic_boundary<Construction>> {
 public:
  using Bounding_region_traits_2<CircularKernel,
                                 internal::With_algebraic_boundary<Construction>>::Bounding_region_traits_2;
};

namespace internal {
/// Compiled in the library.
extern template Thickness_bound bound_exactly(const Spiral_fat_arc&, const Chord_shape_2<Exact_rational>&, double);
/// Compiled in the library.
extern template Thickness_bound bound_exactly(const With_algebraic_boundary<Spiral_fat_arc>&,
                                              const Chord_shape_2<Exact_rational>&, double);
}  // namespace internal

}  // namespace CGAL::Bounding_arcs

#endif
