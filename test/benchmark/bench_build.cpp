// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Builds of the bundled curves by method, tolerance and kernel, beside the textbook's recursion.

#include "arcs.h"
#include "closest.h"
#include "curves.h"
#include "scaling.h"
#include "textbook_recursion.h"

#include <CGAL/Bounding_arcs_2/tree/Region_columns.h>

#include <cstdio>

namespace {

using namespace bounding_arcs_benchmark;

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", x);
  return text;
}

template <class Node> std::string textbook_name(double eps) {
  return Node::NAME + std::string(", textbook recursion, ") + number(eps);
}

template <class Node> void add_textbook(double eps) {
  add_row(textbook_name<Node>(eps), "", [=](benchmark::State& state) {
    std::vector<Cubic> cubics;
    for (const Spiral& s : bundled_spirals()) cubics.emplace_back(s.curve());
    using Recursion = Textbook_recursion<Node>;
    static Recursion recursion;
    const auto make = [&](const std::vector<Spiral>& spirals) {
      recursion.start(eps);
      for (std::size_t i = 0; i < spirals.size(); ++i) recursion.add(cubics[i], spirals[i].first(), spirals[i].last());
      return &recursion;
    };
    time_builds(state, bundled_spirals(), make, [&](const Recursion* r) {
      state.counters[REGIONS] = static_cast<double>(r->leaves());
      state.counters[BYTES] = static_cast<double>(r->nodes().size() * sizeof(typename Recursion::Node));
    });
  });
}

template <class Traits>
void add_build(const std::string& what, double eps, const std::string& reference,
               const ba::Build_options& options = {}) {
  using Tree = ba::Region_hierarchy_2<Traits, Spiral>;
  add_row(what + ", " + number(eps), reference, [=](benchmark::State& state) {
    time_builds(
        state, bundled_spirals(), [&](std::vector<Spiral> spirals) { return Tree(std::move(spirals), eps, options); },
        [&](const Tree& tree) {
          state.counters[REGIONS] = static_cast<double>(tree.number_of_leaves());
          state.counters[BYTES] = static_cast<double>(tree.bytes());
        });
  });
}

// From segments to the arcs of all leaves in memory that was used before, as the textbook's is.
template <class Traits, class Node> void add_regions(double eps) {
  const std::string method = Node::NAME, reference = textbook_name<Node>(eps);
  add_textbook<Node>(eps);
  using Tree = ba::Region_hierarchy_2<Traits, Spiral>;
  add_row(method + " with arcs, " + number(eps), reference, [=](benchmark::State& state) {
    static ba::Region_columns columns;
    time_builds(
        state, bundled_spirals(),
        [&](std::vector<Spiral> spirals) {
          const Tree tree(std::move(spirals), eps);
          ba::make_regions(tree, columns);
          return tree.number_of_leaves();
        },
        [&](std::size_t leaves) { state.counters[REGIONS] = static_cast<double>(leaves); });
  });
}

void add_builds() {
  ba::Build_options keep, base, avx2;
  keep.keep_thickness = true;
  base.instruction_set = ba::Build_options::Instruction_set::BASE;
  avx2.instruction_set = ba::Build_options::Instruction_set::AVX2;
  for (const double eps : {1e-3, 1e-4, 1e-5, 1e-6, 1e-8, 1e-10}) {
    const std::string textbook = textbook_name<Textbook_bca_node>(eps), bca = "bca, " + number(eps);
    add_regions<ba::Bca_traits_2<Double>, Textbook_bca_node>(eps);
    add_regions<ba::Spiral_fat_arc_traits_2<Double>, Textbook_sfa_node>(eps);
    add_regions<ba::Bilens_traits_2<Double>, Textbook_bilens_node>(eps);
    add_build<ba::Bca_traits_2<Double>>("bca", eps, textbook);
    add_build<ba::Bca_traits_2<Double>>("bca, thickness of all nodes kept", eps, textbook, keep);
    add_build<ba::Spiral_fat_arc_traits_2<Double>>("sfa", eps, bca);
    add_build<ba::Bilens_traits_2<Double>>("bilens", eps, bca);
    add_build<ba::Bca_traits_2<Filtered>>("bca, filtered kernel", eps, bca);
    add_build<ba::Spiral_fat_arc_traits_2<Filtered>>("sfa, filtered kernel", eps, "sfa, " + number(eps));
    add_build<ba::Bilens_traits_2<Filtered>>("bilens, filtered kernel", eps, "bilens, " + number(eps));
  }
  add_build<ba::Bca_traits_2<Double>>("bca, AVX2 at most", 1e-10, "bca, 1e-10", avx2);
  add_build<ba::Bca_traits_2<Double>>("bca, no wide registers", 1e-10, "bca, 1e-10", base);
}

}  // namespace

int main(int argc, char** argv) {
  add_builds();
  add_arcs();
  add_scaling();
  add_closest();
  // repetitions of all rows in random order: a slow minute of the machine then meets rows and their references alike
  std::string interleaved = "--benchmark_enable_random_interleaving=true";
  std::vector<char*> arguments(argv, argv + argc);
  arguments.insert(arguments.begin() + 1, interleaved.data());
  argc = static_cast<int>(arguments.size());
  argv = arguments.data();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  Table_reporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  return 0;
}
