// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Tool_pass.h"

#include <algorithm>
#include <utility>

namespace bounding_arcs_tool {

Tool_pass reversed(Tool_pass pass) {
  std::reverse(pass.pieces.begin(), pass.pieces.end());
  for (Arc_2& piece : pass.pieces) piece = {piece.to, piece.from, 0 - piece.bulge};  // 0 stays 0
  std::reverse(pass.heights.begin(), pass.heights.end());
  return pass;
}

Tool_pass started_at(Tool_pass pass, std::size_t piece) {
  const auto step = static_cast<std::ptrdiff_t>(piece);
  std::rotate(pass.pieces.begin(), pass.pieces.begin() + step, pass.pieces.end());
  if (pass.heights.empty()) return pass;
  pass.heights.pop_back();  // which is the first one
  std::rotate(pass.heights.begin(), pass.heights.begin() + step, pass.heights.end());
  pass.heights.push_back(pass.heights.front());
  return pass;
}

std::vector<Tool_pass> passes_of(const std::string& title, double height, const std::vector<Arc_2>& pieces) {
  std::vector<Tool_pass> passes;
  for (const Arc_2& piece : pieces) {
    if (passes.empty() || passes.back().to() != piece.from) passes.push_back({title, {}, height});
    passes.back().pieces.push_back(piece);
  }
  return passes;
}

}  // namespace bounding_arcs_tool
