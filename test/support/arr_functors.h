// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Functors of the traits for CGAL's arrangements on random curves, each against the same in 100 digits.

#ifndef BOUNDING_ARCS_TEST_ARR_FUNCTORS_H
#define BOUNDING_ARCS_TEST_ARR_FUNCTORS_H

#include "Sturm.h"
#include "closed_drawings.h"
#include "many_digits.h"

#include <CGAL/Bounding_arcs_2/arrangement/Arr_curve_traits_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <random>
#include <sstream>
#include <utility>
#include <vector>

namespace bounding_arcs_test::arr_curve_traits {

namespace ba = CGAL::Bounding_arcs;
using Traits = ba::Arr_curve_traits_2;
using Point = Traits::Point_2;
using Part = Traits::X_monotone_curve_2;
using Bezier = ba::Bezier_curve_2<double>;

inline std::vector<Part> parts_of(const Traits& traits, const std::vector<ba::Arr_curve_2>& curves) {
  using Result = ba::Variant<Point, Part>;
  std::vector<Part> parts;
  for (const ba::Arr_curve_2& c : curves) {
    std::vector<Result> found;
    traits.make_x_monotone_2_object()(c, std::back_inserter(found));
    for (const Result& r : found)
      if (const Part* part = ba::get_if<Part>(r)) parts.push_back(*part);
  }
  return parts;
}

struct Common {
  std::vector<Point> points;
  std::vector<Part> parts;
};
inline Common common_of(const Traits& traits, const Part& c, const Part& d) {
  using Result = ba::Variant<std::pair<Point, unsigned>, Part>;
  std::vector<Result> found;
  traits.intersect_2_object()(c, d, std::back_inserter(found));
  Common common;
  for (const Result& r : found) {
    if (const Part* part = ba::get_if<Part>(r)) common.parts.push_back(*part);
    else common.points.push_back(ba::get_if<std::pair<Point, unsigned>>(r)->first);
  }
  return common;
}

// What is nearer than this is equal: where curves touch, points come in half of the digits.
inline CGAL::Comparison_result compare(const Many_digits& a, const Many_digits& b, const Many_digits& least = 1e-35) {
  const Many_digits way = a - b;
  return way > least ? CGAL::LARGER : (way < -least ? CGAL::SMALLER : CGAL::EQUAL);
}

// Where digits cannot tell whether two numbers are equal, because one may come from a tangency, both answers are right.
inline void expect_compared(CGAL::Comparison_result found, const Many_digits& a, const Many_digits& b) {
  const auto sure = compare(a, b);
  ASSERT_TRUE(found == sure || (sure == CGAL::EQUAL && found == compare(a, b, Many_digits("1e-48"))))
      << found << " of a difference of " << a - b;
}

inline double distance(const Digits_point& p, const Traits::Approximate_point_2& a,
                       const Traits::Approximate_point_2& b) {
  const double x = static_cast<double>(p.x) - a.x(), y = static_cast<double>(p.y) - a.y(), dx = b.x() - a.x(),
               dy = b.y() - a.y(), square = dx * dx + dy * dy,
               s = square == 0 ? 0 : std::min(1.0, std::max(0.0, (x * dx + y * dy) / square));
  return std::hypot(x - s * dx, y - s * dy);
}

// Curves that share ends, halves, points and tangents with each other.
inline std::vector<ba::Arr_curve_2> random_curves(std::mt19937& random) {
  const Lattice_drawing first = random_lattice_drawing(random, 3);
  std::vector<ba::Arr_curve_2> curves = ba::arr_curves(first);
  const auto more = ba::arr_curves(random() % 2 == 0 ? related_drawing(first, random, 3, random() % 4 == 0)
                                                     : random_lattice_drawing(random, 3));
  curves.insert(curves.end(), more.begin(), more.end());
  return curves;
}

class Functors {
 public:
  explicit Functors(std::mt19937& random) : curves_(random_curves(random)), parts_(parts_of(traits_, curves_)) {
    for (const Part& c : parts_) {
      add(c.left());
      add(c.right());
      for (const Part& d : parts_) {
        if (&d == &c) continue;
        for (const Point& p : common_of(traits_, c, d).points) add(p);
      }
    }
    for (int i = 0; i < 3; ++i) add(Point(static_cast<int>(random() % 7) - 3, static_cast<int>(random() % 7) - 3));
  }

  mutable std::size_t compared = 0, cut = 0;  ///< how often functors were tried

  // A piece has a part more than the exact numerator of x' has changes of sign, and parts meet where these are.
  void expect_parts_of_pieces() const {
    for (const ba::Arr_curve_2& curve : curves_) {
      const auto slopes = numerators(curve.bezier());
      const bool is_vertical = slopes[0].empty();
      const Powers& full = is_vertical ? slopes[1] : slopes[0];
      const auto parts = bounding_arcs_test::arr_curve_traits::parts_of(traits_, {curve});
      ++compared;
      if (full.empty()) {  // a point
        ASSERT_TRUE(parts.empty());
        continue;
      }
      const Powers p = without_end_roots(full);
      ASSERT_EQ(static_cast<int>(parts.size()), 1 + sign_changes(p, Sturm(p), 0, 1))
          << end_of(curve, 0) << " to " << end_of(curve, 1);
      ASSERT_TRUE(traits_.equal_2_object()(parts.front().source(), end_of(curve, 0)));
      ASSERT_TRUE(traits_.equal_2_object()(parts.back().target(), end_of(curve, 1)));
      for (std::size_t i = 0; i < parts.size(); ++i) {
        ASSERT_EQ(traits_.is_vertical_2_object()(parts[i]), is_vertical);
        if (i == 0) continue;
        const auto& last = parts[i - 1];
        ASSERT_TRUE(traits_.equal_2_object()(last.target(), parts[i].source()));
        const ba::Bracket t = last.is_directed_right() ? last.right_parameter() : last.left_parameter();
        if (t.is_single()) {
          ASSERT_EQ(value(full, Rational(t.lower)), 0) << end_of(curve, 0) << " to " << end_of(curve, 1);
        } else {
          ASSERT_EQ(CGAL::sign(value(full, Rational(t.lower))), -CGAL::sign(value(full, Rational(t.upper))));
        }
      }
    }
  }
  void expect_directions() const {
    for (const Part& c : parts_) {
      const auto left = digits_point(traits_.construct_min_vertex_2_object()(c)),
                 right = digits_point(traits_.construct_max_vertex_2_object()(c));
      const auto x = compare(left.x, right.x);
      ASSERT_EQ(x != CGAL::EQUAL ? x : compare(left.y, right.y), CGAL::SMALLER) << c;
      const Part other = traits_.construct_opposite_2_object()(c);
      const Many_digits low = (std::min)(c.left_parameter().lower, c.right_parameter().lower),
                        high = (std::max)(c.left_parameter().lower, c.right_parameter().lower);
      const auto start = digits_jet(c.data()->bezier(), (3 * low + high) / 4).point,
                 end = digits_jet(c.data()->bezier(), (low + 3 * high) / 4).point;
      const auto along = c.is_vertical() ? compare(start.y, end.y, Many_digits("1e-85"))
                                         : compare(start.x, end.x, Many_digits("1e-85"));
      ++compared;
      ASSERT_EQ(traits_.compare_endpoints_xy_2_object()(c), along) << c;
      ASSERT_EQ(traits_.compare_endpoints_xy_2_object()(other), -along) << c;
      ASSERT_TRUE(traits_.equal_2_object()(other.source(), c.target()) && traits_.equal_2_object()(c, other));
      ASSERT_FALSE(traits_.are_mergeable_2_object()(c, other)) << c;
    }
  }
  // Vertices of a polyline go from left to right and are at most the error away from the curve, as it is from them.
  void expect_approximations() const {
    const auto approximate = traits_.approximate_2_object();
    const Many_digits least("1e-95");  // of roundings of digits
    for (std::size_t i = 0; i < points_.size(); ++i) {
      ++compared;
      ASSERT_LE(abs(digits_[i].x - approximate(points_[i], 0)), points_[i].x().width() + least) << points_[i];
      ASSERT_LE(abs(digits_[i].y - approximate(points_[i], 1)), points_[i].y().width() + least) << points_[i];
    }
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const Part& c = parts_[i];
      const double error = std::exp2(-3 - static_cast<int>(i % 10));
      std::vector<Traits::Approximate_point_2> line;
      approximate(c, error, std::back_inserter(line));
      ++compared;
      ASSERT_GE(line.size(), 2U);
      ASSERT_EQ(line.front(), approximate(c.left()));
      ASSERT_EQ(line.back(), approximate(c.right()));
      for (std::size_t k = 0; k + 1 < line.size(); ++k) ASSERT_LE(line[k].x(), line[k + 1].x()) << c;
      const Many_digits from = c.left_parameter().lower, way = Many_digits(c.right_parameter().lower) - from;
      constexpr int PLACES = 16;
      for (int k = 0; k <= PLACES; ++k) {
        const Digits_point p = digits_jet(c.data()->bezier(), from + way * k / PLACES).point;
        double least = HUGE_VAL;
        for (std::size_t j = 0; j + 1 < line.size(); ++j) least = std::min(least, distance(p, line[j], line[j + 1]));
        ASSERT_LE(least, error) << c;
      }
    }
  }

  void expect_points_compared() const {
    for (std::size_t i = 0; i < points_.size(); ++i)
      for (std::size_t k = 0; k < points_.size(); ++k) {
        std::ostringstream names;
        names << points_[i] << " and " << points_[k];
        SCOPED_TRACE(names.str());
        const auto x = traits_.compare_x_2_object()(points_[i], points_[k]),
                   xy = traits_.compare_xy_2_object()(points_[i], points_[k]);
        ++compared;
        ASSERT_NO_FATAL_FAILURE(expect_compared(x, digits_[i].x, digits_[k].x));
        if (x != CGAL::EQUAL) {
          ASSERT_EQ(xy, x);
        } else {
          ASSERT_NO_FATAL_FAILURE(expect_compared(xy, digits_[i].y, digits_[k].y));
        }
        ASSERT_EQ(traits_.equal_2_object()(points_[i], points_[k]), xy == CGAL::EQUAL);
      }
  }
  void expect_points_above_curves() const {
    for (std::size_t i = 0; i < points_.size(); ++i)
      for (const Part& c : parts_) {
        if (!is_in_range(points_[i], c)) continue;
        CGAL::Comparison_result expected;
        if (c.is_vertical()) {
          const auto low = compare(digits_[i].y, digits_point(c.left()).y),
                     high = compare(digits_[i].y, digits_point(c.right()).y);
          expected = low == CGAL::SMALLER ? CGAL::SMALLER : (high == CGAL::LARGER ? CGAL::LARGER : CGAL::EQUAL);
        } else {
          const Many_digits y = digits_y(c, digits_[i].x);
          expected = compare(digits_[i].y, y);
          // beside an upright tangent the y of a curve errs as the root of an error in x
          if (expected != CGAL::EQUAL && abs(y - digits_[i].y) < 1e-14) continue;
        }
        ++compared;
        ASSERT_EQ(traits_.compare_y_at_x_2_object()(points_[i], c), expected) << points_[i] << " and " << c;
      }
  }
  // At a little way to the right and left of common points.
  void expect_curves_above_each_other() const {
    for (const Part& c : parts_)
      for (const Part& d : parts_) {
        if (c.is_vertical() || d.is_vertical() || &c == &d) continue;
        const Common common = common_of(traits_, c, d);
        const auto overlaps = [&](const Point& p, bool is_right) {
          for (const Part& o : common.parts)
            if (is_right ? traits_.compare_xy_2_object()(o.left(), p) != CGAL::LARGER &&
                               traits_.compare_xy_2_object()(o.right(), p) == CGAL::LARGER
                         : traits_.compare_xy_2_object()(o.right(), p) != CGAL::SMALLER &&
                               traits_.compare_xy_2_object()(o.left(), p) == CGAL::SMALLER)
              return true;
          return false;
        };
        std::vector<Point> places = common.points;
        for (const Part& o : common.parts) {
          places.push_back(o.left());
          places.push_back(o.right());
        }
        for (const Point& p : points_)  // inside an overlap, too
          if (!common.parts.empty() && is_on(p, c) && is_on(p, d)) places.push_back(p);
        for (const Point& p : places)
          for (const bool is_right : {false, true}) {
            const auto ends_before = [&](const Part& e) {
              return traits_.compare_xy_2_object()(p, is_right ? e.right() : e.left()) == CGAL::EQUAL;
            };
            if (ends_before(c) || ends_before(d)) continue;
            const Many_digits at = digits_point(p).x, x = at + (is_right ? 1 : -1) * Many_digits(1e-12);
            const auto is_next_to = [&](const Point& q) {
              return abs(digits_point(q).x - at) < 1e-9 && traits_.compare_xy_2_object()(p, q) != CGAL::EQUAL;
            };
            bool is_crowded = false;
            for (const Part* e : {&c, &d}) is_crowded = is_crowded || is_next_to(e->left()) || is_next_to(e->right());
            for (const Point& q : places) is_crowded = is_crowded || is_next_to(q);
            if (is_crowded) continue;
            const auto expected =
                overlaps(p, is_right) ? CGAL::EQUAL : compare(digits_y(c, x), digits_y(d, x), Many_digits("1e-85"));
            const auto result = is_right ? traits_.compare_y_at_x_right_2_object()(c, d, p)
                                         : traits_.compare_y_at_x_left_2_object()(c, d, p);
            ++compared;
            ASSERT_EQ(result, expected) << c << " and " << d << " at " << p << (is_right ? " right" : " left");
          }
      }
  }
  // Points are on both curves; of an overlap, its middle is, too.
  void expect_common_points() const {
    for (const Part& c : parts_)
      for (const Part& d : parts_) {
        if (&c == &d) continue;
        const Common common = common_of(traits_, c, d), exchanged = common_of(traits_, d, c);
        ++compared;
        ASSERT_EQ(common.points.size(), exchanged.points.size()) << c << " and " << d;
        ASSERT_EQ(common.parts.size(), exchanged.parts.size()) << c << " and " << d;
        for (std::size_t i = 0; i < common.points.size(); ++i)
          ASSERT_TRUE(traits_.equal_2_object()(common.points[i], exchanged.points[i]));
        for (std::size_t i = 0; i < common.parts.size(); ++i)
          ASSERT_TRUE(traits_.equal_2_object()(common.parts[i], exchanged.parts[i])) << c << " and " << d;
        for (const Part& o : common.parts) {
          if (o.is_vertical()) continue;
          const Many_digits x = (digits_point(o.left()).x + digits_point(o.right()).x) / 2;
          ASSERT_EQ(compare(digits_y(c, x), digits_y(d, x), Many_digits("1e-85")), CGAL::EQUAL);
        }
        for (const Point& p : common.points) expect_split_and_merged(c, p);
      }
  }

 private:
  [[nodiscard]] static Point end_of(const ba::Arr_curve_2& curve, int end) {
    const auto& points = curve.bezier().control_points();
    const auto& p = end == 0 ? points.front() : points.back();
    return {p.x, p.y};
  }
  void add(const Point& p) {
    points_.push_back(p);
    digits_.push_back(digits_point(p));
  }
  [[nodiscard]] bool is_in_range(const Point& p, const Part& c) const {
    return traits_.compare_x_2_object()(p, c.left()) != CGAL::SMALLER &&
           traits_.compare_x_2_object()(p, c.right()) != CGAL::LARGER;
  }
  [[nodiscard]] bool is_on(const Point& p, const Part& c) const {
    return is_in_range(p, c) && traits_.compare_y_at_x_2_object()(p, c) == CGAL::EQUAL;
  }
  void expect_split_and_merged(const Part& c, const Point& p) const {
    const auto is_end = [&](const Point& q) { return traits_.equal_2_object()(p, q); };
    if (is_end(c.left()) || is_end(c.right())) return;
    Part left, right, whole;
    traits_.split_2_object()(c, p, left, right);
    ASSERT_TRUE(is_end(left.right()) && is_end(right.left()));
    ASSERT_TRUE(traits_.are_mergeable_2_object()(left, right) && traits_.are_mergeable_2_object()(right, left));
    traits_.merge_2_object()(right, left, whole);
    ++cut;
    ASSERT_TRUE(traits_.equal_2_object()(whole, c));
    ASSERT_FALSE(traits_.equal_2_object()(left, c));
  }

  Traits traits_;
  std::vector<ba::Arr_curve_2> curves_;
  std::vector<Part> parts_;
  std::vector<Point> points_;
  std::vector<Digits_point> digits_;
};

}  // namespace bounding_arcs_test::arr_curve_traits

#endif
