// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reading JSON files: the curves of good ones.

#include "../support/curve_text.h"

namespace test_read_json {
namespace {

using namespace bounding_arcs_test;

std::vector<fs::path> files_in(const fs::path& directory) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(directory)) files.push_back(entry.path());
  return files;
}

TEST(ReadJson, TakesEveryKeyOfABezier) {
  const auto records =
      read(R"({"control_points": [[0, 1], [2.5, -3e1], [4, 0.1]], "weights": [1, 0.5, 2], "extra": {"a": [1]},
                                "closed": true, "degree": 2, "type": "bezier", "name": "first"})");
  ASSERT_EQ(records.size(), 1u);
  EXPECT_EQ(records[0].name, "first");
  EXPECT_EQ(records[0].type, Curve_record::BEZIER);
  EXPECT_EQ(records[0].degree, 2);
  EXPECT_EQ(records[0].control_points, (Points{{0, 1}, {2.5, -30}, {4, 0.1}}));
  EXPECT_EQ(records[0].weights, (std::vector<double>{1, 0.5, 2}));
  EXPECT_TRUE(records[0].closed);
  EXPECT_FALSE(records[0].periodic);
  const auto pieces = records[0].bezier_pieces<Exact>();
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_EQ(pieces[0].control_points()[2].y, Exact(0.1));
}

TEST(ReadJson, TakesAnEmptyListForADrawingOfNothing) {
  EXPECT_TRUE(read(R"({"curves": []})").empty());
  EXPECT_TRUE(read(R"({"operation": "union", "curves": [], "type": 3})").empty());
  EXPECT_TRUE(CGAL::Bounding_arcs::drawing<double>(read(R"({"curves": []})")).curves().empty());
}

TEST(ReadJson, NamesCurvesAfterTheFileUnlessTheyAreNamed) {
  const std::string line = R"("type": "bezier", "degree": 1, "control_points": [[0, 0], [1, 0]]})";
  EXPECT_EQ(read("{" + line)[0].name, "shape");
  const auto records = read(R"({"curves": [{)" + line + R"(, {"name": "a\n\u0000b", )" + line + "]}");
  ASSERT_EQ(records.size(), 2u);
  EXPECT_EQ(records[0].name, "shape.1");
  EXPECT_EQ(records[1].name, std::string("a\n\0b", 4));
}

TEST(ReadJson, TakesUniformPeriodicAndOpenSplines) {
  const std::string start = R"({"type": "bspline", "degree": 3, "knots": "uniform",
                               "control_points": [[0, 0], [1, 0], [1, 1], [0, 1], [-1, 0]])";
  const auto open = read(start + "}");
  EXPECT_TRUE(open[0].uniform_knots);
  EXPECT_EQ(open[0].bezier_pieces<double>().size(), 2u);
  const auto closed = read(start + R"(, "periodic": true})");
  EXPECT_EQ(closed[0].bezier_pieces<double>().size(), 5u);
  EXPECT_EQ(closed[0].bezier_pieces<Exact>()[0].control_points()[1], (CGAL::Bounding_arcs::Xy<Exact>{1, Exact(1) / 3}));
}

TEST(ReadJson, KeepsOnePeriodOfUnwrappedKnots) {
  const auto records =
      read(R"({"type": "bspline", "degree": 2, "periodic": true, "control_points": [[0, 0], [1, 0], [1, 1]],
                                "knots": [-0.7, -0.4, 0, 0.1, 0.4, 0.8, 0.9, 1.2]})");
  EXPECT_EQ(records[0].knots, (std::vector<double>{0, 0.1, 0.4, 0.8}));
  EXPECT_EQ(records[0].bezier_pieces<Exact>().size(), 3u);
}

TEST(ReadJson, TakesASplineWithWeightsAsRational) {
  const auto records =
      read(R"({"type": "bspline", "degree": 1, "control_points": [[0, 0], [1, 0]], "knots": [0, 0, 1, 1],
                                "weights": [1, 2]})");
  EXPECT_EQ(records[0].type, Curve_record::NURBS);
  EXPECT_EQ(records[0].bezier_pieces<double>()[0].weights(), (std::vector<double>{1, 2}));
}

TEST(ReadJson, TakesAByteOrderMarkAndNumbersAsTheNearestDouble) {
  const auto records = read(
      "\xEF\xBB\xBF  {\"type\": \"bezier\", \"degree\": 1e0, \"control_points\":"
      "[[0.1, 1e-400], [9007199254740993, 1.00000000000000011102230246251565404e0]]}");
  EXPECT_EQ(records[0].control_points, (Points{{0.1, 0}, {9007199254740992.0, 1.0}}));
}

TEST(ReadJson, TakesEveryBundledCurve) {
  const auto files = files_in(BOUNDING_ARCS_EXAMPLE_DATA);
  std::size_t read_files = 0;
  for (const fs::path& file : files) {
    if (file.extension() != ".json") continue;
    const auto records = read_curve_file(file.string()).curves;
    ASSERT_EQ(records.size(), 1u) << file;
    EXPECT_EQ(records[0].bezier_pieces<double>().size(), records[0].control_points.size()) << file;
    expect_joined(records[0]);
    ++read_files;
  }
  EXPECT_GE(read_files, 8u);
}

TEST(ReadJson, FindsTheKnownNumberOfPiecesOfRationalCurves) {
  const std::pair<const char*, std::size_t> files[] = {{"circle", 4},
                                                       {"circle_rounded_weights", 4},
                                                       {"cubic_hook_double_knot", 6},
                                                       {"cubic_teardrop", 7},
                                                       {"cubic_wave", 7},
                                                       {"ellipse", 4},
                                                       {"hyperbola_arc", 1}};
  for (const auto& [name, pieces] : files) {
    const auto records =
        read_curve_file((fs::path(BOUNDING_ARCS_TEST_DATA) / "nurbs" / name).string() + ".json").curves;
    EXPECT_EQ(records[0].bezier_pieces<double>().size(), pieces) << name;
    expect_joined(records[0]);
  }
}

TEST(ReadJson, TakesTheUnitCircleExactly) {
  const auto records = read_curve_file((fs::path(BOUNDING_ARCS_TEST_DATA) / "nurbs" / "circle.json").string()).curves;
  for (const auto& piece : records[0].bezier_pieces<Exact>()) {
    const auto p = piece.point(Exact(1) / 3);
    EXPECT_EQ(Exact(p.x * p.x + p.y * p.y), Exact(1));
  }
}

TEST(ReadJson, IgnoresWhatElseStandsBesideAListOfCurves) {
  const std::string list = R"("curves": [{"type": "bezier", "degree": 1, "control_points": [[0, 0], [1, 0]],
                                          "curves": 7, "x": [[{"type": 3}]]}])";
  const std::string other = R"("type": "spline", "degree": [1], "control_points": {"a": [[1]]}, "knots": [null])";
  EXPECT_EQ(read("{" + list + ", " + other + "}").size(), 1u);
  EXPECT_EQ(read("{" + other + ", " + list + "}").size(), 1u);
}

TEST(ReadJson, KeepsUnitLayersAndColours) {
  const std::string line = R"("type":"bezier","degree":1,"control_points":[[0,0],[1,2]])";
  const auto read = [&](const std::string& text) {
    return CGAL::Bounding_arcs::Curve_file::from_text(text, "file", "stem");
  };
  const auto file = read(R"({"unit_in_mm":25.4,"curves":[{"layer":"Cut","colour":3,)" + line +
                         R"(},{"colour":"#0A80ff",)" + line + R"(}],"y_is_down":true})");
  EXPECT_EQ(file.unit_in_mm, 25.4);
  ASSERT_EQ(file.curves.size(), 2u);
  EXPECT_EQ(file.curves[0].layer, "Cut");
  EXPECT_EQ(file.curves[0].colour, (CGAL::Bounding_arcs::Curve_record::Colour{3, -1}));
  EXPECT_EQ(file.curves[1].layer, "");
  EXPECT_EQ(file.curves[1].colour, (CGAL::Bounding_arcs::Curve_record::Colour{0, 0x0a80ff}));
  for (const auto& record : file.curves) EXPECT_TRUE(record.y_is_down);
  const auto one = read("{\"unit_in_mm\":1,\"layer\":\"a\"," + line + "}");
  EXPECT_EQ(one.unit_in_mm, 1);
  EXPECT_EQ(one.curves.front().layer, "a");
  EXPECT_FALSE(one.curves.front().y_is_down);
  EXPECT_EQ(read("{\"unit_in_mm\":null," + line + "}").unit_in_mm, 0);
  for (const std::string wrong : {"\"unit_in_mm\":0,", "\"unit_in_mm\":\"mm\",", "\"y_is_down\":1,"}) {
    EXPECT_THROW((void)read("{" + wrong + "\"curves\":[]}"), CGAL::Bounding_arcs::Input_error) << wrong;
    EXPECT_THROW((void)read("{" + wrong + line + "}"), CGAL::Bounding_arcs::Input_error) << wrong;
  }
  for (const std::string wrong :
       {"\"layer\":1,", "\"colour\":0,", "\"colour\":256,", "\"colour\":\"red\",", "\"colour\":\"#12345g\","})
    EXPECT_THROW((void)read("{" + wrong + line + "}"), CGAL::Bounding_arcs::Input_error) << wrong;
}

}  // namespace
}  // namespace test_read_json
