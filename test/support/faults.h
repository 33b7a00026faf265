// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is wrong with a case of many, and drawings as files for the tool.

#ifndef BOUNDING_ARCS_TEST_FAULTS_H
#define BOUNDING_ARCS_TEST_FAULTS_H

#include "query_drawings.h"

#include <nlohmann/json.hpp>

#include <stdexcept>
#include <string>

namespace bounding_arcs_test {

/// What is wrong with a case: a word or two for its kind, a colon, and more.
struct Fault : std::runtime_error {
  Fault(const std::string& kind, const std::string& what) : std::runtime_error(kind + ": " + what) {}
};

inline CGAL::Bbox_2 box_of(const Drawing& drawing) {
  CGAL::Bbox_2 box;
  for (const auto& c : drawing.curves())
    for (const Bezier& b : c.beziers)
      for (const Point& p : b.control_points()) box += CGAL::Bbox_2(p.x, p.y, p.x, p.y);
  return box;
}

/// A drawing as a curve file, which the tool reads.
inline std::string json_text(const Drawing& drawing) {
  nlohmann::json curves = nlohmann::json::array();
  for (const auto& curve : drawing.curves()) {
    nlohmann::json pieces = nlohmann::json::array();
    for (const Bezier& b : curve.beziers) {
      nlohmann::json points = nlohmann::json::array();
      for (const Point& p : b.control_points()) points.push_back({p.x, p.y});
      pieces.push_back({{"control_points", points}});
      if (b.is_rational()) pieces.back()["weights"] = b.weights();
    }
    curves.push_back({{"type", "path"}, {"pieces", pieces}});
  }
  return nlohmann::json{{"curves", curves}}.dump();
}

}  // namespace bounding_arcs_test

#endif
