// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points and curves of arrangements: Bezier pieces, and parts of them that are monotone in x.

#ifndef CGAL_BOUNDING_ARCS_2_ARRANGEMENT_ARR_CURVE_2_H
#define CGAL_BOUNDING_ARCS_2_ARRANGEMENT_ARR_CURVE_2_H

#include <CGAL/Bounding_arcs_2/arrangement/internal/Arranged_curve.h>
#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <ostream>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

/// A point of an arrangement: a pair of doubles, or an algebraic point of a curve, known exactly as far as is asked.
/// \code
/// const Arr_point_2 origin(0, 0);
/// const Bracket x = vertex->point().x();  // holds the vertex's x
/// \endcode
class Arr_point_2 {
 public:
  Arr_point_2() : Arr_point_2(0, 0) {}
  /// \pre finite
  Arr_point_2(double x, double y) {
    auto data = std::make_shared<internal::Arranged_point>();
    data->x = {x, x};
    data->y = {y, y};
    data_ = std::move(data);
  }
  explicit Arr_point_2(internal::Arranged_point_handle data) : data_(std::move(data)) {}

  /// The coordinates, in brackets of a few ulp.
  [[nodiscard]] Bracket x() const { return data_->x; }
  [[nodiscard]] Bracket y() const { return data_->y; }
  [[nodiscard]] const internal::Arranged_point_handle& data() const { return data_; }

 private:
  internal::Arranged_point_handle data_;
};

/// Writes about where it is.
inline std::ostream& operator<<(std::ostream& out, const Arr_point_2& p) {
  return out << p.x().lower + p.x().width() / 2 << ' ' << p.y().lower + p.y().width() / 2;
}

/// A polynomial or rational Bezier piece of any degree. It may have loops and cusps, run back over itself, be straight,
/// upright or a single point.
/// \code
/// const Arr_curve_2 arch(Bezier_curve_2<double>({{0, 0}, {1, 2}, {3, 2}, {4, 0}}));
/// \endcode
class Arr_curve_2 {
 public:
  class Part;  ///< monotone in x, or upright and monotone in y

  Arr_curve_2() = default;
  /// \param curve, piece what curve() and piece() tell of it
  /// \throws std::invalid_argument for curves out of the range that is served (served_range.h)
  explicit Arr_curve_2(const Bezier_curve_2<double>& bezier, std::size_t curve = 0, std::size_t piece = 0)
      : data_(std::make_shared<internal::Arranged_curve>(bezier, curve, piece)) {}

  [[nodiscard]] const Bezier_curve_2<double>& bezier() const { return data_->bezier(); }
  /// The numbers that it was made with.
  [[nodiscard]] std::size_t curve() const { return data_->curve(); }
  [[nodiscard]] std::size_t piece() const { return data_->piece(); }
  [[nodiscard]] const internal::Arranged_curve_handle& data() const { return data_; }

 private:
  explicit Arr_curve_2(internal::Arranged_curve_handle data) : data_(std::move(data)) {}
  internal::Arranged_curve_handle data_;
};

/// Returns all pieces of a drawing, with the numbers of their curves and their own numbers in these.
[[nodiscard]] inline std::vector<Arr_curve_2> arr_curves(const Drawing_2<double>& drawing) {
  std::vector<Arr_curve_2> result;
  for (std::size_t c = 0; c < drawing.curves().size(); ++c)
    for (std::size_t p = 0; p < drawing.curves()[c].beziers.size(); ++p)
      result.emplace_back(drawing.curves()[c].beziers[p], c, p);
  return result;
}

/// A part of a Bezier piece that is monotone in x, or upright and monotone in y.
/// \code
/// const Arr_curve_2::Part& part = edge->curve();
/// std::cout << part.curve().piece() << ": " << part.left_parameter().lower << '\n';
/// \endcode
class Arr_curve_2::Part {
 public:
  /// An end of a part of a curve.
  struct End {
    Arr_point_2 point;
    Bracket t;  ///< holds the parameter
  };

  Part() = default;
  /// For functors of the traits.
  /// \param branch which monotone part of the whole piece it is of, and whether parameters rise to the right there
  Part(internal::Arranged_curve_handle curve, std::size_t branch, bool is_rising, End left, End right)
      : curve_(std::move(curve)), branch_(branch), left_(std::move(left)), right_(std::move(right)),
        is_rising_(is_rising), is_directed_right_(is_rising) {}

  /// The piece that it is a part of.
  [[nodiscard]] Arr_curve_2 curve() const { return Arr_curve_2(curve_); }
  /// The ends, lexicographically, and brackets of their parameters on the piece.
  [[nodiscard]] const End& left_end() const { return left_; }
  [[nodiscard]] const End& right_end() const { return right_; }
  [[nodiscard]] const Arr_point_2& left() const { return left_.point; }
  [[nodiscard]] const Arr_point_2& right() const { return right_.point; }
  [[nodiscard]] const Bracket& left_parameter() const { return left_.t; }
  [[nodiscard]] const Bracket& right_parameter() const { return right_.t; }
  [[nodiscard]] const Arr_point_2& source() const { return is_directed_right_ ? left() : right(); }
  [[nodiscard]] const Arr_point_2& target() const { return is_directed_right_ ? right() : left(); }
  [[nodiscard]] bool is_vertical() const { return curve_->is_vertical(); }
  [[nodiscard]] bool is_directed_right() const { return is_directed_right_; }
  /// Whether parameters rise from left to right.
  [[nodiscard]] bool is_rising() const { return is_rising_; }

  [[nodiscard]] const internal::Arranged_curve_handle& data() const { return curve_; }
  [[nodiscard]] std::size_t branch() const { return branch_; }
  /// Runs through the same points the other way.
  [[nodiscard]] Part opposite() const {
    Part result = *this;
    result.is_directed_right_ = !is_directed_right_;
    return result;
  }
  /// The part between two points of it, lexicographically.
  [[nodiscard]] Part part(const End& left, const End& right) const {
    Part result = *this;
    result.left_ = left;
    result.right_ = right;
    return result;
  }

 private:
  internal::Arranged_curve_handle curve_;
  std::size_t branch_ = 0;
  End left_, right_;
  bool is_rising_ = true, is_directed_right_ = true;
};

/// Writes about where it starts and ends.
inline std::ostream& operator<<(std::ostream& out, const Arr_curve_2::Part& c) {
  return out << c.source() << ' ' << c.target();
}

}  // namespace CGAL::Bounding_arcs

#endif
