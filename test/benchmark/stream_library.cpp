// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a program takes that calls the library itself for the records of a stream: reads them by the library's readers
// and has their arcs, or their regions with thicknesses, in memory, where `arcs --stream` and `build --stream` write
// them, too.  With --print it writes the members of all arcs and regions as these do, with the same digits.
// Usage: stream_library arcs|bca|sfa|bilens EPS [--print] < RECORDS

#include "number_text.h"

#include <CGAL/Bounding_arcs_2.h>
#include <CGAL/Bounding_arcs_2/chain/arc_chain.h>
#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>
#include <CGAL/Bounding_arcs_2/tree/Region_columns.h>
#include <CGAL/Bounding_arcs_2/tree/Region_reader.h>

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

class Printer {
 public:
  explicit Printer(bool is_on) : is_on_(is_on) {}
  [[nodiscard]] bool is_on() const { return is_on_; }
  void add(const char* text) { text_ += text; }
  void add(double x) { bounding_arcs_tool::add_number(text_, x); }
  void add(const char* key, const ba::Xy<double>& p) {
    add(key);
    add(p.x);
    add(",");
    add(p.y);
    add("]");
  }
  void add_arc(const ba::Xy<double>& from, const ba::Xy<double>& to, double b) {
    const ba::Arc_2 arc{from, to, b};
    add(b == 0 ? "{\"type\":\"segment\"" : "{\"type\":\"arc\"");
    add(",\"from\":[", from);
    add(",\"to\":[", to);
    if (b == 0) return;
    add(",\"bulge\":");
    add(b);
    add(",\"center\":[", ba::center(arc));
    add(",\"radius\":");
    add(ba::radius(arc));
    add(b > 0 ? ",\"orientation\":\"ccw\"" : ",\"orientation\":\"cw\"");
  }
  void add_side(const ba::Arc_region_2& region, const ba::Arc_region_2::Side& side) {
    add_arc(region.from, side.size == 2 ? side.joint : region.to, side.bulges[0]);
    if (side.size == 2) {
      add("},");
      add_arc(side.joint, region.to, side.bulges[1]);
    }
  }
  void add_piece(std::size_t bezier, double t0, double t1) {
    add("\"bezier\":");
    text_ += std::to_string(bezier);
    add(",\"t\":[");
    add(t0);
    add(",");
    add(t1);
    add("]");
  }
  void end_line() {
    text_ += '\n';
    std::fwrite(text_.data(), 1, text_.size(), stdout);
    text_.clear();
  }

 private:
  bool is_on_;
  std::string text_;
};

std::size_t arcs(const Spirals& spirals, double eps, Printer& printer) {
  const ba::Arc_chain chain = ba::arc_chain(spirals, eps);
  if (printer.is_on())
    for (const ba::Arc_chain::Arc& arc : chain.arcs) {
      printer.add_arc(arc.from, arc.to, arc.bulge);
      printer.add(",");
      printer.add_piece(spirals[arc.spiral].place().bezier, arc.t0, arc.t1);
      printer.add(",\"error\":");
      printer.add(arc.error);
      printer.add("},");
    }
  return chain.arcs.size();
}

template <class Traits> std::size_t regions(Spirals&& spirals, double eps, Printer& printer) {
  const ba::Region_hierarchy_2<Traits, ba::Bezier_spiral_2<double>> tree(std::move(spirals), eps);
  double thickness = 0;
  const auto see = [&](const ba::Node_handle& leaf) {
    const double of_leaf = tree.thickness(leaf);
    thickness = std::fmax(thickness, of_leaf);
    return of_leaf;
  };
  if (printer.is_on()) {
    ba::Region_reader(tree).for_each_leaf([&](const ba::Node_handle& leaf, const ba::Arc_region_2& region) {
      const ba::Region_node node = tree.node(leaf);
      printer.add("{");
      printer.add_piece(tree.spirals()[node.spiral].place().bezier, node.t0, node.t1);
      printer.add(",\"thickness\":");
      printer.add(see(leaf));
      printer.add(",\"inner\":[");
      printer.add_side(region, region.inner);
      printer.add("}],\"outer\":[");
      printer.add_side(region, region.outer);
      printer.add("}]},");
    });
  } else {
    ba::Region_columns columns;
    ba::make_regions(tree, columns);
    tree.for_each_leaf(see);
  }
  if (!(thickness <= eps)) throw std::runtime_error("eps was not reached");
  return tree.number_of_leaves();
}

std::size_t answer(const std::string& what, Spirals&& spirals, double eps, Printer& printer) {
  if (what == "arcs") return arcs(spirals, eps, printer);
  if (what == "bca") return regions<ba::Bca_traits_2<Kernel>>(std::move(spirals), eps, printer);
  if (what == "sfa") return regions<ba::Spiral_fat_arc_traits_2<Kernel>>(std::move(spirals), eps, printer);
  if (what == "bilens") return regions<ba::Bilens_traits_2<Kernel>>(std::move(spirals), eps, printer);
  throw std::invalid_argument("usage: stream_library arcs|bca|sfa|bilens EPS [--print] < RECORDS");
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const bool is_complete = argc == 3 || (argc == 4 && argv[3] == std::string("--print"));
    const std::string what = is_complete ? argv[1] : "";
    const double eps = is_complete ? std::stod(argv[2]) : 0;
    Printer printer(argc == 4);
    std::size_t lines = 0, parts = 0;
    std::ios::sync_with_stdio(false);
    for (std::string line; std::getline(std::cin, line); ++lines)
      for (const ba::Curve_record& record : ba::Curve_file::from_text(line, "record", "curve").curves) {
        Spirals spirals;
        for (const auto& piece : record.bezier_pieces<double>())
          for (auto& spiral : ba::spiral_segments(piece)) spirals.push_back(std::move(spiral));
        parts += answer(what, std::move(spirals), eps, printer);
        if (printer.is_on()) printer.end_line();
      }
    std::fprintf(stderr, "%zu records, %zu %s\n", lines, parts, what == "arcs" ? "arcs" : "regions");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "stream_library: %s\n", error.what());
    return 1;
  }
}
