// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The data behind the points and curves of arrangements: what is known of them in doubles, and whom to ask exactly.
//
//   Arranged_curve      a Bezier piece that the user gave, and its branches, which are monotone in x
//   Arranged_point      an end of one, a turn of one in x, a common point of two, or a pair of doubles
//   Arranged_meetings   all common points of two curves, made once
//
// A branch runs through a point once at most.  So a point is known by its exact coordinates alone, and where it is on a
// branch by that.  Points on a branch are in lexicographic order, or against it: none is compared by brackets that
// touch.

#ifndef CGAL_BOUNDING_ARCS_2_ARRANGEMENT_INTERNAL_ARRANGED_CURVE_H
#define CGAL_BOUNDING_ARCS_2_ARRANGEMENT_INTERNAL_ARRANGED_CURVE_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/number/Bracket.h>
#include <CGAL/Bounding_arcs_2/number/Made_once.h>
#include <CGAL/Bounding_arcs_2/tree/Bezier_evaluator.h>

#include <boost/container/small_vector.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

class Arranged_curve;
// In exact numbers, made when they are asked for: src/library/arrangement/exact_places.h.
class Exact_curve;
class Exact_parameter;
class Exact_place;
struct Exact_common;

/// Where a point is on a curve.
struct Arranged_place {
  std::uint64_t curve;  ///< its number
  std::size_t branch;   ///< of its monotone parts; a point where the curve turns is on two
  Bracket t;            ///< holds the parameter; a single double only where that is the parameter
};

/// Two curves that meet, perhaps one and the same.
struct Arranged_pair {
  Arranged_pair(std::shared_ptr<const Arranged_curve> first, std::shared_ptr<const Arranged_curve> second);
  ~Arranged_pair();

  std::shared_ptr<const Arranged_curve> a, b;
  Made_once<Exact_common> exact;
};

/// A point with all that is known of it.
struct Arranged_point {
  Bracket x, y;  ///< single doubles only where these are the coordinates
  mutable boost::container::small_vector<Arranged_place, 4> places;  ///< grows as the point is found to be on curves

  // Which point it is where x or y is no double: a curve's turn of that number, or one where two curves meet, the first
  // one at t and the second one at s.
  std::shared_ptr<const Arranged_curve> turning;
  std::size_t turn = 0;
  std::shared_ptr<const Arranged_pair> pair;
  Bracket t, s;
  mutable std::shared_ptr<Exact_place> exact;  ///< made when it is asked for

  [[nodiscard]] bool is_double() const { return x.is_single() && y.is_single(); }
};
using Arranged_point_handle = std::shared_ptr<const Arranged_point>;

/// Notes that a point is on a branch of a curve, where that is not known.
inline void add_place(const Arranged_point& p, const Arranged_place& place) {
  for (const Arranged_place& known : p.places)
    if (known.curve == place.curve && known.branch == place.branch) return;
  p.places.push_back(place);
}

/// A Bezier piece as arrangements see it.
class Arranged_curve : public std::enable_shared_from_this<Arranged_curve> {
 public:
  /// \throws std::invalid_argument for curves out of the range that is served (served_range.h)
  Arranged_curve(const Bezier_curve_2<double>& bezier, std::size_t curve, std::size_t piece);
  ~Arranged_curve();
  Arranged_curve(const Arranged_curve&) = delete;
  Arranged_curve& operator=(const Arranged_curve&) = delete;

  [[nodiscard]] std::uint64_t number() const { return number_; }  ///< of its own, in the order that curves are made
  [[nodiscard]] const Bezier_curve_2<double>& bezier() const { return evaluator_.curve(); }
  [[nodiscard]] const Bezier_evaluator& evaluator() const { return evaluator_; }
  [[nodiscard]] std::size_t curve() const { return curve_; }
  [[nodiscard]] std::size_t piece() const { return piece_; }
  [[nodiscard]] const Arranged_point_handle& start() const { return start_; }
  [[nodiscard]] const Arranged_point_handle& end() const { return end_; }
  /// Coordinates of the control points.
  [[nodiscard]] const Bracket& x() const { return x_; }
  [[nodiscard]] const Bracket& y() const { return y_; }
  /// An upper bound of |C'|.
  [[nodiscard]] double first_bound() const { return first_bound_; }
  [[nodiscard]] bool is_vertical() const { return x_.is_single(); }
  /// Parameters inside where x turns, or y of an upright piece, in rising order: between them are the branches.
  [[nodiscard]] const std::vector<Bracket>& turns() const;
  [[nodiscard]] const Exact_curve& exact() const;
  [[nodiscard]] const std::vector<Exact_parameter>& exact_turns() const;

  /// The point at a parameter that is somewhere in a range, in doubles around it.
  struct Box {
    Bracket x, y;
  };
  [[nodiscard]] Box at(const Bracket& t) const;

 private:
  Bezier_evaluator evaluator_;
  std::size_t curve_, piece_;
  std::uint64_t number_;
  Arranged_point_handle start_, end_;
  Bracket x_, y_;
  double first_bound_;
  Made_once<std::vector<Bracket>> turns_;
  Made_once<Exact_curve> exact_;
  Made_once<std::vector<Exact_parameter>> exact_turns_;
};
using Arranged_curve_handle = std::shared_ptr<const Arranged_curve>;

/// What two curves have in common.
struct Arranged_meetings {
  struct Point {
    Arranged_point_handle point;
    bool is_transversal;
  };
  /// A curve's way along an overlap, from its start to its end.
  struct Way {
    std::size_t first, last;  ///< branches
    bool is_forward;          ///< its parameter rises
  };
  struct Overlap {
    Arranged_point_handle from, to;
    Way a, b;
  };
  std::shared_ptr<const Arranged_pair> pair;
  std::vector<Point> points;
  std::vector<Overlap> overlaps;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
