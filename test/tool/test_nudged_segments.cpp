// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What `bounding_arcs arrange` makes of segments whose ends are some ulp from where they belong, beside fractions.

#include "counted_faults.h"
#include "exact_segments.h"
#include "nudged_drawings.h"
#include "overlay_checks.h"
#include "tool.h"

#include <gtest/gtest.h>

#include <random>
#include <sstream>
#include <string>

namespace test_nudged_segments {

using namespace bounding_arcs_test;
using nlohmann::json;

TEST(NudgedSegments, HaveCellsOfExactFractions) {
  expect_no_faults(60, [](std::mt19937& random) {
    const Drawing drawing = nudged_polygons(random);
    const Cells expected = exact_cells(drawing);
    const std::string text = json_text(drawing);
    const Temporary_file file(text);
    const auto run = run_tool("arrange '" + file.path() + "' --format json 2>/dev/null");
    if (run.status != 0) throw Fault("exit " + std::to_string(run.status), text);
    const json found = json::parse(run.output);
    const Cells cells{found.at("vertices").size(), found.at("edges").size(), found.at("faces").size()};
    std::ostringstream difference;
    difference << cells << " instead of " << expected << '\n' << text;
    if (!(cells == expected)) throw Fault("cells", difference.str());
    for (const json& face : found.at("faces"))
      if (face.at("bounded") && face.at("area").at(1) < 0) throw Fault("area", face.at("area").dump() + '\n' + text);
  });
}

}  // namespace test_nudged_segments
