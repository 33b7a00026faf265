// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The spiral segments of the bundled curves, curve by curve.

#ifndef BOUNDING_ARCS_TEST_BUNDLED_SPIRALS_H
#define BOUNDING_ARCS_TEST_BUNDLED_SPIRALS_H

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>
#include <CGAL/Bounding_arcs_2/spiral/Bezier_spiral_2.h>

#include <filesystem>
#include <string>
#include <vector>

namespace bounding_arcs_test {

struct Bundled_curve {
  std::string name;
  std::vector<CGAL::Bounding_arcs::Bezier_spiral_2<double>> spirals;
};

inline const std::vector<Bundled_curve>& bundled_curves() {
  static const std::vector<Bundled_curve> all = [] {
    std::vector<Bundled_curve> curves;
    for (const auto& file : std::filesystem::directory_iterator(BOUNDING_ARCS_EXAMPLE_DATA)) {
      if (file.path().extension() != ".json") continue;
      for (const auto& record : CGAL::Bounding_arcs::read_curve_file(file.path().string()).curves) {
        curves.push_back({record.name, {}});
        for (const auto& piece : record.bezier_pieces<double>())
          for (const auto& s : CGAL::Bounding_arcs::spiral_segments(piece)) curves.back().spirals.push_back(s);
      }
    }
    return curves;
  }();
  return all;
}

}  // namespace bounding_arcs_test

#endif
