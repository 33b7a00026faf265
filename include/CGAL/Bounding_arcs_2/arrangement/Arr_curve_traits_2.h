// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// CGAL's arrangements of Bezier pieces.

#ifndef CGAL_BOUNDING_ARCS_2_ARRANGEMENT_ARR_CURVE_TRAITS_2_H
#define CGAL_BOUNDING_ARCS_2_ARRANGEMENT_ARR_CURVE_TRAITS_2_H

#include <CGAL/Bounding_arcs_2/arrangement/Arr_curve_2.h>
#include <CGAL/Bounding_arcs_2/arrangement/internal/arr_predicates.h>
#include <CGAL/Bounding_arcs_2/region/variant.h>  // value_as, for what CGAL hands out

#include <CGAL/Arr_enums.h>
#include <CGAL/Arr_tags.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/enum.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <memory>
#include <utility>

namespace CGAL::Bounding_arcs {

/// The traits class that makes CGAL::Arrangement_2 run on Bezier and NURBS curves, polynomial or rational, of any
/// degree.
/// \code
/// using Traits = Arr_curve_traits_2;
/// CGAL::Arrangement_2<Traits> arrangement;
/// const auto curves = arr_curves(read_drawing("drawing.svg"));
/// CGAL::insert(arrangement, curves.begin(), curves.end());
/// std::cout << arrangement.number_of_faces() << " faces\n";
/// \endcode
/// It is a model of ArrangementTraits_2 and ArrangementDirectionalXMonotoneTraits_2. So overlays, zones, point
/// location, vertical decomposition and envelopes run on it, and General_polygon_set_2 does by Gps_traits_2.
///
/// arr_curves() makes curves of a drawing, Arr_curve_2(bezier) makes one of a Bezier curve, and Arr_point_2(x, y) makes
/// a point. An edge knows its curve, its Bezier piece and brackets of its parameters. Curves are cut where x turns;
/// such vertices have two edges.
///
/// Functors share what they find out about pairs of curves, and copies of the traits share it with each other. Points
/// and curves remember what they lie on. So threads must not share traits, points or curves.
///
/// Take these traits where you need an algorithm of CGAL's. An Overlay_2 has faces and their areas sooner, and an
/// Outline_2 has unions and differences.
/// \guarantee exact: doubles with bounds decide most, algebraic numbers of the curves whose control points are the
///   doubles given what is left
class Arr_curve_traits_2 {
 public:
  using Point_2 = Arr_point_2;
  using Curve_2 = Arr_curve_2;
  using X_monotone_curve_2 = Arr_curve_2::Part;
  using Multiplicity = unsigned int;

  using Has_left_category = Tag_true;
  using Has_merge_category = Tag_true;
  using Has_do_intersect_category = Tag_false;
  using Left_side_category = Arr_oblivious_side_tag;
  using Bottom_side_category = Arr_oblivious_side_tag;
  using Top_side_category = Arr_oblivious_side_tag;
  using Right_side_category = Arr_oblivious_side_tag;

  /// Compares points by x.
  struct Compare_x_2 {
    [[nodiscard]] Comparison_result operator()(const Point_2& p, const Point_2& q) const {
      return internal::compare_x(p, q);
    }
  };
  /// Compares points by x, then by y.
  struct Compare_xy_2 {
    [[nodiscard]] Comparison_result operator()(const Point_2& p, const Point_2& q) const {
      return internal::compare_xy(p, q);
    }
  };
  /// Gives the left end.
  struct Construct_min_vertex_2 {
    [[nodiscard]] const Point_2& operator()(const X_monotone_curve_2& c) const { return c.left(); }
  };
  /// Gives the right end.
  struct Construct_max_vertex_2 {
    [[nodiscard]] const Point_2& operator()(const X_monotone_curve_2& c) const { return c.right(); }
  };
  /// Tells whether a part is upright.
  struct Is_vertical_2 {
    [[nodiscard]] bool operator()(const X_monotone_curve_2& c) const { return c.is_vertical(); }
  };

  /// A functor that looks at pairs of curves.
  class Functor_of_pairs {
   public:
    explicit Functor_of_pairs(std::shared_ptr<internal::Meetings_of_pairs> meetings) : meetings_(std::move(meetings)) {}

   protected:
    [[nodiscard]] internal::Meetings_of_pairs& meetings() const { return *meetings_; }

   private:
    std::shared_ptr<internal::Meetings_of_pairs> meetings_;
  };

  /// Tells whether a point is above a part.
  struct Compare_y_at_x_2 {
    /// \pre x of p is in the range of the curve
    [[nodiscard]] Comparison_result operator()(const Point_2& p, const X_monotone_curve_2& c) const {
      return internal::compare_y_at_x(p, c);
    }
  };
  /// Compares two parts right before a common point.
  struct Compare_y_at_x_left_2 : Functor_of_pairs {
    using Functor_of_pairs::Functor_of_pairs;
    /// \pre both curves come to p from its left
    [[nodiscard]] Comparison_result operator()(const X_monotone_curve_2& c, const X_monotone_curve_2& d,
                                               const Point_2& p) const {
      return internal::compare_y_beside(c, d, p, false, meetings());
    }
  };
  /// Compares two parts right behind a common point.
  struct Compare_y_at_x_right_2 : Functor_of_pairs {
    using Functor_of_pairs::Functor_of_pairs;
    /// \pre both curves go on to the right of p
    [[nodiscard]] Comparison_result operator()(const X_monotone_curve_2& c, const X_monotone_curve_2& d,
                                               const Point_2& p) const {
      return internal::compare_y_beside(c, d, p, true, meetings());
    }
  };
  /// Tells whether points are one, or parts run through the same points.
  struct Equal_2 : Functor_of_pairs {
    using Functor_of_pairs::Functor_of_pairs;
    [[nodiscard]] bool operator()(const Point_2& p, const Point_2& q) const {
      return internal::compare_xy(p, q) == EQUAL;
    }
    [[nodiscard]] bool operator()(const X_monotone_curve_2& c, const X_monotone_curve_2& d) const {
      if (!(*this)(c.left(), d.left()) || !(*this)(c.right(), d.right())) return false;
      const auto common = internal::common_parts(c, d, meetings());
      return common.size() == 1 && common.front().part && (*this)(common.front().part->left(), c.left()) &&
             (*this)(common.front().part->right(), c.right());
    }
  };

  /// Cuts a piece where x turns.
  struct Make_x_monotone_2 {
    /// \param out takes Point_2 or X_monotone_curve_2, in a variant; along the piece
    template <class OutputIterator> OutputIterator operator()(const Curve_2& curve, OutputIterator out) const {
      using Result = Variant<Point_2, X_monotone_curve_2>;
      const auto parts = internal::x_monotone_parts(curve);
      if (parts.empty()) *out++ = internal::as_result<Result>(Point_2(curve.data()->start()));
      for (const X_monotone_curve_2& part : parts) *out++ = internal::as_result<Result>(part);
      return out;
    }
  };
  /// Cuts a part at a point.
  struct Split_2 {
    /// \pre p is on the curve, and no end of it
    void operator()(const X_monotone_curve_2& c, const Point_2& p, X_monotone_curve_2& left,
                    X_monotone_curve_2& right) const {
      const Arr_curve_2::Part::End at{p, internal::parameter_at(c, p)};
      const X_monotone_curve_2 whole = c;
      left = whole.part(whole.left_end(), at);
      right = whole.part(at, whole.right_end());
    }
  };
  /// Finds what two parts have in common.
  struct Intersect_2 : Functor_of_pairs {
    using Functor_of_pairs::Functor_of_pairs;
    /// \param out takes std::pair<Point_2, Multiplicity> or X_monotone_curve_2, in a variant, from left to right; a
    ///   multiplicity of 0 is not known
    template <class OutputIterator>
    OutputIterator operator()(const X_monotone_curve_2& c, const X_monotone_curve_2& d, OutputIterator out) const {
      using Point = std::pair<Point_2, Multiplicity>;
      using Result = Variant<Point, X_monotone_curve_2>;
      for (const internal::Arr_common_part& common : internal::common_parts(c, d, meetings())) {
        if (!common.part) *out++ = internal::as_result<Result>(Point(common.point, common.multiplicity));
        else if (c.is_directed_right() == d.is_directed_right() || common.part->is_directed_right())
          *out++ = internal::as_result<Result>(*common.part);
        else *out++ = internal::as_result<Result>(common.part->opposite());
      }
      return out;
    }
  };
  /// Tells whether two parts make one.
  struct Are_mergeable_2 {
    /// Parts of one piece that follow each other are.
    [[nodiscard]] bool operator()(const X_monotone_curve_2& c, const X_monotone_curve_2& d) const {
      if (c.data() != d.data() || c.branch() != d.branch() || c.is_directed_right() != d.is_directed_right())
        return false;
      return internal::compare_xy(c.right(), d.left()) == EQUAL || internal::compare_xy(d.right(), c.left()) == EQUAL;
    }
  };
  /// Makes one of two parts.
  struct Merge_2 {
    /// \pre they are mergeable
    void operator()(const X_monotone_curve_2& c, const X_monotone_curve_2& d, X_monotone_curve_2& whole) const {
      const bool is_first = internal::compare_xy(c.right(), d.left()) == EQUAL;
      const X_monotone_curve_2 left = is_first ? c : d, right = is_first ? d : c;
      whole = left.part(left.left_end(), right.right_end());
    }
  };

  /// Tells the direction of a part.
  struct Compare_endpoints_xy_2 {
    [[nodiscard]] Comparison_result operator()(const X_monotone_curve_2& c) const {
      return c.is_directed_right() ? SMALLER : LARGER;
    }
  };
  /// Turns a part round.
  struct Construct_opposite_2 {
    [[nodiscard]] X_monotone_curve_2 operator()(const X_monotone_curve_2& c) const { return c.opposite(); }
  };

  using Approximate_number_type = double;
  using Approximate_kernel = Simple_cartesian<double>;
  using Approximate_point_2 = Approximate_kernel::Point_2;
  /// Gives doubles: of a point, and of a polyline along a part.
  struct Approximate_2 {
    /// \param i 0 for x, 1 for y
    [[nodiscard]] double operator()(const Point_2& p, int i) const { return (i == 0 ? p.x() : p.y()).middle(); }
    [[nodiscard]] Approximate_point_2 operator()(const Point_2& p) const { return {(*this)(p, 0), (*this)(p, 1)}; }
    /// \param out takes the vertices of a polyline within `error` of the curve, of at most 10^6 legs; its ends are
    ///   those of the part, as above
    /// \pre error > 0
    template <class OutputIterator>
    OutputIterator operator()(const X_monotone_curve_2& c, double error, OutputIterator out,
                              bool is_from_left = true) const {
      auto points = internal::approximate_polyline(c, error);
      if (!is_from_left) std::reverse(points.begin(), points.end());
      for (const Xy<double>& p : points) *out++ = Approximate_point_2(p.x, p.y);
      return out;
    }
  };

  [[nodiscard]] Compare_x_2 compare_x_2_object() const { return {}; }
  [[nodiscard]] Compare_xy_2 compare_xy_2_object() const { return {}; }
  [[nodiscard]] Construct_min_vertex_2 construct_min_vertex_2_object() const { return {}; }
  [[nodiscard]] Construct_max_vertex_2 construct_max_vertex_2_object() const { return {}; }
  [[nodiscard]] Is_vertical_2 is_vertical_2_object() const { return {}; }
  [[nodiscard]] Compare_y_at_x_2 compare_y_at_x_2_object() const { return {}; }
  [[nodiscard]] Compare_y_at_x_left_2 compare_y_at_x_left_2_object() const { return Compare_y_at_x_left_2(meetings_); }
  [[nodiscard]] Compare_y_at_x_right_2 compare_y_at_x_right_2_object() const {
    return Compare_y_at_x_right_2(meetings_);
  }
  [[nodiscard]] Equal_2 equal_2_object() const { return Equal_2(meetings_); }
  [[nodiscard]] Make_x_monotone_2 make_x_monotone_2_object() const { return {}; }
  [[nodiscard]] Split_2 split_2_object() const { return {}; }
  [[nodiscard]] Intersect_2 intersect_2_object() const { return Intersect_2(meetings_); }
  [[nodiscard]] Are_mergeable_2 are_mergeable_2_object() const { return {}; }
  [[nodiscard]] Merge_2 merge_2_object() const { return {}; }
  [[nodiscard]] Compare_endpoints_xy_2 compare_endpoints_xy_2_object() const { return {}; }
  [[nodiscard]] Construct_opposite_2 construct_opposite_2_object() const { return {}; }
  [[nodiscard]] Approximate_2 approximate_2_object() const { return {}; }

 private:
  std::shared_ptr<internal::Meetings_of_pairs> meetings_ = std::make_shared<internal::Meetings_of_pairs>();
};

}  // namespace CGAL::Bounding_arcs

#endif
