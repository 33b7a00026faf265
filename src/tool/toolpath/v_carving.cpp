// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "v_carving.h"

#include "../Commands.h"
#include "../number_text.h"
#include "../usage.h"
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

// Along the axis where discs are hardly larger than the bit may touch: a pocket that is thinner may be no chain of an
// inset.
constexpr double LEAST_POCKET = 0.25;  // of eps

using Samples = std::vector<ba::Medial_axis_2::Sample>;

// With the places where discs are as large as that, but for rounding.
Samples with_crossings(const Samples& samples, double radius) {
  constexpr double ROUNDING = 0x1p-40;  // of radii
  Samples result;
  for (ba::Medial_axis_2::Sample s : samples) {
    if (std::fabs(s.radius - radius) <= ROUNDING * s.radius) s.radius = radius;
    if (!result.empty() && (result.back().radius - radius) * (s.radius - radius) < 0) {
      ba::Medial_axis_2::Sample between = s;
      const double share = (radius - result.back().radius) / (s.radius - result.back().radius);
      between.center = result.back().center + share * (s.center - result.back().center);
      between.radius = radius;
      result.push_back(between);
    }
    result.push_back(s);
  }
  return result;
}
// Without the end of a way that goes on into a pocket at once, from where discs are as large as that.
void end_at_pocket(double radius, double most_length, Samples& samples) {
  double length = 0;
  std::size_t i = samples.size() - 1;
  for (; i > 0 && samples[i].radius > radius && length <= most_length; --i)
    length += ba::euclidean_norm(samples[i].center - samples[i - 1].center);
  if (samples[i].radius <= radius && length <= most_length) samples.resize(i + 1);
}
Samples way_of_bit(const Samples& samples, double radius, double least_pocket) {
  constexpr double STEEP = 4;  // the length of a way on which radii grow by 1
  Samples way = with_crossings(samples, radius);
  for (int end = 0; end < 2; ++end) {
    end_at_pocket(radius, STEEP * least_pocket, way);
    std::reverse(way.begin(), way.end());
  }
  return way;
}

std::vector<Tool_pass> branches_of(const ba::Medial_axis_2& axis, const V_bit& bit) {
  std::vector<Tool_pass> passes;
  std::vector<std::size_t> parts;
  const double least_pocket = LEAST_POCKET * axis.eps;
  for (const ba::Medial_axis_2::Branch& branch : ba::axis_branches(axis, bit.largest() + least_pocket)) {
    const Samples samples = way_of_bit(branch.samples, bit.largest(), least_pocket);
    Tool_pass pass{"carve"};
    const auto height = [&](const ba::Medial_axis_2::Sample& s) {
      return 0 - (std::min)(s.radius * bit.depth, bit.most);
    };
    for (const ba::Medial_axis_2::Sample& s : samples) {
      if (!pass.heights.empty()) pass.pieces.push_back({(&s)[-1].center, s.center, 0});
      pass.heights.push_back(height(s));
    }
    if (pass.pieces.empty()) {  // a disc alone is drilled
      const ba::Medial_axis_2::Sample& disc = samples.front();
      pass.pieces.push_back({disc.center, disc.center, 0});
      pass.heights.push_back(height(disc));
    }
    passes.push_back(std::move(pass));
    parts.push_back(branch.part);
  }
  return group_by_group(passes, parts);
}

double largest_radius(const ba::Medial_axis_2& axis) {
  double largest = 0;
  for (const ba::Medial_axis_2::Vertex& v : axis.vertices) largest = (std::max)(largest, v.radius);
  for (const ba::Medial_axis_2::Edge& e : axis.edges)
    for (const ba::Medial_axis_2::Sample& s : e.samples) largest = (std::max)(largest, s.radius);
  return largest;
}

void add_bottoms(V_carving& carving, const ba::Bounding_arc_tree_2& tree, const ba::Medial_axis_2& axis,
                 const V_bit& bit, double flat, const std::string& file) {
  constexpr double MOST = 1e4;  // passes within each other: some minutes of work
  const double radius = bit.largest(), largest = largest_radius(axis);
  if (!(largest > radius)) return;
  if (flat > 0 && (largest - radius) / (flat / 2) > MOST)
    throw Usage_error("--flat-tool", "a diameter that clears what is flat in 10000 passes", number(flat));
  ba::Offset::Options options;
  options.rule = axis.options.rule;
  const std::string place = "--max-depth " + number(bit.most);
  try {
    const ba::Offset_source_2 source(tree, axis.eps, options);
    const auto add_inset = [&](std::vector<Tool_pass>& passes, const char* title, double r) {
      const ba::Offset inset = source.at(-r);
      if (inset.status == ba::Offset::Status::RESOLUTION_REACHED)
        throw Input_error(file, place, below_resolution(axis.eps, inset.error));
      if (inset.status == ba::Offset::Status::UNRESOLVED)
        throw Input_error(file, place,
                          "at distance " + number(-r) +
                              " its parts touch in a way that cannot be told apart; change the depth a little");
      for (const ba::Offset::Chain& chain : inset.chains) {
        passes.push_back({title, {}, -bit.most});
        for (const ba::Offset::Piece& piece : chain.pieces) passes.back().pieces.push_back(piece.arc);
      }
    };
    add_inset(carving.pockets, "pocket", radius);
    for (double within = flat / 2; flat > 0 && radius + within < largest; within += flat / 2)
      add_inset(carving.flats, "flat", radius + within);
  } catch (const std::invalid_argument& error) {
    throw Input_error(file, "offset", error.what());
  }
}

}  // namespace

V_bit v_bit(double angle, double most) {
  constexpr double HALF_DEGREE = 3.14159265358979323846 / 360;
  V_bit bit;
  if (angle > 0) bit.depth = 1 / std::tan(angle * HALF_DEGREE);
  if (most > 0) bit.most = most;
  return bit;
}

std::vector<Tool_pass> V_carving::of_bit() const {
  std::vector<Tool_pass> passes = branches;
  passes.insert(passes.end(), pockets.begin(), pockets.end());
  return passes;
}

V_carving v_carving(const ba::Bounding_arc_tree_2& tree, const ba::Medial_axis_2& axis, const V_bit& bit, double flat,
                    const std::string& file) {
  V_carving carving{branches_of(axis, bit), {}, {}};
  add_bottoms(carving, tree, axis, bit, flat, file);
  carving.pockets = inside_out(carving.pockets, carving.branches.empty() ? Xy<double>{} : carving.branches.back().to());
  carving.flats = inside_out(carving.flats);
  return carving;
}

}  // namespace bounding_arcs_tool
