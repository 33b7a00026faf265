// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Curve files that are not to be read, JSON and SVG: each is refused with its place and reason, and none does harm.

#include "../support/curve_text.h"
#include "cases.h"

#include <cstdlib>
#include <fstream>

namespace test_bad_curve_files {
namespace {

using namespace bounding_arcs_test;

// A directory for the files of one test, gone with it.
struct Scratch_directory {
  Scratch_directory() {
    std::string name = (fs::temp_directory_path() / "bounding_arcs_XXXXXX").string();
    path = mkdtemp(name.data());
  }
  ~Scratch_directory() { fs::remove_all(path); }
  std::string file(const std::string& name, const std::string& content) const {
    std::ofstream(path / name, std::ios::binary) << content;
    return (path / name).string();
  }
  fs::path path;
};

struct Bad_file {
  const char* name;
  std::string content;
  std::string expected;
};

// A curve with one key replaced or added.
std::string bezier_with(const std::string& changed, const std::string& without = "") {
  std::string text = "{";
  for (const auto& [key, value] : {std::pair<std::string, std::string>{"type", "\"bezier\""},
                                   {"degree", "1"},
                                   {"control_points", "[[0, 0], [1, 0]]"}})
    if (key != without) text += '"' + key + "\": " + value + ", ";
  return text + changed + "}";
}

std::string spline_with(const std::string& rest, int degree = 2) {
  return R"({"type": "bspline", "control_points": [[0, 0], [1, 0], [1, 1]], "degree": )" + std::to_string(degree) +
         ", " + rest + "}";
}

std::vector<Bad_file> bad_json_files() {
  return {
      {"empty.json", "", "line 1, column 1: expected JSON, SVG or DXF, found an empty file"},
      {"space.json", " \n ", "line 1, column 1: expected JSON, SVG or DXF, found an empty file"},
      {"truncated.json", "{\"type\": \"bezier\",\n \"degree\"", "line 2, column 10: syntax error"},
      {"comma.json", "{\n\"type\": \"bezier\",\n}", "line 3, column 1: syntax error"},
      {"second.json", bezier_with("\"x\": 1") + " {}", "syntax error"},
      {"garbage.json",
       std::string("\x7F"
                   "ELF\x02\x01\0\0\x80\xFF",
                   10),
       "line 1, column 1: expected JSON, SVG or text DXF, found a file that begins with \"\\x7FELF"},
      {"utf16.json", "\xFF\xFE{\x01", "line 1, column 1: expected UTF-8"},
      {"utf8.json", "{\"name\": \"a\xFF\"}", "line 1, column 12: syntax error while parsing value - invalid string"},
      {"break.json", "{\"name\": \"a\nb\"}", "control character U+000A"},
      {"nan.json", bezier_with("\"weights\": [NaN, 1]"), "syntax error while parsing value - invalid literal"},
      {"deep.json", repeated("[", 100000), "[0][0]"},
      {"deeper.json", repeated("{\"a\":", 100000), "a.a.a"},
      {"twice.json", bezier_with("\"x\": {\"k\": 1, \"k\": 2}"), "x: expected each key once, found \"k\" twice"},
      {"list.json", "[]", "document: expected an object, found a list of 0"},
      {"number.json", "17", "line 1, column 1: expected JSON, SVG or text DXF, found a file that begins with \"17\""},
      {"offsets.json", "{\"eps\": 1, \"offsets\": []}", "offsets: expected curves, found a result of `offset`"},
      {"curves.json", "{\"curves\": {}}", "curves: expected a list, found an object"},
      {"member.json", "{\"curves\": [" + bezier_with("\"x\": 1") + ", 3]}", "curves[1]: expected an object, found 3"},
      {"no_type.json", bezier_with("\"x\": 1", "type"), "curve: expected the key \"type\", found none"},
      {"no_degree.json", bezier_with("\"x\": 1", "degree"), "curve: expected the key \"degree\", found none"},
      {"no_points.json", bezier_with("\"x\": 1", "control_points"),
       "curve: expected the key \"control_points\", found none"},
      {"mixed.json", "{\"type\": 7, \"curves\": [" + bezier_with("\"x\": 1") + ", null]}",
       "curves[1]: expected an object, found null"},
      {"list_in_list.json", "{\"type\": 7, \"curves\": [[1, 2]]}", "curves[0]: expected an object, found a list of 2"},
      {"first.json",
       "{\"curves\": [" + bezier_with("\"degree\": 0", "degree") + ", " + bezier_with("\"name\": 3") + "]}",
       "curves[0].degree: expected a whole number from 1 to 32, found 0"},
      {"nested_point.json", bezier_with("\"control_points\": [[0, 0], [[1], 2]]", "control_points"),
       "control_points[1][0]: expected a finite number, found a list of 1"},
      {"type.json", bezier_with("\"type\": \"spline\"", "type"),
       "type: expected \"bezier\", \"bspline\", \"nurbs\" or \"path\", found \"spline\""},
      {"type_number.json", bezier_with("\"type\": 3", "type"),
       "type: expected \"bezier\", \"bspline\", \"nurbs\" or \"path\", found 3"},
      {"path.json", R"({"type":"path"})", "curve: expected the key \"pieces\", found none"},
      {"path_empty.json", R"({"type":"path","pieces":[]})", "pieces: expected at least one piece, found none"},
      {"path_gap.json",
       R"({"type":"path","pieces":[{"control_points":[[0,0],[1,0]]},{"control_points":[[2,0],[0,0]]}]})",
       "pieces[1]: expected a piece that starts where the one before ends"},
      {"path_number.json", R"({"type":"path","pieces":[{"control_points":[[0,0],[1,"x"]]}]})",
       "pieces[0].control_points[1][1]: expected a finite number, found \"x\""},
      {"path_weights.json", R"({"type":"path","pieces":[{"control_points":[[0,0],[1,0]],"weights":[1]}]})",
       "pieces[0]: expected as many weights as control points"},
      {"path_points.json", R"({"type":"path","control_points":[[0,0]],"pieces":[{"control_points":[[0,0],[1,0]]}]})",
       "control_points: expected them in the pieces of the path, found them beside"},
      {"pieces.json", bezier_with(R"("pieces": [])"), "pieces: expected none, as only a path has them, found some"},
      {"name.json", bezier_with("\"name\": 3"), "name: expected a string, found 3"},
      {"degree_half.json", bezier_with("\"degree\": 1.5", "degree"),
       "degree: expected a whole number from 1 to 32, found 1.5"},
      {"degree_zero.json", bezier_with("\"degree\": 0", "degree"),
       "degree: expected a whole number from 1 to 32, found 0"},
      {"degree_33.json", bezier_with("\"degree\": 33", "degree"),
       "degree: expected a whole number from 1 to 32, found 33"},
      {"degree_huge.json", bezier_with("\"degree\": 18446744073709551615", "degree"),
       "degree: expected a whole number"},
      {"degree_text.json", bezier_with("\"degree\": \"1\"", "degree"),
       "degree: expected a whole number from 1 to 32, found \"1\""},
      {"degree_points.json", bezier_with("\"degree\": 2", "degree"),
       "control_points: expected 3 of a bezier of degree 2, found 2"},
      {"points.json", bezier_with("\"control_points\": 3", "control_points"),
       "control_points: expected a list, found 3"},
      {"three.json", bezier_with("\"control_points\": [[0, 0], [1, 2, 3]]", "control_points"),
       "control_points[1]: expected a point [x, y], found a list of 3"},
      {"text.json",
       "{\"curves\": [" + bezier_with("\"x\": 1") + "," +
           bezier_with("\"control_points\": [[0, 0], [\"abc\", 2]]", "control_points") + "]}",
       "curves[1].control_points[1][0]: expected a finite number, found \"abc\""},
      {"null.json", bezier_with("\"control_points\": [[0, 0], [1, null]]", "control_points"),
       "control_points[1][1]: expected a finite number, found null"},
      {"overflow.json", bezier_with("\"control_points\": [[0, 0], [1, 1e400]]", "control_points"),
       "control_points[1][1]: expected a finite number, found number overflow"},
      {"great.json", bezier_with("\"control_points\": [[0, 0], [1e302, 0]]", "control_points"),
       "control_points[1][0]: expected a number of magnitude at most 2^1000, found 1e+302"},
      {"weights_count.json", bezier_with("\"weights\": [1]"),
       "curve: weights: expected as many as control points, 2, found 1"},
      {"weights_zero.json", bezier_with("\"weights\": [1, 0]"), "weights[1]: expected a positive weight, found 0"},
      {"weights_ratio.json", bezier_with("\"weights\": [1, 1e200]"),
       "weights[1]: expected a weight within 2^-500 and 2^500, found 1e+200"},
      {"weights_small.json", bezier_with("\"weights\": [1e-200, 1]"),
       "weights[0]: expected a weight within 2^-500 and 2^500"},
      {"bezier_knots.json", bezier_with("\"knots\": [0, 0, 1, 1]"), "knots: expected none of a bezier, found some"},
      {"bezier_periodic.json", bezier_with("\"periodic\": true"), "periodic: expected false of a bezier, found true"},
      {"closed.json", bezier_with("\"closed\": 1"), "closed: expected true or false, found 1"},
      {"periodic.json", spline_with("\"knots\": \"uniform\", \"periodic\": \"yes\""),
       "periodic: expected true or false, found \"yes\""},
      {"no_knots.json", spline_with("\"x\": 1"), "curve: expected the key \"knots\", found none"},
      {"knots_text.json", spline_with("\"knots\": \"clamped\""),
       "knots: expected \"uniform\" or a list, found \"clamped\""},
      {"knots_empty.json", spline_with("\"knots\": [], \"periodic\": true"), "knots: expected at least one knot"},
      {"knots_count.json", spline_with("\"knots\": [0, 1]"),
       "curve: knots: expected 6 (control points + degree + 1), found 2"},
      {"knots_order.json", spline_with("\"knots\": [0, 0, 0, 1, 0.5, 1]"),
       "curve: knot 4: expected no less than knot 3, found 0.5"},
      {"knots_multiple.json", R"({"type": "bspline", "degree": 1, "control_points": [[0, 0], [1, 0], [1, 1], [0, 1]],
                                 "knots": [0, 1, 2, 2, 3, 4]})",
       "curve: knot 3: expected at most 1 equal ones, as the curve falls apart with more, found 2"},
      {"knots_domain.json", spline_with("\"knots\": [0, 1, 2, 2, 3, 4]"),
       "curve: knots: expected knot 2 below knot 3, found an empty domain"},
      {"knots_period.json", spline_with("\"periodic\": true, \"knots\": [0, 1, 2, 3, 4, 5, 6, 7.5]"),
       "curve: knots: expected knots"},
      {"spline_points.json", spline_with("\"knots\": \"uniform\"", 3),
       "curve: control points: expected at least 4 of a B-spline of degree 3, found 3"},
      {"spline_weights.json", spline_with("\"knots\": \"uniform\", \"weights\": [1, 1]"),
       "curve: weights: expected 3, one a control point, found 2"},
      {"nurbs.json", R"({"type": "nurbs", "degree": 1, "control_points": [[0, 0], [1, 0]], "knots": "uniform"})",
       "curve: expected the key \"weights\", found none"},
      {"nurbs_empty.json",
       R"({"type": "nurbs", "degree": 1, "control_points": [[0, 0], [1, 0]], "knots": "uniform", "weights": []})",
       "weights: expected one a control point of a nurbs, found none"},
  };
}

std::vector<Bad_file> bad_svg_files() {
  const std::string path = "<path id='p' d='";
  return {
      {"angle.svg", "<", "line 1, column 1: XML: "},
      {"truncated.svg", "<svg>\n<path d='M0", "line 2, column "},
      {"mismatch.svg", "<svg>\n<g></h></svg>", "line 2, column 6: XML: Start-end tags mismatch"},
      {"unclosed.svg", "<svg><g>", "XML: "},
      {"nul.svg", std::string("<svg>\0</svg>", 12), "line 1, column 6: expected XML, found a NUL byte"},
      {"html.svg", "<html/>", "line 1, column 2, <html>: expected the root element svg, found another one"},
      {"two.svg", svg("<line x2='1'/>") + "<svg/>", "<svg>: expected one root element, found a second one"},
      {"empty.svg", svg(""), "no curve in the drawing"},
      {"point.svg", svg("<path d='M1 1z'/>"), "no curve in the drawing; left out: 1 path: draws nothing"},
      {"start.svg", svg("\n" + path + "L1 1'/>"),
       "line 2, column 2, <path id=\"p\">, attribute d, character 1: expected the command M or m"},
      {"command.svg", svg(path + "M0 0 X 1 1'/>"), "attribute d, character 6: expected a path command, found \"X\""},
      {"missing.svg", svg(path + "M0 0L1'/>"), "attribute d, character 7: expected a number, found the end"},
      {"odd.svg", svg(path + "M0 0L1 1 2'/>"), "attribute d, character 11: expected a number, found the end"},
      {"comma.svg", svg(path + "M0 0L1,,1'/>"), "attribute d, character 8: expected a number, found \",1\""},
      {"first_comma.svg", svg(path + "M,0 0L1 1'/>"), "attribute d, character 2: expected a number, found \",0\""},
      {"last_comma.svg", svg(path + "M0 0L1 1,'/>"), "attribute d, character 10: expected a number, found the end"},
      {"after_close.svg", svg(path + "M0 0L1 1z 2 2'/>"),
       "attribute d, character 11: expected a path command, found \"2\""},
      {"flag.svg", svg(path + "M0 0A1 1 0 2 0 1 1'/>"),
       "attribute d, character 12: expected an arc flag 0 or 1, found \"2\""},
      {"nan.svg", svg(path + "M0 0L nan 1'/>"), "attribute d, character 7: expected a number, found \"nan\""},
      {"overflow.svg", svg(path + "M0 0L1e400 1'/>"),
       "attribute d, character 6: expected a number of magnitude at most 2^1000"},
      {"long.svg", svg(path + "M0 0L1" + repeated("0", 400) + "e-5 1'/>"),
       "attribute d, character 6: expected a number of magnitude"},
      {"sum.svg", svg(path + "M1e301 0l1e301 0'/>"), "attribute d, character 17: expected coordinates up to 2^1000"},
      {"tiny_arc.svg", svg(path + "M0 0A1e-300 1e-300 0 0 0 1e200 0'/>"),
       "expected radii that are not lost beside the chord of the arc, found smaller ones"},
      {"unit.svg", svg("<rect width='3lightyears' height='1'/>"),
       "<rect>, attribute width, character 2: expected a unit"},
      {"no_number.svg", svg("<circle r='big'/>"),
       "<circle>, attribute r, character 1: expected a number, found \"big\""},
      {"negative.svg", svg("<circle r='-1'/>"),
       "<circle>, attribute r, character 1: expected a size of at least 0, found -1"},
      {"points.svg", svg("<polyline points='0 0 1'/>"),
       "<polyline>, attribute points, character 6: expected a number, found the end"},
      {"transform.svg", svg("<g id='\n' transform='spin(3)'/>"),
       "<g id=\" \">, attribute transform, character 1: expected matrix,"},
      {"arguments.svg", svg("<g transform='scale(1) matrix(1 2)'/>"),
       "attribute transform, character 10: expected as many arguments as matrix takes, found 2"},
      {"rotate.svg", svg("<g transform='rotate(1 2)'/>"), "expected as many arguments as rotate takes, found 2"},
      {"bracket.svg", svg("<g transform='scale(1'/>"),
       "attribute transform, character 8: expected a number or \")\", found the end"},
      {"infinite.svg", svg("<g transform='scale(1e300) scale(1e300)'><circle r='1'/></g>"),
       "<circle>: expected coordinates up to 2^1000"},
      {"viewbox.svg", svg("<svg viewBox='0 0 0 1'><circle r='1'/></svg>"),
       "attribute viewBox: expected a width and a height above 0, found"},
      {"use.svg", svg("<use href='#nothing'/>"), "<use>: expected an element with the id \"nothing\", found none"},
      {"external.svg", svg("<use href='other.svg#a'/>"),
       "<use>: expected a reference into this file, found \"other.svg#a\""},
      {"itself.svg", svg("<g id='a'><use href='#a'/></g>"),
       "<use>: expected no use of an element within itself, found \"#a\""},
      {"circle.svg", svg("<g id='a'><use href='#b'/></g><g id='b'><use href='#a'/></g>"),
       "expected no use of an element within itself"},
      {"entity.svg", "<!DOCTYPE svg [<!ENTITY a 'M0 0'><!ENTITY b '&a;&a;'>]>" + svg("<path d='&b;'/>"),
       "no curve in the drawing; left out: 1 path: draws nothing"},
  };
}

void expect_reported(const Scratch_directory& scratch, const Bad_file& bad) {
  const std::string path = scratch.file(bad.name, bad.content);
  const std::string message = message_of([&] { (void)read_curve_file(path).curves; });
  EXPECT_EQ(message.find(path + ": "), 0u) << bad.name << ": " << message;
  EXPECT_NE(message.find(bad.expected), std::string::npos) << bad.name << ": " << message;
  EXPECT_EQ(message.find_first_of("\n\r\t"), std::string::npos) << bad.name;
  EXPECT_NE(message.find(": ", path.size() + 2), std::string::npos) << bad.name << " has no place: " << message;
  EXPECT_LT(message.size(), path.size() + 700) << bad.name;
}

TEST(ReadCurves, ReportsEveryBadJsonFileWithPlaceAndReason) {
  const Scratch_directory scratch;
  const auto files = bad_json_files();
  EXPECT_GE(files.size(), 45u);
  for (const Bad_file& bad : files) expect_reported(scratch, bad);
}

TEST(ReadCurves, ReportsEveryBadSvgFileWithPlaceAndReason) {
  const Scratch_directory scratch;
  for (const Bad_file& bad : bad_svg_files()) expect_reported(scratch, bad);
}

TEST(ReadCurves, ReportsFilesThatAreNone) {
  const Scratch_directory scratch;
  const auto message = [](const std::string& path) { return message_of([&] { (void)read_curve_file(path).curves; }); };
  const std::string missing = (scratch.path / "missing\n.json").string();
  EXPECT_NE(message(missing).find("missing\\x0A.json: file: cannot be opened: "), std::string::npos);
  EXPECT_EQ(message(scratch.path.string()), scratch.path.string() + ": file: expected a file, found a directory");
  const std::string locked = scratch.file("locked.json", "{}");
  fs::permissions(locked, fs::perms::none);
  const bool reads_anything = std::ifstream(locked).good();  // as the superuser does
  EXPECT_TRUE(reads_anything || message(locked).find("file: cannot be opened: ") != std::string::npos);
}

TEST(ReadCurves, EndsAtEndlessFiles) {
  EXPECT_NE(message_of([] {
              (void)read_curve_file("/dev/zero").curves;
            }).find("/dev/zero: file: expected at most 268435456 bytes"),
            std::string::npos);
}

TEST(ReadCurves, BoundsDepthAndRepetitionInSvg) {
  const std::string deep = svg(repeated("<g>", 100000) + "<line x2='1'/>" + repeated("</g>", 100000));
  EXPECT_NE(message_of([&] { (void)read(deep); }).find("<g>: expected at most 256 levels of elements, found more"),
            std::string::npos);
  std::string content = "<g id='x0'><line x2='1'/></g>";
  for (int i = 1; i < 30; ++i) {
    const std::string use = "<use href='#x" + std::to_string(i - 1) + "'/>";
    content += "<g id='x" + std::to_string(i) + "'>" + repeated(use, 10) + "</g>";
  }
  EXPECT_NE(message_of([&] {
              (void)read_svg(content);
            }).find("expected at most 1000000 elements and pieces added by use elements"),
            std::string::npos);
}

// What is passed by under many use elements takes time as what is drawn does; names take memory for every subpath.
TEST(ReadCurves, BoundsWhatUseElementsPassByAndRepeatedNamesInSvg) {
  const std::string passed_by[] = {"<switch id='x'>" + repeated("<a requiredExtensions='x'/>", 3000) + "</switch>",
                                   "<g id='x'>" + repeated("<![CDATA[x]]>", 3000) + "</g>"};
  for (const std::string& group : passed_by)
    EXPECT_NE(message_of([&] {
                (void)read_svg(group + repeated("<use href='#x'/>", 3000) + "<line x2='1'/>");
              }).find("expected at most 1000000 elements and pieces added by use elements"),
              std::string::npos)
        << group.substr(0, 50);
  const std::string many = repeated("M0 0h1", 3000);
  EXPECT_NE(message_of([&] {
              (void)read_svg("<path id='" + repeated("i", 30000) + "' d='" + many + "'/>");
            }).find("or repeated long ids"),
            std::string::npos);
  EXPECT_EQ(read_svg("<path id='" + repeated("i", 300) + "' d='" + many + "'/>").size(), 3000u);
}

TEST(ReadCurves, TakesJsonLongerThanSvgMayBe) {
  if (bounding_arcs_test::FEW_CASES) return;
  const Scratch_directory scratch;
  const std::string space(std::size_t(65) << 20, ' ');
  EXPECT_EQ(read_curve_file(scratch.file("long.json", space + bezier_with("\"name\": \"far\""))).curves.at(0).name,
            "far");
  EXPECT_NE(message_of([&] {
              (void)read_svg(space + "<line x2='1'/>");
            }).find("file: expected at most 67108864 bytes of SVG"),
            std::string::npos);
}

// Every prefix of a file and every file with one byte changed either reads or is reported.
TEST(ReadCurves, SurvivesDamage) {
  const std::string files[] = {
      spline_with("\"knots\": [0, 0, 0, 1, 1, 1], \"weights\": [1, 2, 1], \"name\": \"\\u00e9\""),
      svg("<g transform='rotate(30 1 2)'><path id='a' d='M0 0a1 2 3 0 1 4 5q1 2 3 4t1 1z'/><use href='#a' "
          "x='3%'/></g>")};
  for (const std::string& file : files)
    for (std::size_t i = 0; i < file.size(); ++i) {
      EXPECT_NE(message_of([&] { (void)read(file.substr(0, i)); }), "no error") << i;
      for (const char c : {'\0', '\xFF', '"', '9', '-', ']', '<', '\''}) {
        std::string damaged = file;
        damaged[i] = c;
        message_of([&] {
          for (const Curve_record& record : read(damaged)) EXPECT_FALSE(record.bezier_pieces<double>().empty());
        });
      }
    }
}

}  // namespace
}  // namespace test_bad_curve_files
