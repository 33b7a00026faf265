// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the tests of the curve readers share: curves from text, and what is looked at in them.

#ifndef BOUNDING_ARCS_TEST_CURVE_TEXT_H
#define BOUNDING_ARCS_TEST_CURVE_TEXT_H

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>

#include <CGAL/Exact_rational.h>

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace bounding_arcs_test {

using CGAL::Bounding_arcs::Curve_file;
using CGAL::Bounding_arcs::Curve_record;
using CGAL::Bounding_arcs::Input_error;
using CGAL::Bounding_arcs::read_curve_file;
using Bezier = CGAL::Bounding_arcs::Bezier_curve_2<double>;
using Exact = CGAL::Exact_rational;
using Point = CGAL::Bounding_arcs::Xy<double>;
using Points = std::vector<Point>;
using Records = std::vector<Curve_record>;
namespace fs = std::filesystem;

// Both readers by way of their text; "shape" is the stem of the file.
inline Records read(const std::string& text) { return Curve_file::from_text(text, "shape.json", "shape").curves; }

inline std::string svg(const std::string& content, const std::string& attributes = "") {
  return "<svg xmlns='http://www.w3.org/2000/svg' " + attributes + ">" + content + "</svg>";
}

// A drawing with all that its reader says of it.
inline Curve_file read_svg_file(const std::string& content, const Curve_file::Options& options = {}) {
  return Curve_file::from_text(svg(content), "shape.json", "shape", options);
}

inline Records read_svg(const std::string& content) { return read(svg(content)); }
inline Records read_path(const std::string& data) { return read_svg("<path d='" + data + "'/>"); }

inline std::string repeated(const std::string& text, int times) {
  std::string result;
  for (int i = 0; i < times; ++i) result += text;
  return result;
}

inline std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Input_error& error) {
    return error.what();
  }
  return "no error";
}

// The control polygon of a chain: the first point, then all but the first of every piece.
inline Points polygon(const Curve_record& record) {
  Points points{record.beziers.front().control_points().front()};
  for (const Bezier& piece : record.beziers)
    points.insert(points.end(), piece.control_points().begin() + 1, piece.control_points().end());
  return points;
}

inline void expect_joined(const Curve_record& record) {
  const auto pieces = record.bezier_pieces<double>();
  for (std::size_t i = 1; i < pieces.size(); ++i)
    EXPECT_EQ(std::memcmp(&pieces[i].control_points().front(), &pieces[i - 1].control_points().back(), sizeof(Point)),
              0)
        << record.name << ", piece " << i;
  if (!record.closed || record.type != Curve_record::PATH) return;
  const Point &start = pieces.front().control_points().front(), &end = pieces.back().control_points().back();
  EXPECT_EQ(std::memcmp(&start, &end, sizeof(Point)), 0) << record.name;
}

}  // namespace bounding_arcs_test

#endif
