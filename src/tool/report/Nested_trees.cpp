// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Nested_trees.h"

#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace bounding_arcs_tool {
namespace {

// The leaves of one tolerance, and the first of them that no node was found to be.
struct Leaves {
  struct Piece {
    std::size_t bezier;
    double t0, t1;
  };
  std::vector<Piece> pieces;
  std::size_t next = 0;

  [[nodiscard]] bool take(const Output_region& region) {
    if (next == pieces.size()) return false;
    const Piece& piece = pieces[next];
    const bool is_same = piece.bezier == region.bezier && piece.t0 == region.t0 && piece.t1 == region.t1;
    next += is_same;
    return is_same;
  }
};

double size_of(const Output_region& region) {
  const Xy<double>&from = region.outer.front().from, &to = region.outer.back().to;
  return std::hypot(to.x - from.x, to.y - from.y);
}

// A bulge, or the joints and then the bulges of several pieces.
std::string chain_json(const Page_scale& scale, const Output_chain& chain) {
  if (chain.size() == 1) return scale.bulge(chain[0]);
  std::string joints = "[", bulges;
  for (const Arc_2& piece : chain) {
    bulges += (bulges.empty() ? "" : ",") + scale.bulge(piece);
    if (&piece != &chain.back()) joints += scale.point(piece.to) + ",";
  }
  return joints + bulges + "]";
}

}  // namespace

Nested_trees::Nested_trees(const Loaded_curve& curve, Method method, const std::vector<double>& eps,
                           const Options& options) {
  std::vector<Leaves> leaves(eps.size());
  std::unique_ptr<Curve_hierarchy> hierarchy;
  for (std::size_t e = 0; e < eps.size(); ++e) {
    hierarchy = build_hierarchy(curve, method, eps[e], options);
    hierarchy->for_each_region([&](const Output_region& region) {
      leaves[e].pieces.push_back({region.bezier, region.t0, region.t1});
    });
  }
  std::vector<std::size_t> above;  // nodes whose last one below was not yet seen
  const auto close = [&](std::size_t level) {
    for (; above.size() > level; above.pop_back()) nodes_[above.back()].end = nodes_.size();
  };
  hierarchy->for_each_node([&](std::size_t level, const Output_region& region) {
    int leaf = -1;
    for (std::size_t e = 0; e < eps.size(); ++e)
      if (leaves[e].take(region)) leaf = static_cast<int>(e);
    close(level);
    above.push_back(nodes_.size());
    nodes_.push_back({level, leaf, 0, region});
  });
  close(0);
  for (const Leaves& some : leaves)
    if (some.next != some.pieces.size()) throw std::logic_error("trees of two tolerances are not nested");
}

std::string Nested_trees::ends_json(const Page_scale& scale) const {
  std::string out;
  for (const Nested_node& node : nodes_)
    if (node.level == 0)
      out += (out.empty() ? "[" : ",") + scale.point(node.region.outer.front().from) + "," +
             scale.point(node.region.outer.back().to);
  return out.empty() ? "[]" : out + "]";
}

std::string Nested_trees::nodes_json(const Page_scale& scale) const {
  std::string out;
  char head[60];
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const Nested_node& node = nodes_[i];
    std::snprintf(head, sizeof head, "%c%d,%.3g,", i == 0 ? '[' : ',', node.leaf, node.region.thickness);
    out += head + chain_json(scale, node.region.inner) + "," + chain_json(scale, node.region.outer);
    if (node.end > i + 1) out += "," + scale.point(nodes_[i + 1].region.outer.back().to);
  }
  return out.empty() ? "[]" : out + "]";
}

void Nested_trees::add_halvings(std::vector<Halvings>& levels) const {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (nodes_[i].end == i + 1) continue;
    const Output_region* pieces[] = {&nodes_[i].region, &nodes_[i + 1].region, &nodes_[nodes_[i + 1].end].region};
    double size[3], thickness[3];
    bool tells = true;
    for (int k = 0; k < 3; ++k) {
      size[k] = std::log(size_of(*pieces[k]));
      thickness[k] = std::log(pieces[k]->thickness);
      tells = tells && std::isfinite(size[k]) && std::isfinite(thickness[k]);
    }
    if (!tells) continue;
    if (levels.size() <= nodes_[i].level) levels.resize(nodes_[i].level + 1);
    Halvings& sums = levels[nodes_[i].level];
    ++sums.count;
    sums.size += size[0];
    sums.thickness += thickness[0];
    sums.size_change += (size[1] + size[2]) / 2 - size[0];
    sums.thickness_change += (thickness[1] + thickness[2]) / 2 - thickness[0];
  }
}

}  // namespace bounding_arcs_tool
