// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the reader makes of drawings, as JSON: a line a file, for compare.sh.
// Usage: svg_outlines FILES

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>

#include <nlohmann/json.hpp>

#include <iostream>

using namespace CGAL::Bounding_arcs;

int main(int argc, char** argv) try {
  for (int i = 1; i < argc; ++i) {
    nlohmann::json curves = nlohmann::json::array();
    for (const Curve_record& record : read_curve_file(argv[i]).curves) {
      nlohmann::json pieces = nlohmann::json::array();
      for (const Bezier_curve_2<double>& bezier : record.beziers) {
        nlohmann::json points = nlohmann::json::array();
        for (const Xy<double>& p : bezier.control_points()) points.push_back({p.x, p.y});
        pieces.push_back({{"points", points}, {"weights", bezier.weights()}});
      }
      curves.push_back({{"name", record.name}, {"closed", record.closed}, {"pieces", pieces}});
    }
    std::cout << nlohmann::json{{"file", argv[i]}, {"curves", curves}}.dump() << '\n';
  }
} catch (const Input_error& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
