// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "v_carving.h"

#include "../Commands.h"
#include "../number_text.h"
#include "order_passes.h"

#include <CGAL/Bounding_arcs_2/medial_axis/axis_branches.h>
#include <CGAL/Bounding_arcs_2/offset/Offset_source_2.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace bounding_arcs_tool {
namespace {

namespace ba = CGAL::Bounding_arcs;

std::vector<Tool_pass> branches_of(const ba::Medial_axis_2& axis, const V_bit& bit) {
  std::vector<Tool_pass> passes;
  std::vector<std::size_t> parts;
  for (const ba::Axis_branch& branch : ba::axis_branches(axis, bit.largest())) {
    Tool_pass pass{"carve"};
    const auto height = [&](const ba::Medial_sample& s) { return 0 - (std::min)(s.radius * bit.depth, bit.most); };
    for (const ba::Medial_sample& s : branch.samples) {
      if (!pass.heights.empty()) pass.pieces.push_back({(&s)[-1].center, s.center, 0});
      pass.heights.push_back(height(s));
    }
    if (pass.pieces.empty()) {  // a disc alone is drilled
      const ba::Medial_sample& disc = branch.samples.front();
      pass.pieces.push_back({disc.center, disc.center, 0});
      pass.heights.push_back(height(disc));
    }
    passes.push_back(std::move(pass));
    parts.push_back(branch.part);
  }
  return group_by_group(passes, parts);
}

ba::Offset inset_at(const ba::Bounding_arc_tree_2& tree, double radius, double eps, const ba::Offset_options& options,
                    const std::string& file) {
  try {
    return ba::offset(tree, -radius, eps, options);
  } catch (const std::invalid_argument& error) {
    throw Input_error(file, "offset", error.what());
  }
}

std::vector<Tool_pass> pockets_of(const ba::Bounding_arc_tree_2& tree, const ba::Medial_axis_2& axis, const V_bit& bit,
                                  const std::string& file) {
  const double radius = bit.largest();
  const auto is_deeper = [&](const ba::Medial_vertex& v) { return v.radius > radius; };
  const bool has_deeper =
      std::any_of(axis.vertices.begin(), axis.vertices.end(), is_deeper) ||
      std::any_of(axis.edges.begin(), axis.edges.end(), [&](const ba::Medial_edge& e) {
        return std::any_of(e.samples.begin(), e.samples.end(), [&](const auto& s) { return s.radius > radius; });
      });
  if (!has_deeper) return {};
  ba::Offset_options options;
  options.rule = axis.options.rule;
  const std::string place = "--max-depth " + number(bit.most);
  const ba::Offset inset = inset_at(tree, radius, axis.eps, options, file);
  if (inset.status == ba::Offset_status::RESOLUTION_REACHED)
    throw Input_error(file, place, below_resolution(axis.eps, inset.error));
  if (inset.status == ba::Offset_status::UNRESOLVED)
    throw Input_error(file, place,
                      "at distance " + number(-radius) +
                          " its parts touch in a way that cannot be told apart; change the depth a little");
  std::vector<Tool_pass> passes;
  for (const ba::Offset_chain& chain : inset.chains) {
    passes.push_back({"pocket", {}, -bit.most});
    for (const ba::Offset_piece& piece : chain.pieces) passes.back().pieces.push_back(piece.arc);
  }
  return passes;
}

}  // namespace

V_bit v_bit(double angle, double most) {
  constexpr double HALF_DEGREE = 3.14159265358979323846 / 360;
  V_bit bit;
  if (angle > 0) bit.depth = 1 / std::tan(angle * HALF_DEGREE);
  if (most > 0) bit.most = most;
  return bit;
}

V_carving v_carving(const ba::Bounding_arc_tree_2& tree, const ba::Medial_axis_2& axis, const V_bit& bit,
                    const std::string& file) {
  V_carving carving{branches_of(axis, bit), pockets_of(tree, axis, bit, file)};
  carving.pockets = inside_out(carving.pockets, carving.branches.empty() ? Xy<double>{} : carving.branches.back().to());
  return carving;
}

}  // namespace bounding_arcs_tool
