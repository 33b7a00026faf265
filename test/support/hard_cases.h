// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The list of hard cases in data/queries, each a file of two drawings with what is known of them by thought: "first"
// curves are drawing a, the others drawing b, and "expected" may have
//   common [[x, y, kind]...], overlaps n     of a with b;   self n     points that a passes more than once
//   distance d, hausdorff d                  of a and b
//   closest [[x, y, d]...], locate [[x, y, winding or null on a curve, side]...],
//   area, length, diameter, width, circle    of both together; `circle` is the radius of the smallest one about them
// Scaled by powers of two and, where coordinates have room for it, moved far away, all of that stays exact.

#ifndef BOUNDING_ARCS_TEST_HARD_CASES_H
#define BOUNDING_ARCS_TEST_HARD_CASES_H

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>
#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

namespace bounding_arcs_test {

/// p, times a scale, moved.
struct Case_placing {
  double scale = 1, x = 0, y = 0;
  CGAL::Bounding_arcs::Xy<double> operator()(double px, double py) const { return {scale * px + x, scale * py + y}; }
};
inline constexpr Case_placing CASE_PLACINGS[] = {
    {}, {0x1p-30, 0, 0}, {0x1p30, 0, 0}, {1, 0x1p27, -0x1p27}};  // sizes 1e-9 and 1e9, and 1e8 sizes away

struct Hard_case {
  std::string name;
  Case_placing at;
  nlohmann::json expected;
  CGAL::Bounding_arcs::Drawing_2<double> a, b, both;
  std::vector<CGAL::Bounding_arcs::Curve_record> records;  ///< of both, not placed
  std::size_t first = 0;                                   ///< of these are a
};

/// \return whether no coordinate was rounded
inline bool place(const CGAL::Bounding_arcs::Drawing_2<double>& drawing, const Case_placing& at,
                  CGAL::Bounding_arcs::Drawing_2<double>& result) {
  bool is_exact = true;
  for (const auto& curve : drawing.curves()) {
    std::vector<CGAL::Bounding_arcs::Bezier_curve_2<double>> chain;
    for (const auto& piece : curve.beziers) {
      std::vector<CGAL::Bounding_arcs::Xy<double>> points;
      for (const auto& p : piece.control_points()) {
        points.push_back(at(p.x, p.y));
        is_exact = is_exact && points.back().x - at.x == at.scale * p.x && points.back().y - at.y == at.scale * p.y;
      }
      chain.emplace_back(std::move(points), piece.weights());
    }
    result.add(std::move(chain), curve.name);
  }
  return is_exact;
}

inline std::vector<Hard_case> hard_cases(const Case_placing& at) {
  namespace ba = CGAL::Bounding_arcs;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(BOUNDING_ARCS_TEST_DATA "/queries"))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<Hard_case> cases;
  for (const auto& file : files) {
    const nlohmann::json document = nlohmann::json::parse(std::ifstream(file));
    Hard_case c;
    c.name = file.stem().string();
    c.at = at;
    c.expected = document.at("expected");
    c.first = document.at("first").get<std::size_t>();
    c.records = ba::read_curve_file(file.string()).curves;
    const auto middle = c.records.begin() + static_cast<std::ptrdiff_t>(c.first);
    const bool is_exact = place(ba::drawing<double>({c.records.begin(), middle}), at, c.a) &&
                          place(ba::drawing<double>({middle, c.records.end()}), at, c.b) &&
                          place(ba::drawing<double>(c.records), at, c.both);
    if (is_exact) cases.push_back(std::move(c));
  }
  return cases;
}

}  // namespace bounding_arcs_test

#endif
