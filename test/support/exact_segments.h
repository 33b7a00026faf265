// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What straight segments cut the plane into, by fractions: every pair is looked at, and points are compared.

#ifndef BOUNDING_ARCS_TEST_EXACT_SEGMENTS_H
#define BOUNDING_ARCS_TEST_EXACT_SEGMENTS_H

#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>

#include <CGAL/Exact_rational.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <ostream>
#include <set>
#include <utility>
#include <vector>

namespace bounding_arcs_test {

/// How many vertices, edges and faces there are.
struct Cells {
  std::size_t vertices = 0, edges = 0, faces = 0;

  friend bool operator==(const Cells& a, const Cells& b) {
    return a.vertices == b.vertices && a.edges == b.edges && a.faces == b.faces;
  }
  friend std::ostream& operator<<(std::ostream& out, const Cells& c) {
    return out << c.vertices << " vertices, " << c.edges << " edges, " << c.faces << " faces";
  }
};

/// Cells of curves of degree 1, no point among them.
inline Cells exact_cells(const CGAL::Bounding_arcs::Drawing_2<double>& drawing) {
  using Number = CGAL::Exact_rational;
  using Fraction_point = std::pair<Number, Number>;  // ordered from left to right
  struct Segment {
    Fraction_point a, b;
    std::set<Fraction_point> cuts;
  };
  std::vector<Segment> segments;
  for (const auto& curve : drawing.curves())
    for (const auto& piece : curve.beziers) {
      const auto &p = piece.control_points().front(), &q = piece.control_points().back();
      const Fraction_point a(p.x, p.y), b(q.x, q.y);
      segments.push_back({(std::min)(a, b), (std::max)(a, b), {a, b}});
    }
  const auto side = [](const Segment& s, const Fraction_point& q) {
    return Number((s.b.first - s.a.first) * (q.second - s.a.second) -
                  (s.b.second - s.a.second) * (q.first - s.a.first));
  };
  const auto add_ends = [&](Segment& s, const Segment& other) {
    for (const Fraction_point& q : {other.a, other.b})
      if (side(s, q) == 0 && s.a <= q && q <= s.b) s.cuts.insert(q);
  };
  for (std::size_t i = 0; i < segments.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      Segment &s = segments[i], &other = segments[k];
      add_ends(s, other);
      add_ends(other, s);
      const Number a = side(s, other.a), b = side(s, other.b), c = side(other, s.a), d = side(other, s.b);
      if (CGAL::sign(a) * CGAL::sign(b) >= 0 || CGAL::sign(c) * CGAL::sign(d) >= 0) continue;
      const Number t = c / (c - d);
      const Fraction_point q(s.a.first + t * (s.b.first - s.a.first), s.a.second + t * (s.b.second - s.a.second));
      s.cuts.insert(q);
      other.cuts.insert(q);
    }
  std::map<Fraction_point, std::size_t> vertices;
  std::set<std::pair<std::size_t, std::size_t>> edges;
  const auto number_of = [&](const Fraction_point& q) { return vertices.emplace(q, vertices.size()).first->second; };
  for (const Segment& s : segments)
    for (auto q = s.cuts.begin(); std::next(q) != s.cuts.end(); ++q) {
      const std::size_t from = number_of(*q);
      edges.emplace(from, number_of(*std::next(q)));
    }
  boost::disjoint_sets_with_storage<> parts(vertices.size());
  for (std::size_t v = 0; v < vertices.size(); ++v) parts.make_set(v);
  for (const auto& [from, to] : edges) parts.union_set(from, to);
  std::size_t components = 0;
  for (std::size_t v = 0; v < vertices.size(); ++v) components += parts.find_set(v) == v ? 1 : 0;
  return {vertices.size(), edges.size(), 1 + components + edges.size() - vertices.size()};
}

}  // namespace bounding_arcs_test

#endif
