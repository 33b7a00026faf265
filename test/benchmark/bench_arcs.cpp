// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Chains of few arcs beside plain biarcs, and optimal beside midpoint splits, on the bundled curves.

#include "arcs.h"

#include "curves.h"
#include "plain_biarcs.h"

#include <CGAL/Bounding_arcs_2/chain/arc_chain.h>

namespace bounding_arcs_benchmark {
namespace {

void add_plain(const std::string& name, double eps) {
  add_row(name, "", [=](benchmark::State& state) {
    std::vector<Cubic> cubics;
    for (const Bezier& curve : bundled_beziers()) cubics.emplace_back(curve);
    const auto make = [&](const std::vector<Spiral>&) {
      Plain_biarcs biarcs(eps);
      for (const Cubic& c : cubics) biarcs.add(c, 0, 1);
      return biarcs.arcs();
    };
    time_builds(state, bundled_spirals(), make,
                [&](std::size_t arcs) { state.counters[REGIONS] = static_cast<double>(arcs); });
  });
}

void add_chain(const std::string& name, const std::string& reference, ba::Arc_chain::Continuity continuity,
               double eps) {
  add_row(name, reference, [=](benchmark::State& state) {
    time_builds(
        state, bundled_spirals(),
        [&](const std::vector<Spiral>& spirals) {
          return ba::arc_chain(spirals, eps, {continuity, ba::Arc_chain::Side::BOTH});
        },
        [&](const ba::Arc_chain& chain) { state.counters[REGIONS] = static_cast<double>(chain.arcs.size()); });
  });
}

template <class Traits> void add_optimal(const std::string& method, double eps, const std::string& eps_name) {
  using Tree = ba::Region_hierarchy_2<Traits, Spiral>;
  ba::Build_options options;
  options.nodes = ba::Build_options::Nodes::EQUALIZED;
  add_row(method + ", optimal, " + eps_name, method + ", " + eps_name, [=](benchmark::State& state) {
    time_builds(
        state, bundled_spirals(), [&](std::vector<Spiral> spirals) { return Tree(std::move(spirals), eps, options); },
        [&](const Tree& tree) {
          state.counters[REGIONS] = static_cast<double>(tree.number_of_leaves());
          state.counters[BYTES] = static_cast<double>(tree.bytes());
        });
  });
}

}  // namespace

void add_arcs() {
  for (const char* text : {"1e-05", "1e-08"}) {
    const double eps = std::atof(text);
    const std::string plain = std::string("arcs, plain biarcs, ") + text;
    add_plain(plain, eps);
    add_chain(std::string("arcs, common tangents, ") + text, plain, ba::Arc_chain::Continuity::TANGENT, eps);
    add_chain(std::string("arcs, only meeting, ") + text, plain, ba::Arc_chain::Continuity::POSITION, eps);
  }
  add_optimal<ba::Bca_traits_2<Double>>("bca", 1e-8, "1e-08");
  add_optimal<ba::Spiral_fat_arc_traits_2<Double>>("sfa", 1e-8, "1e-08");
  add_optimal<ba::Bilens_traits_2<Double>>("bilens", 1e-8, "1e-08");
}

}  // namespace bounding_arcs_benchmark
