// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A pair of coordinates over any number type, used for points and vectors alike below the level of the kernels.

#ifndef CGAL_BOUNDING_ARCS_2_NUMBER_XY_H
#define CGAL_BOUNDING_ARCS_2_NUMBER_XY_H

#include <CGAL/Bounding_arcs_2/number/strict_math.h>

#include <cmath>
#include <ostream>

namespace CGAL::Bounding_arcs {

/// A point or a vector of the plane with coordinates of number type `NT`.
template <class NT> struct Xy {
  NT x{0};
  NT y{0};

  friend constexpr Xy operator+(const Xy& p, const Xy& q) { return {NT(p.x + q.x), NT(p.y + q.y)}; }
  friend constexpr Xy operator-(const Xy& p, const Xy& q) { return {NT(p.x - q.x), NT(p.y - q.y)}; }
  friend constexpr Xy operator-(const Xy& p) { return {NT(-p.x), NT(-p.y)}; }
  friend constexpr Xy operator*(const NT& s, const Xy& p) { return {NT(s * p.x), NT(s * p.y)}; }
  friend bool operator==(const Xy& p, const Xy& q) { return p.x == q.x && p.y == q.y; }
  friend bool operator!=(const Xy& p, const Xy& q) { return !(p == q); }

  /// Writes x and y, with a blank between.
  friend std::ostream& operator<<(std::ostream& out, const Xy& p) { return out << p.x << ' ' << p.y; }
};

/// The determinant |p q|, positive when q lies to the left of p.
template <class NT> [[nodiscard]] constexpr NT cross(const Xy<NT>& p, const Xy<NT>& q) {
  return NT(p.x * q.y - p.y * q.x);
}

/// The scalar product of p and q.
template <class NT> [[nodiscard]] constexpr NT dot(const Xy<NT>& p, const Xy<NT>& q) {
  return NT(p.x * q.x + p.y * q.y);
}

/// p turned by +90 degrees.
template <class NT> [[nodiscard]] Xy<NT> perp(const Xy<NT>& p) { return {NT(-p.y), p.x}; }

/// The length of a vector, whose square is a number.
template <class NT> [[nodiscard]] NT euclidean_norm(const Xy<NT>& v) {
  using std::sqrt;
  return NT(sqrt(dot(v, v)));
}

}  // namespace CGAL::Bounding_arcs

#endif
