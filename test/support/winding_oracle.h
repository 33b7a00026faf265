// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Winding numbers by Sturm sequences, along a ray in no special direction: shares nothing with the code under test.

#ifndef BOUNDING_ARCS_TEST_WINDING_ORACLE_H
#define BOUNDING_ARCS_TEST_WINDING_ORACLE_H

#include "Sturm.h"

#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace bounding_arcs_test {

// A curve seen from q, times its weight: along and across a direction.
struct Turned_curve {
  Powers along, across;
};
template <class NT>
Turned_curve turned_curve(const Bezier_curve_2<NT>& c, const CGAL::Bounding_arcs::Xy<Rational>& q, const Rational& dx,
                          const Rational& dy) {
  std::vector<Rational> along, across;
  for (int i = 0; i <= c.degree(); ++i) {
    const auto& p = c.control_points()[static_cast<std::size_t>(i)];
    const Rational w(c.weight(i)), x = w * (Rational(p.x) - q.x), y = w * (Rational(p.y) - q.y);
    along.push_back(dx * x + dy * y);
    across.push_back(dx * y - dy * x);
  }
  return {from_bernstein(along), from_bernstein(across)};
}

inline bool meet_in_unit(const Powers& a, const Powers& b) {
  Powers p = a, q = b;
  while (!q.empty()) {
    if (p.size() < q.size()) std::swap(p, q);
    p = negative_remainder(p, q);
    std::swap(p, q);
  }
  if (p.size() == 1) return false;
  return p.empty() || value(p, 0) == 0 || Sturm(p).roots(0, 1) > 0;
}

// Signed crossings of the positive axis over (a, b]; simple roots of `across` only, none at a or b.
inline int signed_crossings(const Turned_curve& c, const Sturm& across, const Sturm& along, const Rational& a,
                            const Rational& b) {
  const int roots = across.roots(a, b);
  if (roots == 0) return 0;
  if (roots == 1 && along.roots(a, b) == 0 && value(c.along, a) != 0) {
    const Rational rise = value(c.across, b) - value(c.across, a);
    return value(c.along, b) > 0 ? (rise > 0 ? 1 : -1) : 0;
  }
  Rational middle = (a + b) / 2;
  while (value(c.across, middle) == 0) middle = (middle + b) / 2;
  return signed_crossings(c, across, along, a, middle) + signed_crossings(c, across, along, middle, b);
}

/// \return nothing if q is on a curve
template <class NT>
std::optional<int> winding_by_sturm(const CGAL::Bounding_arcs::Drawing_2<NT>& drawing,
                                    const CGAL::Bounding_arcs::Xy<Rational>& q) {
  const Rational dx = Rational(7919), dy = Rational(104729) / 3331;
  int number = 0;
  for (const auto& curve : drawing.curves())
    for (const auto& bezier : curve.beziers) {
      const Turned_curve c = turned_curve(bezier, q, dx, dy);
      if (meet_in_unit(c.along, c.across)) return std::nullopt;
      if (c.across.empty() || c.along.empty()) continue;  // on the line, but not about q
      if (value(c.across, 0) == 0 || value(c.across, 1) == 0) throw std::logic_error("a direction that is special");
      number += signed_crossings(c, Sturm(c.across), Sturm(c.along), 0, 1);
    }
  return number;
}

}  // namespace bounding_arcs_test

#endif
