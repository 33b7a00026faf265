// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What two arrangements of the same curves have in common.

#ifndef BOUNDING_ARCS_TEST_ARRANGEMENT_SHAPE_H
#define BOUNDING_ARCS_TEST_ARRANGEMENT_SHAPE_H

#include <cstddef>
#include <map>
#include <ostream>

namespace bounding_arcs_test {

/// What does not depend on where curves are cut besides at their common points.
struct Shape {
  std::map<std::size_t, int> vertices_of_degree;  // but 2
  std::ptrdiff_t edges_less_vertices = 0;
  std::size_t faces = 0;

  friend bool operator==(const Shape& a, const Shape& b) {
    return a.vertices_of_degree == b.vertices_of_degree && a.edges_less_vertices == b.edges_less_vertices &&
           a.faces == b.faces;
  }
  friend std::ostream& operator<<(std::ostream& out, const Shape& s) {
    for (const auto& [degree, count] : s.vertices_of_degree) out << count << " vertices of degree " << degree << ", ";
    return out << s.edges_less_vertices << " more edges than vertices, " << s.faces << " faces";
  }
};

}  // namespace bounding_arcs_test

#endif
