// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// CGAL's arrangements of drawings that differ by rounding: valid, the same in any order, and those of the tool, which
// has them from elsewhere; those of segments beside fractions.

#include "Arrangement_shape.h"
#include "counted_faults.h"
#include "exact_segments.h"
#include "nudged_drawings.h"
#include "overlay_checks.h"
#include "tool.h"

#include <CGAL/Arrangement_2.h>
#include <CGAL/Bounding_arcs_2/arrangement/Arr_curve_traits_2.h>
#include <CGAL/Bounding_arcs_2/arrangement/face_area.h>
#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace test_nudged_arrangements {

using namespace bounding_arcs_test;
using nlohmann::json;
using Arrangement = CGAL::Arrangement_2<ba::Arr_curve_traits_2>;
using Curves = std::vector<ba::Arr_curve_2>;

void require_same_shape(const Shape& a, const Shape& b, const char* kind) {
  if (a == b) return;
  std::ostringstream text;
  text << a << " and " << b;
  throw Fault(kind, text.str());
}

Arrangement arranged(const Curves& curves) {
  Arrangement arrangement;
  CGAL::insert(arrangement, curves.begin(), curves.end());
  if (!arrangement.is_valid()) throw Fault("invalid", "to CGAL");
  for (auto face = arrangement.faces_begin(); face != arrangement.faces_end(); ++face)
    if (!face->is_unbounded() && !(ba::face_area(face, 1).upper > 0)) throw Fault("area", "not above 0");
  return arrangement;
}
Shape shape_of(const Arrangement& arrangement) {
  Shape shape;
  for (auto v = arrangement.vertices_begin(); v != arrangement.vertices_end(); ++v)
    if (v->degree() != 2) ++shape.vertices_of_degree[v->degree()];
  shape.edges_less_vertices =
      static_cast<long>(arrangement.number_of_edges()) - static_cast<long>(arrangement.number_of_vertices());
  shape.faces = arrangement.number_of_faces();
  return shape;
}
Shape shape_by_tool(const Drawing& drawing) {
  const Temporary_file file(json_text(drawing));
  const auto run = run_tool("arrange '" + file.path() + "' --format json 2>/dev/null");
  if (run.status != 0) throw Fault("exit", std::to_string(run.status));
  const json cells = json::parse(run.output);
  Shape shape;
  for (const json& vertex : cells.at("vertices"))
    if (vertex.at("degree") != 2) ++shape.vertices_of_degree[vertex.at("degree")];
  shape.edges_less_vertices =
      static_cast<long>(cells.at("edges").size()) - static_cast<long>(cells.at("vertices").size());
  shape.faces = cells.at("faces").size();
  return shape;
}

class NudgedArrangements : public testing::TestWithParam<Nudged_kind> {};

TEST_P(NudgedArrangements, AreThoseOfTheToolInAnyOrder) {
  expect_no_faults(10, [](std::mt19937& random) {
    Drawing_pair pair = GetParam().pair(random);
    add_all(pair.a, pair.b);
    const Drawing& drawing = pair.a;
    told("arrange", drawing, Drawing(), [&] {
      Curves curves = ba::arr_curves(drawing);
      const Shape shape = shape_of(arranged(curves));
      std::shuffle(curves.begin(), curves.end(), random);
      require_same_shape(shape, shape_of(arranged(curves)), "order");
      require_same_shape(shape, shape_by_tool(drawing), "tool");
    });
  });
}

INSTANTIATE_TEST_SUITE_P(Kinds, NudgedArrangements, testing::ValuesIn(NUDGED_KINDS),
                         [](const auto& param) { return std::string(param.param.name); });

TEST(ArrangedSegments, HaveCellsOfExactFractions) {
  expect_no_faults(60, [](std::mt19937& random) {
    const Drawing drawing = nudged_polygons(random);
    told("arrange", drawing, Drawing(), [&] {
      const Arrangement found = arranged(ba::arr_curves(drawing));
      const Cells expected = exact_cells(drawing);
      std::ostringstream text;
      text << found.number_of_vertices() << ", " << found.number_of_edges() << ", " << found.number_of_faces()
           << " instead of " << expected;
      if (!(Cells{found.number_of_vertices(), found.number_of_edges(), found.number_of_faces()} == expected))
        throw Fault("cells", text.str());
    });
  });
}

// Whatever was to be done with these files.
TEST(ArrangedOverlays, AreValid) {
  const std::string folder = std::string(BOUNDING_ARCS_TEST_DATA) + "/overlay/";
  for (const json& entry : json::parse(std::ifstream(folder + "index.json"))) {
    Drawing drawing;
    for (const std::string file : entry.at("files")) add_all(drawing, ba::read_drawing(folder + file));
    try {
      static_cast<void>(arranged(ba::arr_curves(drawing)));
    } catch (const std::exception& e) {
      ADD_FAILURE() << entry.at("name") << ": " << e.what();
    }
  }
}

}  // namespace test_nudged_arrangements
