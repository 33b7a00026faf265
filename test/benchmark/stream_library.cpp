// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a program takes that calls the library itself for the records of a stream: reads them by the library's readers
// and has their arcs, or their regions with thicknesses, in memory, where `arcs --stream` and `build --stream` write
// them, too.
// Usage: stream_library arcs|bca|sfa|bilens EPS < RECORDS     prints how many arcs or regions there are

#include <CGAL/Bounding_arcs_2.h>
#include <CGAL/Bounding_arcs_2/approximation/arc_chain.h>
#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>
#include <CGAL/Bounding_arcs_2/tree/Region_columns.h>

#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace ba = CGAL::Bounding_arcs;
using Kernel = CGAL::Circular_kernel_2<CGAL::Simple_cartesian<double>, CGAL::Algebraic_kernel_for_circles_2_2<double>>;
using Spirals = std::vector<ba::Bezier_spiral_2<double>>;

std::size_t arcs(const Spirals& spirals, double eps) { return ba::arc_chain(spirals, eps).arcs.size(); }

template <class Traits> std::size_t regions(Spirals&& spirals, double eps) {
  const ba::Bounding_arc_tree_2<Traits, ba::Bezier_spiral_2<double>> tree(std::move(spirals), eps);
  ba::Region_columns columns;
  ba::make_regions(tree, columns);
  double thickness = 0;
  tree.for_each_leaf([&](const ba::Node_handle& leaf) { thickness = std::fmax(thickness, tree.thickness(leaf)); });
  if (!(thickness <= eps)) throw std::runtime_error("eps was not reached");
  return tree.number_of_leaves();
}

std::size_t answer(const std::string& what, Spirals&& spirals, double eps) {
  if (what == "arcs") return arcs(spirals, eps);
  if (what == "bca") return regions<ba::Bca_traits_2<Kernel>>(std::move(spirals), eps);
  if (what == "sfa") return regions<ba::Spiral_fat_arc_traits_2<Kernel>>(std::move(spirals), eps);
  if (what == "bilens") return regions<ba::Bilens_traits_2<Kernel>>(std::move(spirals), eps);
  throw std::invalid_argument("usage: stream_library arcs|bca|sfa|bilens EPS < RECORDS");
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const std::string what = argc == 3 ? argv[1] : "";
    const double eps = argc == 3 ? std::stod(argv[2]) : 0;
    std::size_t lines = 0, parts = 0;
    std::ios::sync_with_stdio(false);
    for (std::string line; std::getline(std::cin, line); ++lines)
      for (const ba::Curve_record& record : ba::read_curves_from_text(line, "record", "curve")) {
        Spirals spirals;
        for (const auto& piece : ba::bezier_pieces<double>(record))
          for (auto& spiral : ba::spiral_segments(piece)) spirals.push_back(std::move(spiral));
        parts += answer(what, std::move(spirals), eps);
      }
    std::printf("%zu records, %zu %s\n", lines, parts, what == "arcs" ? "arcs" : "regions");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "stream_library: %s\n", error.what());
    return 1;
  }
}
