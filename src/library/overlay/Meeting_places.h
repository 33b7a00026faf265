// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The places of common points on the curves, in order: less, equal or greater, to the last bit.
//
// A common point has a place on either curve: a Bezier piece, and a bracket of its parameter there.  Brackets that are
// apart are in order.  Where they touch,
//   - single doubles are compared;
//   - where x or y of both points is a double, at an end or on a line along an axis, and the curve is monotone in it
//     over both brackets, these doubles are compared;
//   - otherwise the parameters themselves are: rational numbers, or roots of polynomials (Exact_curve.h).
// Nothing is joined by how near it is.

#ifndef BOUNDING_ARCS_LIBRARY_OVERLAY_MEETING_PLACES_H
#define BOUNDING_ARCS_LIBRARY_OVERLAY_MEETING_PLACES_H

#include "Exact_curve.h"

#include <CGAL/Bounding_arcs_2/number/Bracket.h>
#include "../query/exact_intersections.h"
#include "../query/join_intersections.h"
#include "../tree/Segment_hierarchy.h"

#include <boost/container/small_vector.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// The derivative of a curve at a parameter somewhere in a range: about, and how far it may be from that.
struct Derivative_in_range {
  Xy<double> value;
  double error;
};
/// \param rounding how far exact control points are from those of the curve
[[nodiscard]] inline Derivative_in_range derivative_in(const Bezier_evaluator& curve, const Bracket& t,
                                                       double rounding = 0) {
  const Curve_jet jet = curve(t.middle());
  const double error = curve.errors_at(t.middle(), jet).first;
  return {jet.first, error + curve.first_change(rounding, error) +
                         t.width() * (curve.second_bound() + curve.second_change(rounding))};
}
/// The doubles around a number that is known up to an error.
[[nodiscard]] inline Bracket range_around(double middle, double error) {
  constexpr double INFINITE = std::numeric_limits<double>::infinity();
  if (error == 0) return {middle, middle};
  return {std::nextafter(middle - error, -INFINITE), std::nextafter(middle + error, INFINITE)};
}
/// Whether a parameter is that of an end.
[[nodiscard]] inline bool is_end_of_piece(const Bracket& t) { return t.is_single() && (t.lower == 0 || t.lower == 1); }

/// A common point, or an end of a part along which curves run together: where it is on either curve.
struct Meeting {
  std::array<std::uint32_t, 2> bezier;  ///< numbered through, of the first curves and of the second ones
  std::array<Bracket, 2> t;
};
/// A part of a list.
template <class T> struct List_part {
  const T *first, *last;
  [[nodiscard]] const T* begin() const { return first; }
  [[nodiscard]] const T* end() const { return last; }
};

/// The place of a meeting on one of its curves: 2 times the meeting's number, plus 1 for the second curve.
using Place_number = std::uint32_t;
/// Places on one Bezier piece in their order, equal ones in one class.
struct Sorted_places {
  std::vector<boost::container::small_vector<Place_number, 2>> classes;
  std::optional<Place_number> undecided;  ///< one whose order is open; then there is no more
};

class Meeting_places {
 public:
  /// \param b may be a: then meetings are of curves with themselves
  Meeting_places(const Segment_hierarchy& a, const Segment_hierarchy& b, const Numbered_intersections& found);

  [[nodiscard]] const std::vector<Meeting>& meetings() const { return meetings_; }
  /// The first place of which doubles leave open whether curves meet there.
  [[nodiscard]] const std::optional<Place_number>& undecided() const { return undecided_; }
  [[nodiscard]] std::size_t number_of_overlaps() const { return (meetings_.size() - first_overlap_) / 2; }
  /// The numbers of an overlap's ends: a_from, b_from, a_to, b_to.
  [[nodiscard]] Place_number overlap_place(std::size_t overlap, std::size_t end) const {
    return static_cast<Place_number>(2 * first_overlap_ + 4 * overlap + end);
  }
  /// How many more overlaps a first curve is on behind a place than before it.
  [[nodiscard]] int overlaps_begun(Place_number p) const {
    return is_overlap_end(p) ? ((p - overlap_place(0, 0)) % 4 < 2 ? 1 : -1) : 0;
  }
  [[nodiscard]] const Segment_hierarchy& curves_of(Place_number p) const { return *curves_[p % 2]; }
  [[nodiscard]] std::uint32_t bezier_of(Place_number p) const { return meetings_[p / 2].bezier[p % 2]; }
  [[nodiscard]] const Bracket& bracket(Place_number p) const { return meetings_[p / 2].t[p % 2]; }

  /// The order of two places on one Bezier piece: -1, 0 or 1.
  /// \return nothing where doubles leave it open and there are no exact decisions
  [[nodiscard]] std::optional<int> compare(Place_number p, Place_number q);
  [[nodiscard]] Sorted_places sorted(std::vector<Place_number> places);
  /// The exact parameter of a place. \pre decisions are exact
  [[nodiscard]] const Exact_parameter& parameter(Place_number p);
  /// A Bezier piece in exact numbers.
  [[nodiscard]] Exact_curve& curve(const Segment_hierarchy& of, std::uint32_t bezier);

 private:
  struct Known_point {
    std::optional<double> x, y;
  };
  [[nodiscard]] Known_point known_point(const Meeting& m) const;
  [[nodiscard]] std::optional<int> compare_by_known_points(Place_number p, Place_number q) const;
  [[nodiscard]] bool are_crossings_of_same_lines(Place_number p, Place_number q) const;
  [[nodiscard]] Exact_parameter found_parameter(Place_number p);
  /// A common point's parameters on either curve.
  struct Exact_pair {
    Exact_parameter t, s;
  };
  [[nodiscard]] std::vector<Place_number> touching(Place_number p) const;
  [[nodiscard]] Exact_parameter told_apart(Place_number p);
  [[nodiscard]] std::vector<Exact_pair> exact_pairs(const std::vector<Place_number>& group);
  [[nodiscard]] std::vector<Exact_parameter> candidates(Place_number p, const std::vector<Place_number>& beside);
  [[nodiscard]] Exact_parameter overlap_end(Place_number p);
  [[nodiscard]] bool is_overlap_end(Place_number p) const { return p / 2 >= first_overlap_; }
  [[noreturn]] static void fail(std::size_t found);
  [[nodiscard]] const Exact_meetings& exact_meetings_of(Place_number p);

  std::array<const Segment_hierarchy*, 2> curves_;
  std::vector<Meeting> meetings_;
  std::size_t first_overlap_ = 0;
  std::optional<Place_number> undecided_;
  std::unordered_map<Place_number, std::unique_ptr<Exact_parameter>> parameters_;
  std::array<std::unordered_map<std::uint32_t, std::unique_ptr<Exact_curve>>, 2> exact_curves_;
  std::map<std::array<std::uint32_t, 3>, Exact_meetings> exact_meetings_;  // by pieces, and whose parameters these are
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
