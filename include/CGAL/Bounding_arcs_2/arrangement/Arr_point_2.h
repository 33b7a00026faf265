// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points of arrangements.

#ifndef CGAL_BOUNDING_ARCS_2_ARRANGEMENT_ARR_POINT_2_H
#define CGAL_BOUNDING_ARCS_2_ARRANGEMENT_ARR_POINT_2_H

#include <CGAL/Bounding_arcs_2/arrangement/internal/Arranged_curve.h>

#include <cmath>
#include <memory>
#include <ostream>
#include <utility>

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

}  // namespace CGAL::Bounding_arcs

#endif
